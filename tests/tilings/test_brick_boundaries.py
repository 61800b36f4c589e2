"""Brick walls in regions with a given boundary: every small boundary, random regions, refusals."""

import numpy as np
import pytest

from tilewright.errors import TilewrightError
from tilewright.tiles.bricks import brick_tiles
from tilewright.tilings.bricks import brick_region
from tilewright.tilings.bricks.parts import find_links, find_parts, gather_parts
from tilewright.tilings.clauses import Clauses

# Boundaries of w x h rectangles that no wall meets, of all there are: two positions, and three. From an
# exhaustive search with a program of its own.
UNSOLVABLE = {
    (2, 1, 1): (8, 16),
    (2, 2, 1): (32, 64),
    (2, 2, 2): (128, 256),
    (2, 3, 2): (512, 1024),
    (2, 3, 3): (2048, 4096),
    (2, 4, 3): (8192, 16384),
    (2, 4, 4): (32768, 65536),
    (3, 2, 1): (324, 729),
    (3, 3, 1): (2268, 6561),
    (3, 2, 2): (0, 6561),
    (3, 3, 2): (0, 59049),
}


def all_boxes(n, w, h):
    """Boxes of w x h cells side by side, one with every boundary: mask, horizontal, vertical, box numbers."""
    sides = 2 * (w + h)
    count = n**sides
    digits = np.arange(count)[:, None] // n ** np.arange(sides) % n
    mask = np.zeros((h + 1, count, w + 1), bool)
    mask[:h, :, :w] = True
    horizontal, vertical = np.full((2, h + 1, count, w + 1), -1)
    horizontal[0, :, :w], horizontal[h, :, :w] = digits[:, :w], digits[:, w : 2 * w]
    vertical[:h, :, 0], vertical[:h, :, w] = digits[:, 2 * w : 2 * w + h].T, digits[:, 2 * w + h :].T
    boxes = np.broadcast_to(np.arange(count)[:, None], mask.shape).reshape(h + 1, -1)
    edges = np.pad(horizontal.reshape(h + 1, -1), ((0, 1), (0, 0)), constant_values=-1)
    uprights = np.pad(vertical.reshape(h + 1, -1), ((0, 0), (0, 1)), constant_values=-1)
    return mask.reshape(h + 1, -1), edges.astype(np.int8), uprights.astype(np.int8), boxes


def solvable(n, w, h):
    """Whether each box has a wall, by the program."""
    mask, horizontal, vertical, boxes = all_boxes(n, w, h)
    links = find_links(mask, horizontal, vertical)
    parts = find_parts(mask, links)
    wide, tall = (
        np.where(edges < 0, (1 << n) - 1, 1 << edges.clip(0)).astype(np.uint32)
        for edges in (horizontal, vertical)
    )
    failed = gather_parts(parts, links, wide, tall, n, np.random.default_rng(0))
    found = np.empty(parts.count, bool)
    found[boxes[mask]] = ~failed[parts.part[mask]]
    return found


def check(mask, n, region, horizontal=None, vertical=None):
    """The wall is one of the set, fills the mask and nothing else, and has what is given."""
    across, upright = region.horizontal, region.vertical
    edges = (across[:-1], upright[:, 1:], across[1:], upright[:, :-1])
    assert np.array_equal(region.tiles.slots, brick_tiles(n).slots)
    assert ((region.cells >= 0) == mask).all()
    assert (np.stack(edges, -1)[mask] == region.tiles.slots[region.cells[mask]]).all()
    for given, found, axis in ((horizontal, across, 0), (vertical, upright, 1)):
        cells = np.pad(mask, [(1, 1) if a == axis else (0, 0) for a in (0, 1)])
        touched = cells[1:] | cells[:-1] if axis == 0 else cells[:, 1:] | cells[:, :-1]
        assert ((found >= 0) == touched).all()
        if given is not None:
            asked = (given >= 0) & touched
            assert (found[asked] == given[asked]).all()


@pytest.mark.parametrize(("n", "w", "h"), UNSOLVABLE)
def test_as_many_boundaries_are_refused_as_an_exhaustive_search_found(n, w, h):
    found = solvable(n, w, h)
    assert ((~found).sum(), found.size) == UNSOLVABLE[n, w, h]


