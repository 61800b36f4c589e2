"""Paints walls: from the rectangles of bricks and words hashed on lattices to maps of their surface."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tilewright.signals.bricks.style import FINISH, BrickStyle, Look, tint_bricks

if TYPE_CHECKING:
    from tilewright.kernels.brick_drawing import Noise

CHANCES = 11
"""Numbers by chance that a brick is made of."""
_FINEST = 3.0
"""Pixels between the lattice points of the first octave."""
_LEVEL = 0.80
"""Mean height of faces."""

Words = Callable[[int, tuple[int, int], tuple[int, int, int, int]], NDArray[np.uint32]]
"""``words(octave, points, (column, row, columns, rows))``: a random word for each lattice point, shape
(rows, columns). There are ``points`` of them along x and y in a unit of the wall; columns and rows are
counted from the north-west of the unit that holds the first pixel."""


def paint(
    index: NDArray[np.int32],
    sides: NDArray[np.int64],
    chances: NDArray[np.float64],
    words: Words,
    style: BrickStyle,
    look: Look,
    unit: tuple[int, int],
    start: tuple[int, int],
) -> dict[str, NDArray[Any]]:
    """Maps of a window of a wall.

    Parameters
    ----------
    index : int32 array, shape (h + 2, w + 2)
        The brick of each pixel of the window and of one more pixel around it.
    sides : int64 array, shape (n, 4)
        West, north, east and south side of each brick, to the middle of the mortar, in pixels of ``index``.
    chances : array, shape (CHANCES, n)
        Numbers of [0, 1) for each brick.
    words : Words
    style, look : BrickStyle, Look
    unit : (int, int)
        Width and height of a unit of the wall in pixels: what carries the lattices of noise.
    start : (int, int)
        Where in its unit the first pixel of ``index`` lies.

    Returns
    -------
    dict of arrays, shape (h, w, channels)
        ``color`` uint8 sRGB; ``height`` uint16, 65535 being ``look.relief`` pixels above 0; ``normal`` uint8,
        of those heights, green up; ``roughness`` uint8; ``mortar`` uint8, 255 where mortar is.
    """
    from tilewright.kernels.brick_drawing import Edges, Finish, Surface, fill_relief, paint_bricks

    h, w = index.shape
    color, (roughness, mortar) = np.empty((h, w, 3), np.uint8), np.empty((2, h, w), np.uint8)
    surface = Surface(np.empty((h, w), np.float32), color, roughness, mortar)
    bricks = _describe_bricks(sides, chances, style, look)
    keys = (chances[0] * 2**32).astype(np.uint32) | np.uint32(1)
    lengths = look.mortar / 2, look.bevel, look.rounding, look.wobble
    edges = Edges(*(np.float32(length) for length in lengths))
    finish = Finish(
        **{name: np.float32(share) for name, share in FINISH.items()}, grain=np.float32(style.grain)
    )
    noise = lay_noise(words, unit, start, (w, h))
    lime = np.append(style.lime, 0.95).astype(np.float32)
    paint_bricks(h, index, bricks, keys, noise, edges, finish, lime, surface)
    levels, normal = np.empty((h - 2, w - 2), np.uint16), np.empty((h - 2, w - 2, 3), np.uint8)
    fill_relief(h - 2, surface.height, look.relief, levels, normal)
    inner = (slice(1, -1), slice(1, -1))
    return {
        "color": color[inner],
        "height": levels[..., np.newaxis],
        "normal": normal,
        "roughness": roughness[inner][..., np.newaxis],
        "mortar": mortar[inner][..., np.newaxis],
    }


def _describe_bricks(
    sides: NDArray[np.int64], chances: NDArray[np.float64], style: BrickStyle, look: Look
) -> NDArray[np.float32]:
    """The rows of `paint_bricks`: nothing in them but sides depends on the window."""
    spread = style.variation * (2 * chances[6:9] - 1)
    level = _LEVEL + 0.12 * spread[0]
    tilt_x = 0.14 * spread[1] / (sides[:, 2] - sides[:, 0])
    tilt_y = 0.14 * spread[2] / (sides[:, 3] - sides[:, 1])
    rough = 0.84 + 0.08 * (2 * chances[9] - 1)
    smear = 0.9 * style.wear * chances[10] ** 2
    surface = np.stack([level, tilt_x, tilt_y, rough, smear], axis=1)
    return np.concatenate([sides + look.insets, surface, tint_bricks(style, chances[1:6])], axis=1).astype(
        np.float32
    )


def _octaves(unit: tuple[int, int]) -> list[tuple[int, int]]:
    """Lattice points along x and y in a unit, from the finest octave to one of half the unit's height."""
    count = max(1, int(np.log2(max(unit[1] / 2 / _FINEST, 1))) + 1)
    spacings = _FINEST * 2.0 ** np.arange(count)
    return [(max(1, round(unit[0] / s)), max(1, round(unit[1] / s))) for s in spacings]


def _weigh_octaves(unit: tuple[int, int]) -> NDArray[np.float32]:
    """How much each octave adds to edges, stains and sand, shape (octaves, 3)."""
    share = np.array([1 / rows for _, rows in _octaves(unit)])
    edge = share**0.6 * np.where(share >= 1 / 16, 1, 0.15)
    stain = share**0.8 * (share >= min(1 / 10, share[-1]))
    sand = share**0.15 * np.minimum(16 * share, 1) ** 0.5 * np.where(share <= 1 / 4, 1, 0.4)
    weights = np.stack([edge, stain, sand], axis=1)
    return (2.2 * weights / np.sqrt((weights**2).sum(axis=0))).astype(np.float32)


def lay_noise(
    words: Words, unit: tuple[int, int], start: tuple[int, int], extent: tuple[int, int]
) -> "Noise":
    """Lattice words of all octaves, and where each column and row of pixels lies between them."""
    from tilewright.kernels.brick_drawing import Noise

    found, places, axes = [], [], []
    begin = 0
    for octave, points in enumerate(_octaves(unit)):
        both = [_between(start[a], extent[a], unit[a], points[a]) for a in (0, 1)]
        (column, columns), (row, rows) = ((at[0], at[-1] + 2 - at[0]) for at, _ in both)
        found.append(words(octave, points, (int(column), int(row), int(columns), int(rows))).ravel())
        places.append((begin, columns))
        begin += found[-1].size
        axes.append([(at - at[0], shares) for at, shares in both])
    columns, east, rows, south = (
        np.stack([axis[a][part] for axis in axes]) for a in (0, 1) for part in (0, 1)
    )
    return Noise(
        np.concatenate(found),
        np.array(places, np.int64),
        columns.astype(np.int32),
        np.stack([np.searchsorted(row, row, side="right") for row in columns]).astype(np.int32),
        east.astype(np.float32),
        np.ascontiguousarray(rows.T.astype(np.int32)),
        np.ascontiguousarray(south.transpose(2, 0, 1).astype(np.float32)),
        _weigh_octaves(unit),
    )


def _between(start: int, count: int, unit: int, points: int) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Lattice point before each of a row of pixels, and how far behind it the pixel lies, plain and eased."""
    halves = (2 * (start + np.arange(count)) + 1) * points
    before, rest = np.divmod(halves, 2 * unit)
    share = rest / (2 * unit)
    eased = share**3 * (share * (6 * share - 15) + 10)
    return before, np.stack([share, eased])
