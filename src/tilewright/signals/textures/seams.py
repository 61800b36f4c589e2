"""Maps whose cuts are closed after copying: normals as vectors, heights by their slopes.

Color is cut where it fits, and stays as it was copied. A map of normals shows a cut as a crease of light, and
a map of heights as a cliff, however well the color fits there, so both are mended beside the cuts. What
lies over a tile's border takes part, and tiles that share a border stay alike there.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress
from tilewright.signals.textures.kinds import Values, from_values, is_normal, is_signed, to_values
from tilewright.signals.textures.sharing import Shared, neighbors_of, with_gutters
from tilewright.tiles import TileSet
from tilewright.tiles.variants import Variants

Sources = tuple[dict[str, NDArray[Any]], ...]

REACH = 1 / 12
"""How far from a cut heights are changed, in tiles."""
ROUNDS = 6
"""Rounds of relaxation for each pixel of that reach."""
_STEPS = ((0, 1), (0, -1), (1, 0), (-1, 0))


def copy_maps(
    sources: Sources,
    origins: NDArray[np.uint16],
    kinds: dict[str, str],
    tiles: TileSet,
    variants: Variants,
    progress: Progress | None = None,
) -> dict[str, NDArray[Any]]:
    """Every map of a material: copied from the sources along ``origins``, and closed where its kind needs it.

    Parameters
    ----------
    sources : tuple of dict of str to array, shape (h, w, channels)
    origins : uint16 array, shape (rows, n, n, 3)
        (source, y, x) of each pixel.
    kinds : dict of str to str
        What each map holds, see `KINDS`.
    variants : Variants
        The rows of each tile.
    """
    from tilewright.signals.textures.texture_tiles import copy_from_sources

    maps = copy_from_sources(sources, origins)
    mended = {n: kinds[n] for n in maps if is_normal(kinds[n]) or kinds[n] == "height"}
    if mended:
        cuts = Cuts(sources, origins, Shared(tiles, variants))
        for name, kind in mended.items():
            if kind == "height":
                maps[name] = _close_heights(maps[name], cuts, name, progress)
            else:
                maps[name] = _blend_normals(maps[name], cuts, name, kind)
    return maps


class Cuts:
    """Where pixels do not continue each other, and what would lie there if they did."""

    def __init__(self, sources: Sources, origins: NDArray[np.uint16], shared: Shared) -> None:
        self.sources = sources
        self.shared = shared
        self.here = origins
        self.around = with_gutters(origins, 1, shared)
        self.crossed: dict[tuple[int, int], NDArray[np.bool_]] = {
            step: np.empty(origins.shape[:3], bool) for step in _STEPS
        }
        heights, widths = np.array([next(iter(s.values())).shape[:2] for s in sources], np.int32).T
        for tile, around in enumerate(self.around):  # one at a time, for memory
            number, row, column = (around[..., k].astype(np.int32) for k in range(3))
            height, width = heights[number], widths[number]
            for step, crossed in self.crossed.items():
                dy, dx = step
                here, there = _shift, partial(_shift, step=step)
                goes_on = (here(row) + dy == there(row)) & (here(column) + dx == there(column))
                goes_on &= here(number) == there(number)
                # A pair is closed only where both patches go on in their sources.
                inside = _is_in(here(row) + dy, here(height)) & _is_in(here(column) + dx, here(width))
                inside &= _is_in(there(row) - dy, there(height)) & _is_in(there(column) - dx, there(width))
                crossed[tile] = ~goes_on & inside

    def pairs(self, step: tuple[int, int]) -> tuple[NDArray[np.int32], NDArray[np.int32]]:
        """Origins on both sides of cuts that are crossed by a step, shape (k, 3)."""
        crossed, (dy, dx) = self.crossed[step], step
        n = crossed.shape[1]
        there = self.around[:, 1 + dy : 1 + dy + n, 1 + dx : 1 + dx + n]
        return self.here[crossed].astype(np.int32), there[crossed].astype(np.int32)

    def read(self, values: list[Values], spots: NDArray[np.int32]) -> Values:
        """Values of sources at (source, y, x), shape (k, 3)."""
        out = np.empty((len(spots), values[0].shape[2]), np.float32)
        for number, source in enumerate(values):
            mine = spots[:, 0] == number
            out[mine] = source[spots[mine, 1], spots[mine, 2]]
        return out


def _is_in(at: NDArray[np.int32], length: NDArray[np.int32]) -> NDArray[np.bool_]:
    return (at >= 0) & (at < length)


def _on(origins: NDArray[np.int32], step: tuple[int, int]) -> NDArray[np.int32]:
    """The origins a step further in the same source."""
    return origins + np.array((0, *step), np.int32)


def _back(origins: NDArray[np.int32], step: tuple[int, int]) -> NDArray[np.int32]:
    return origins - np.array((0, *step), np.int32)


def _blend_normals(pixels: NDArray[Any], cuts: Cuts, name: str, kind: str) -> NDArray[Any]:
    """Beside a cut, the sum of the patch's own vector and half of what the other patch has there."""
    signed = is_signed(pixels)
    sources = [to_values(s[name], kind) for s in cuts.sources]
    count = np.ones(pixels.shape[:3], np.float32)
    for crossed in cuts.crossed.values():
        count[crossed] += np.float32(0.5)
    touched = count > 1
    sides: tuple[Any, ...] = (np.s_[:, 0], np.s_[:, -1], np.s_[:, :, 0], np.s_[:, :, -1])
    asked = touched.copy()
    for side in sides:
        asked[side] = True
    vectors = np.zeros((*pixels.shape[:3], sources[0].shape[2]), np.float32)
    vectors[asked] = to_values(pixels[asked][:, np.newaxis], kind, signed)[:, 0]
    for step, crossed in cuts.crossed.items():
        _, there = cuts.pairs(step)
        vectors[crossed] += np.float32(0.5) * cuts.read(sources, _back(there, step))
    vectors[touched] /= count[touched][:, np.newaxis]
    own = [vectors[side].copy() for side in sides]
    cuts.shared.settle_border(vectors)
    for side, before in zip(sides, own, strict=True):
        touched[side] |= (vectors[side] != before).any(axis=2)
    return _written(pixels, vectors, touched, kind, signed)


