"""Lines that a machine follows: areas without the seams inside them, lines cut where they leave a region."""

from collections import defaultdict
from collections.abc import Iterator
from itertools import pairwise

from tilewright.errors import TilewrightValueError
from tilewright.export.drawing.shapes import Path, Step, Steps

Point = tuple[float, float]


def without_seams(path: Path) -> Steps:
    """The outline of a path, in which rectangles that touch are one area; other paths stay as they are.

    Of sides that run along each other in opposite ways, the common parts are gone.
    """
    steps = path.steps
    count = sum(step.kind == "M" for step in steps)
    if path.stroke or count < 2 or not _is_square(steps):
        return steps
    edges: dict[tuple[bool, float], dict[float, int]] = defaultdict(lambda: defaultdict(int))
    for a, b in _sides(steps):
        upright = a[0] == b[0]
        along, line = (1, edges[True, a[0]]) if upright else (0, edges[False, a[1]])
        line[a[along]] += 1
        line[b[along]] -= 1
    return tuple(_linked(edges))


def clipped(path: Path, region: Steps) -> Steps:
    """What of straight lines lies inside a region whose sides run along x and y."""
    if path.fill:
        raise TilewrightValueError(
            "a DXF holds lines, and cannot cut bricks at the sides of a region; draw the wall's lines"
        )
    sides = list(_sides(region))
    found: list[Step] = []
    for a, b in _sides(path.steps):
        at = sorted({0.0, 1.0, *_crossings(a, b, sides)})
        for low, high in pairwise(at):
            if _is_inside(_between(a, b, (low + high) / 2), sides):
                found += [Step("M", *_between(a, b, low)), Step("L", *_between(a, b, high))]
    return tuple(_joined(found))


def _is_square(steps: Steps) -> bool:
    """Whether all is made of closed straight lines along x and y."""
    return all(a[0] == b[0] or a[1] == b[1] for a, b in _sides(steps)) and not any(s.turn for s in steps)


def _sides(steps: Steps) -> Iterator[tuple[Point, Point]]:
    for before, step in pairwise(steps):
        if step.kind != "M" and (before.x, before.y) != (step.x, step.y):
            yield (before.x, before.y), (step.x, step.y)


def _linked(edges: dict[tuple[bool, float], dict[float, int]]) -> Iterator[Step]:
    """Outlines from the sides that are left; where two areas touch at a corner, each keeps its own."""
    after: dict[Point, list[Point]] = defaultdict(list)
    for (upright, at), changes in edges.items():
        level = 0
        for low, high in pairwise(sorted(place for place, change in changes.items() if change)):
            level += changes[low]
            ends = ((at, low), (at, high)) if upright else ((low, at), (high, at))
            if level:
                start, end = ends if level > 0 else ends[::-1]
                after[start].append(end)
    while after:
        start = here = next(iter(after))
        way: Point | None = None
        yield Step("M", *start)
        while True:
            ways = after[here]
            there = ways.pop(_sharpest(here, way, ways))
            if not ways:
                del after[here]
            way = (there[0] - here[0], there[1] - here[1])
            here = there
            if here == start:
                break
            yield Step("L", *here)
        yield Step("Z", *start)


def _sharpest(here: Point, way: Point | None, ends: list[Point]) -> int:
    """Which way on turns to the inside, to the right of clockwise sides."""
    if way is None or len(ends) == 1:
        return 0
    turns = [way[0] * (y - here[1]) - way[1] * (x - here[0]) for x, y in ends]
    return turns.index(max(turns))


def _crossings(a: Point, b: Point, sides: list[tuple[Point, Point]]) -> Iterator[float]:
    """Where a line meets the lines of sides, from 0 at a to 1 at b."""
    for start, end in sides:
        axis = 0 if start[0] == end[0] else 1
        if a[axis] != b[axis]:
            place = (start[axis] - a[axis]) / (b[axis] - a[axis])
            low, high = sorted((start[1 - axis], end[1 - axis]))
            if 0 < place < 1 and low <= _between(a, b, place)[1 - axis] <= high:
                yield place


def _between(a: Point, b: Point, share: float) -> Point:
    return a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])


def _is_inside(point: Point, sides: list[tuple[Point, Point]]) -> bool:
    """By the sides that a way to the east crosses; clockwise and back cancel (the nonzero rule)."""
    winding = 0
    for (x, top), (_, bottom) in sides:
        if min(top, bottom) <= point[1] < max(top, bottom) and x > point[0]:
            winding += 1 if bottom > top else -1
    return winding != 0


def _joined(steps: list[Step]) -> Iterator[Step]:
    """Lines without the beginnings where the last one ended."""
    last: Step | None = None
    for step in steps:
        if last is None or step.kind != "M" or (step.x, step.y) != (last.x, last.y):
            yield step
        last = step
