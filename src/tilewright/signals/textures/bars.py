"""Places that patches must not be taken from: out of step with the lattice, or showing what is seldom."""

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import find_objects, label, maximum_filter

from tilewright.signals.textures.lone import SCALES, stand_out
from tilewright.signals.textures.manner import Manner
from tilewright.signals.textures.rhythm import Rhythm
from tilewright.signals.textures.sheet import Sheet, sum_channels

CORNER_SHOWS = (0.55, 0.55)
"""Height and width of the middle of a corner patch that shows, in tiles, where it may hold no lone thing."""
EDGE_SHOWS = (0.62, 0.36)
"""The same along and across the edge of an edge patch."""
CENTER_SHOWS = 0.7
"""Side of the middle of a tile in which a center patch shows a thing, in tiles."""
FEWEST_OPEN = 0.1
"""Share of places that bars on lone things must leave; where they leave fewer, they do not hold."""
IN_STEP_EVEN, IN_STEP_UNEVEN = 0.01, 0.055
"""How far a patch may be out of step with the courses of a tile, in courses; a pixel at the least."""
FEWEST_ROWS = 24
"""Rows of places that are left in step at the least: where fewer are, the best of them are taken."""


class Bars:
    """What the manner of a search forbids, as maps of the places of one sheet for one tile size.

    Attributes
    ----------
    spent : bool array
        Places from which a center patch would show a lone thing that as many show as may; it grows.
    """

    def __init__(self, sheet: Sheet, size: int, manner: Manner) -> None:
        self.sheet, self.size, self.manner = sheet, size, manner
        self.spent = np.zeros(tuple(max(0, n - size + 1) for n in sheet.usable.shape), bool)
        if manner.lone is not None:
            self._things, _ = label(manner.lone)  # by number
            self._boxes = find_objects(self._things)
            self._shown = np.zeros(len(self._boxes), int)

    def open_corners(self, places: NDArray[np.bool_], reach: int) -> NDArray[np.bool_]:
        """Of places whose windows have ``reach`` pixels around a lattice point, those open to its patch."""
        height, width = places.shape
        half, margin = self.size // 2, reach - self.size // 2
        kept = self.in_step(places, half, half, margin)
        if self.lone_in_corner is not None:
            bare = kept & ~self.lone_in_corner[reach : reach + height, reach : reach + width]
            kept = bare if bare.sum() > FEWEST_OPEN * kept.sum() else kept
        return kept

    def in_step(self, places: NDArray[np.bool_], row: int, column: int, margin: int = 0) -> NDArray[np.bool_]:
        """Of places, those whose windows keep step with the courses of a tile.

        ``row`` and ``column`` of a window lie on lines of the lattice; a window begins ``margin`` pixels
        after its place.
        """
        courses = []
        for axis, (rhythm, line) in enumerate(zip(self.manner.rhythm, (row, column), strict=True)):
            if rhythm is not None:
                here = slice(margin, margin + places.shape[axis])
                kept = _in_step(rhythm, self.size, line)[here]
                places = places & (kept if axis else kept[:, np.newaxis])
                courses.append(rhythm.course_at(self.size, line)[here])
        if self.manner.bond.size > 1:
            i, j = courses
            places = places & self.manner.bond.alike(i[:, np.newaxis], j)
        return places

    @cached_property
    def lone_in_corner(self) -> NDArray[np.bool_] | None:
        """Sheet pixels around which a corner patch would show a lone thing."""
        lone = self.manner.lone
        return None if lone is None or not lone.any() else self._near(lone, *CORNER_SHOWS)

    def lone_in_edge(self, axis: int) -> NDArray[np.bool_] | None:
        """Places from which an edge patch would show a lone thing."""
        along, across = EDGE_SHOWS
        if self.manner.lone is None or not self.manner.lone.any():
            return None
        return self._windows_near(self.manner.lone, *((across, along) if axis == 0 else (along, across)))

    def _windows_near(self, mask: NDArray[np.bool_], height: float, width: float) -> NDArray[np.bool_]:
        """Places whose windows have masked pixels in a box in their middle, whose sides are in tiles."""
        near = self._near(mask, height, width)
        half, rest = self.size // 2, self.size - 1 - self.size // 2
        return near[half : near.shape[0] - rest, half : near.shape[1] - rest]

    def _near(self, mask: NDArray[Any], height: float, width: float) -> NDArray[Any]:
        """The largest value in a box around every pixel, whose sides are in tiles."""
        box = tuple(max(1, round(side * self.size)) for side in (height, width))
        return np.asarray(maximum_filter(mask, box))

    def bar_shown(self, place: tuple[int, int], shown: NDArray[np.bool_]) -> None:
        """Lone things that a patch is the last to show are barred for those that come after it."""
        if self.manner.lone is None:
            return
        y, x = place
        window = self._things[y : y + self.size, x : x + self.size]
        margin = round((1 - CENTER_SHOWS) / 2 * self.size)
        for thing in np.unique(window[shown & (window > 0)]):
            self._shown[thing - 1] += 1
            if self._shown[thing - 1] < self.manner.shows:
                continue
            rows, columns = self._boxes[thing - 1]
            first = [max(0, s.start - self.size + margin) for s in (rows, columns)]
            self.spent[first[0] : max(0, rows.stop - margin), first[1] : max(0, columns.stop - margin)] = True

    def popping_at(self, rows: NDArray[np.int64], columns: NDArray[np.int64]) -> NDArray[np.float32]:
        """By how much the thing that pops out most around sheet pixels is above the usual, over that."""
        salience = np.zeros(self.sheet.usable.shape, np.float32)
        for scale in SCALES:
            offset = stand_out(self.sheet.features, self.sheet.usable, scale * self.size, floor=1e-3)
            np.maximum(salience, np.sqrt(sum_channels(offset**2)), out=salience)
        most = self._near(salience, *CORNER_SHOWS)[rows, columns]
        return np.maximum(most / max(float(np.median(most)), 1e-9) - 1, 0)


def _in_step(rhythm: Rhythm, size: int, line: int) -> NDArray[np.bool_]:
    """Of the places along an axis, whether windows from there keep step."""
    misfit = rhythm.misfit(size, line)
    if not len(misfit):
        return np.zeros(0, bool)
    most = max(1.0, (IN_STEP_EVEN if rhythm.even else IN_STEP_UNEVEN) * rhythm.period)
    fewest = np.sort(misfit)[min(FEWEST_ROWS, len(misfit)) - 1]
    return np.asarray(misfit <= max(most, float(fewest)))