def _written(
    pixels: NDArray[Any], values: Values, where: NDArray[np.bool_], kind: str, signed: bool | None = None
) -> NDArray[Any]:
    """Pixels with values written over some of them."""
    out = pixels.copy()
    for tile, own, new, here in zip(out, pixels, values, where, strict=True):
        tile[here] = from_values(new[here][:, np.newaxis], kind, own, signed)[:, 0]
    return out


def _close_heights(pixels: NDArray[Any], cuts: Cuts, name: str, progress: Progress | None) -> NDArray[Any]:
    """Heights near cuts moved so that slopes go on over them (Perez et al. 2003, section 2, within a band).

    A correction is sought that jumps at cuts by what the heights there jump too much, and is smooth
    elsewhere: at each pixel the mean of its neighbors', relaxed until it settles.
    """
    sources = [to_values(s[name], "height") for s in cuts.sources]
    wanted = np.zeros(pixels.shape, np.float32)
    for step, crossed in cuts.crossed.items():
        here, there = cuts.pairs(step)
        ours, theirs = cuts.read(sources, here), cuts.read(sources, there)
        slope = cuts.read(sources, _on(here, step)) - ours + theirs - cuts.read(sources, _back(there, step))
        wanted[crossed] += (theirs - ours) - slope / 2
    reach = max(2, round(REACH * pixels.shape[1]))
    band = _band(cuts, reach)

    def tell(done: int, total: int) -> None:
        if progress is not None:
            progress(done, total, f"closing {name}")

    values = _relaxed(wanted, band, reach, cuts.shared, tell)
    for tile, own in zip(values, pixels, strict=True):
        tile += to_values(own, "height")
    return _written(pixels, values, band[..., 0], "height")


def _relaxed(
    wanted: Values, band: NDArray[np.bool_], reach: int, shared: Shared, tell: Callable[[int, int], None]
) -> Values:
    """What is 0 outside the band and inside the mean of its four neighbors and a fourth of what is wanted.

    Chebyshev's semi-iteration, so that the rounds grow with the reach and not with its square.
    """
    from tilewright.kernels.relaxation import relax_tiles

    correction, before = np.zeros((2, *wanted.shape), np.float32)
    beside = _beside(shared)
    slowest = np.cos(np.pi / (4 * reach))  # how much of the smoothest error a plain round leaves
    push, rounds = 1.0, ROUNDS * reach
    for done in range(rounds):
        tell(done, rounds)
        push = 1 / (1 - slowest**2 / 2) if done == 1 else 1 / (1 - slowest**2 * push / 4) if done else 1.0
        for c in range(wanted.shape[3]):
            given = (correction[..., c], wanted[..., c], band[..., 0], beside)
            relax_tiles(len(wanted), *given, np.float32(push), before[..., c])
        shared.settle_border(before)
        correction, before = before, correction
    return correction


def _band(cuts: Cuts, reach: int) -> NDArray[np.bool_]:
    """Pixels near cuts, the same in all tiles along what they share; shape (T, n, n, 1)."""
    from tilewright.kernels.relaxation import grow_tiles

    near = np.any(list(cuts.crossed.values()), axis=0)[..., np.newaxis]
    n = near.shape[1]
    if not cuts.shared.corners:  # what lies at the corners of Wang tiles is not known to all of them
        near[:, :: n - 1, :: n - 1] = False
    beside, wider = _beside(cuts.shared), np.empty_like(near)
    for _ in range(reach - 1):
        grow_tiles(len(near), near[..., 0], beside, wider[..., 0])
        near, wider = wider, near
    same = near.astype(np.float32)
    cuts.shared.settle_border(same)
    return same > 0.999


def _beside(shared: Shared) -> NDArray[np.int64]:
    """The tile a step away from each."""
    return np.stack([neighbors_of(shared, *step) for step in _STEPS])


def _shift(around: NDArray[Any], step: tuple[int, int] = (0, 0)) -> NDArray[Any]:
    """What lies a step away from each pixel of a tile with a gutter of one pixel."""
    dy, dx = step
    n = len(around) - 2
    return around[1 + dy : 1 + dy + n, 1 + dx : 1 + dx + n]
