"""Joints in any number and any direction: tiles that meet otherwise than along the axes."""

from itertools import product

import numpy as np
import pytest

import tilewright as tw
from tilewright.tiles import ListedTileSet, Shape
from tilewright.tilings import first_mismatch

_SLOTS = ("E", "W", "SE", "NW", "SW", "NE")
HEXAGON = Shape("hexagon", _SLOTS, (((0, 1),), ((2, 3),), ((4, 5),)), ((1, 0), (0, 1), (-1, 1)))
"""Hexagons in rows that are shifted by half: cell (x, y) meets (x + 1, y), (x, y + 1) and (x - 1, y + 1)."""
TWICE = Shape(
    "twice", ("E", "W", "F", "X", "S", "N"), (((0, 1),), ((2, 3),), ((4, 5),)), ((1, 0), (1, 0), (0, 1))
)
"""Square tiles with two joints along x."""


def parity_hexagons():
    """Hexagons over two colors with an even number of edges of color 1."""
    every = np.array(list(product((0, 1), repeat=6)))
    return ListedTileSet(HEXAGON, every[every.sum(axis=1) % 2 == 0], (2,) * 6, "even")


@pytest.mark.parametrize("torus", [False, True])
def test_a_solver_lays_hexagons_and_a_stored_tiling_checks_them(torus):
    pytest.importorskip("pysat")
    tiles = parity_hexagons()
    cells = tw.filled_tiling(tiles, 6, 5, torus=torus, seed=3).indices(0, 0, 6, 5)
    slots = tiles.slots_of(cells).astype(int)
    for y, x, (far, near), (dx, dy) in (
        (y, x, pair, step)
        for y, x in product(range(5), range(6))
        for joint, step in zip(HEXAGON.joints, HEXAGON.steps, strict=True)
        for pair in joint
    ):
        if torus or (0 <= x + dx < 6 and y + dy < 5):
            assert slots[y, x, far] == slots[(y + dy) % 5, (x + dx) % 6, near]
    assert first_mismatch(tiles, cells, torus=torus) is None


def test_a_slanted_fault_is_named():
    tiles = parity_hexagons()
    plain = int(tiles.find([0] * 6))
    cells = np.full((4, 4), plain)
    cells[1, 2] = int(tiles.find([0, 0, 0, 0, 1, 1]))
    # Its SW edge meets cell (1, 2), its NE edge cell (3, 0); the fault at (3, 0) comes first.
    assert "cell x=3, y=0 and its neighbor (-1, 1) away" in first_mismatch(tiles, cells, torus=False)
    cells[0, 3] = int(tiles.find([0, 0, 0, 0, 1, 1]))
    assert "cell x=2, y=1 and its neighbor (-1, 1) away" in first_mismatch(tiles, cells, torus=False)
    # Edges that lead out of the array meet others around a torus alone.
    cells[:] = plain
    cells[0, 3] = int(tiles.find([1, 0, 0, 0, 0, 1]))
    assert first_mismatch(tiles, cells, torus=False) is None
    with pytest.raises(tw.TilewrightError, match="x=3, y=0 and its neighbor along x do not match: E is 1"):
        tw.array_tiling(tiles, cells, torus=True)


def test_several_joints_along_an_axis_count_as_one():
    every = np.array(list(product((0, 1), repeat=6)))
    tiles = ListedTileSet(TWICE, every, (2,) * 6)
    assert TWICE.dimension == 2
    assert TWICE.across(0) == ((0, 1), (2, 3))
    assert TWICE.across(1) == ((4, 5),)
    cells = tw.scanline(tiles, 12, 9, seed=4).indices(0, 0, 12, 9)
    slots = tiles.slots_of(cells)
    assert np.array_equal(slots[:, :-1, 0], slots[:, 1:, 1])
    assert np.array_equal(slots[:, :-1, 2], slots[:, 1:, 3])
    assert np.array_equal(slots[:-1, :, 4], slots[1:, :, 5])


def test_what_works_along_axes_alone_says_so():
    with pytest.raises(tw.TilewrightError, match="hexagon tiles meet across steps"):
        tw.scanline(parity_hexagons(), 5, 5)
    with pytest.raises(tw.TilewrightError, match="steps is"):
        Shape("crooked", ("E", "W"), (((0, 1),),), ((1, 0), (0, 1)))


def test_palettes_spread_along_slanted_joints():
    assert ListedTileSet(HEXAGON, [[0, 0, 0, 0, 3, 0]]).colors == (1, 1, 1, 1, 4, 4)