@pytest.mark.parametrize("n", [2, 3, 4])
def test_every_boundary_of_two_cells_is_decided_as_by_trying_all_tiles(n):
    slots = brick_tiles(n).slots.astype(int)
    west, east = (s.ravel() for s in np.meshgrid(np.arange(len(slots)), np.arange(len(slots))))
    met = slots[west, 1] == slots[east, 3]
    a, b = slots[west[met]], slots[east[met]]
    code = np.stack([a[:, 0], b[:, 0], a[:, 2], b[:, 2], a[:, 3], b[:, 1]], 1) @ n ** np.arange(6)
    possible = np.zeros(n**6, bool)
    possible[code] = True
    assert np.array_equal(solvable(n, 2, 1), possible)


@pytest.mark.parametrize(("n", "w", "h"), [(2, 3, 2), (3, 3, 1), (3, 2, 2)])
def test_boundaries_that_can_be_met_are(n, w, h):
    mask, horizontal, vertical, boxes = all_boxes(n, w, h)
    mask &= solvable(n, w, h)[boxes]
    region = brick_region(mask, n, horizontal=horizontal, vertical=vertical)
    check(mask, n, region, horizontal, vertical)


def formula(mask, n, horizontal, vertical):
    """All walls of a region as a formula."""
    rules = Clauses()
    across, upright = rules.variables(*horizontal.shape, n), rules.variables(*vertical.shape, n)
    along = rules.variables(*mask.shape)
    for edges, given in ((across, horizontal), (upright, vertical)):
        rules.exactly_one(edges)
        rules.add(edges[given >= 0, given[given >= 0]][:, None])
    for y, x in np.argwhere(mask):
        pairs = (
            (upright[y, x], upright[y, x + 1], along[y, x]),
            (across[y, x], across[y + 1, x], -along[y, x]),
        )
        for one, other, same in pairs:
            for a, b in zip(one, other, strict=True):
                rules.add([[-same, -a, b], [same, -a, -b]])
    return rules


@pytest.mark.parametrize("n", [2, 3, 4])
def test_random_regions_are_tiled_or_proven_impossible(n):
    pytest.importorskip("pysat")
    rng = np.random.default_rng(n)
    refused = 0
    for trial in range(60):
        h, w = rng.integers(1, 7, 2)
        mask = rng.random((h, w)) < rng.choice([0.4, 0.6, 0.9])
        if not mask.any():
            continue
        horizontal, vertical = rng.integers(0, n, (h + 1, w)), rng.integers(0, n, (h, w + 1))
        # Inner edges are given now and then, those of the boundary nearly always.
        for edges, inner in ((horizontal, mask[1:] & mask[:-1]), (vertical, mask[:, 1:] & mask[:, :-1])):
            free = rng.random(edges.shape) < 0.03
            part = free[1:-1] if edges is horizontal else free[:, 1:-1]
            part |= inner & (rng.random(inner.shape) < 0.9)
            edges[free] = -1
        possible = formula(mask, n, horizontal, vertical).solve() is not None
        try:
            region = brick_region(mask, n, horizontal=horizontal, vertical=vertical, seed=trial)
        except TilewrightError:
            assert not possible
            refused += 1
        else:
            assert possible
            check(mask, n, region, horizontal, vertical)
    assert 5 < refused < 55


@pytest.mark.parametrize("n", [3, 5, 16])
def test_rings_meet_any_boundary_from_three_positions_on(n):
    rng = np.random.default_rng(0)
    mask = np.zeros((40, 40), bool)
    for corner in range(0, 40, 8):  # rings one cell wide, of many sizes
        for other in range(0, 40, 8):
            h, w = rng.integers(3, 8, 2)
            mask[corner : corner + h, other : other + w] = True
            mask[corner + 1 : corner + h - 1, other + 1 : other + w - 1] = False
    for seed in range(10):
        horizontal, vertical = rng.integers(0, n, (41, 40)), rng.integers(0, n, (40, 41))
        horizontal[1:-1][mask[1:] & mask[:-1]] = -1
        vertical[:, 1:-1][mask[:, 1:] & mask[:, :-1]] = -1
        check(mask, n, brick_region(mask, n, horizontal=horizontal, vertical=vertical, seed=seed))


@pytest.mark.parametrize("n", [2, 4, 16])
def test_large_regions_look_random_and_have_short_lines(n):
    y, x = np.mgrid[:200, :300]
    mask = (abs(x - 150) + abs(y - 90) < 220) & ((x - 120) ** 2 + (y - 100) ** 2 > 30**2)
    rng = np.random.default_rng(1)
    horizontal = np.where(np.pad(mask, ((1, 0), (0, 0))) != np.pad(mask, ((0, 1), (0, 0))), 0, -1)
    horizontal[0], horizontal[-1] = -1, rng.integers(-1, n, 300)
    region = brick_region(mask, n, horizontal=horizontal, seed=3)
    check(mask, n, region, horizontal)
    assert max(region.longest) <= 6
    down = (region.horizontal[:-1] == region.horizontal[1:])[mask].mean()
    assert abs(down - 0.5) < 0.02
    counts = np.bincount(region.vertical[region.vertical >= 0], minlength=n)
    assert abs(counts / counts.mean() - 1).max() < 0.15
    again = brick_region(mask, n, horizontal=horizontal, seed=3)
    assert np.array_equal(region.cells, again.cells)
    other = brick_region(mask, n, horizontal=horizontal, seed=4)
    assert (region.cells != other.cells)[mask].mean() > 0.5
    assert max(brick_region(mask, n, longest=(2, 6)).longest) <= 8


def test_longest_lines_are_measured():
    horizontal, vertical = np.zeros((2, 5), int), np.zeros((1, 6), int)
    horizontal[1] = (1, 1, 1, 0, 1)  # four tiles of class H, broken by one of class V
    vertical[0, 4:] = 1
    region = brick_region(np.ones((1, 5)) > 0, 2, horizontal=horizontal, vertical=vertical)
    assert region.longest == (3, 1)
    assert brick_region([[1]], 2, horizontal=[[1], [1]]).longest == (0, 1)


def test_a_whole_rectangle_is_a_tiling():
    region = brick_region(np.ones((4, 5), bool), 3)
    assert np.array_equal(region.tiling().indices(0, 0, 5, 4), region.cells)
    with pytest.raises(TilewrightError, match="not a whole rectangle"):
        brick_region([[1, 0], [1, 1]], 3).tiling()


def test_two_positions_are_refused_by_parity():
    horizontal, vertical = np.zeros((3, 2), int), np.zeros((2, 3), int)
    horizontal[1], vertical[:, 1] = -1, -1
    brick_region(np.ones((2, 2)) > 0, 2, horizontal=horizontal, vertical=vertical)
    horizontal[0, 0] = 1
    with pytest.raises(TilewrightError, match=r"the 4 cells around x=0, y=0 .* add up to 1, .* must be even"):
        brick_region(np.ones((2, 2)) > 0, 2, horizontal=horizontal, vertical=vertical)
    horizontal[0, 1] = -1
    brick_region(np.ones((2, 2)) > 0, 2, horizontal=horizontal, vertical=vertical)


def test_refusals_name_the_part_and_count_the_others():
    mask = np.array([[1, 0, 1, 0, 1]])
    given = np.zeros((2, 5), int)
    with pytest.raises(TilewrightError, match=r"the cell at x=0, y=0 \(nor 2 other parts of the region\)"):
        brick_region(mask, 3, horizontal=given, vertical=np.zeros((1, 6), int))
    with pytest.raises(TilewrightError, match="no ring of cells"):
        brick_region(mask[:, :2], 3, horizontal=given[:, :2], vertical=np.zeros((1, 3), int))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"mask": np.zeros((3, 3), bool)}, "mask has no cells"),
        ({"mask": np.zeros((0, 3), bool)}, "mask has shape .* not empty"),
        ({"mask": [1, 1]}, "mask has shape"),
        ({"mask": [[2, 1]]}, "mask holds 1 to 2"),
        ({"mask": [[0.5, np.nan]]}, "mask must hold integers"),
        ({"positions": 1}, "positions is 1; allowed are 2 to 16"),
        ({"positions": 17}, "positions is 17"),
        ({"horizontal": np.zeros((3, 3), int)}, r"horizontal has shape \(3, 3\); this mask needs \(4, 3\)"),
        ({"vertical": np.full((3, 4), 4)}, "vertical holds 4 to 4; allowed are 0 to 3"),
        ({"vertical": np.full((3, 4), -2)}, "vertical holds -2"),
        ({"horizontal": np.zeros((4, 3))}, "horizontal must hold integers"),
        ({"longest": (0, 3)}, "longest is 0"),
        ({"longest": 3}, "longest must be two numbers"),
        ({"longest": (3, 3, 3)}, "longest has 3 entries"),
        ({"seed": -1}, "seed is -1"),
    ],
)
def test_bad_input_is_told_in_one_line(change, message):
    with pytest.raises(TilewrightError, match=message) as caught:
        brick_region(**{"mask": np.ones((3, 3), bool)} | change)
    assert "\n" not in str(caught.value)
