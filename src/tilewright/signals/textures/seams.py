"""Maps whose cuts are closed after copying: normals as vectors, heights by their slopes.

Color is cut where it fits, and stays as it was copied. A map of normals shows a cut as a crease of light, and
a map of heights as a cliff, however well the color fits there, so both are mended beside the cuts. What
lies over a tile's border takes part, and tiles that share a border stay alike there.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress
from tilewright.signals.textures.kinds import Values, from_values, is_normal, is_signed, to_values
from tilewright.signals.textures.sharing import Shared, neighbors_of
from tilewright.tiles import TileSet
from tilewright.tiles.variants import Variants

Sources = tuple[dict[str, NDArray[Any]], ...]

REACH = 1 / 12
"""How far from a cut heights are changed, in tiles."""
ROUNDS = 6
"""Rounds of relaxation for each pixel of that reach."""
STEPS = ((0, 1), (0, -1), (1, 0), (-1, 0))
"""East, west, south, north, as (rows, columns)."""


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
                _close_heights(maps[name], cuts, name, progress)
            else:
                _blend_normals(maps[name], cuts, name, kind)
    return maps


class Pairs(NamedTuple):
    """The cuts of a tile that are crossed by a step.

    Attributes
    ----------
    where : bool array, shape (n, n)
        The pixels before them.
    here, there : int32 array, shape (k, 3)
        Origins on both sides.
    """

    where: NDArray[np.bool_]
    here: NDArray[np.int32]
    there: NDArray[np.int32]


class Cuts:
    """Where pixels do not continue each other, and what would lie there if they did."""

    def __init__(self, sources: Sources, origins: NDArray[np.uint16], shared: Shared) -> None:
        from tilewright.kernels.relaxation import find_cuts

        self.sources = sources
        self.shared = shared
        self.origins = origins
        self.beside = np.stack([neighbors_of(shared, *step) for step in STEPS])
        self.crossed = np.empty(origins.shape[:3], np.uint8)
        """A bit for each of `STEPS` that crosses a cut on which both patches go on in their sources."""
        sizes = np.array([next(iter(s.values())).shape[:2] for s in sources], np.int64)
        find_cuts(len(origins), origins, self.beside, sizes, self.crossed)

    def pairs(self, tile: int, number: int) -> Pairs:
        """The cuts of a tile that one of `STEPS` crosses."""
        where = self.crossed[tile] & np.uint8(1 << number) > 0
        own, next_one = self.origins[tile], self.origins[self.beside[number, tile]]
        axis = 0 if STEPS[number][0] else 1
        ahead = sum(STEPS[number]) > 0
        most = np.take(own, range(1, len(own)) if ahead else range(len(own) - 1), axis)
        end = np.take(next_one, [0] if ahead else [-1], axis)
        there = np.concatenate((most, end) if ahead else (end, most), axis)
        return Pairs(where, own[where].astype(np.int32), there[where].astype(np.int32))

    def read(self, name: str, kind: str, spots: NDArray[np.int32], signed: Sequence[bool]) -> Values:
        """Values of a map of the sources at (source, y, x), shape (k, 3); which of them are signed."""
        out = np.empty((len(spots), self.sources[0][name].shape[2]), np.float32)
        for number, (source, signs) in enumerate(zip(self.sources, signed, strict=True)):
            mine = spots[:, 0] == number
            pixels = source[name][spots[mine, 1], spots[mine, 2]]
            out[mine] = to_values(pixels[:, np.newaxis], kind, signs)[:, 0]
        return out


def _on(origins: NDArray[np.int32], step: tuple[int, int]) -> NDArray[np.int32]:
    """The origins a step further in the same source."""
    return origins + np.array((0, *step), np.int32)


def _back(origins: NDArray[np.int32], step: tuple[int, int]) -> NDArray[np.int32]:
    return origins - np.array((0, *step), np.int32)


def _blend_normals(pixels: NDArray[Any], cuts: Cuts, name: str, kind: str) -> None:
    """Beside a cut, the sum of the patch's own vector and half of what the other has there; in place."""
    signed, n = is_signed(pixels), pixels.shape[1]
    signs = [is_signed(source[name]) for source in cuts.sources]
    columns, rows = (np.empty((*shape, pixels.shape[3]), np.float32) for shape in _strips(pixels))
    for tile, own in enumerate(pixels):  # one at a time, for memory
        count = np.ones(own.shape[:2], np.float32)
        for number in range(len(STEPS)):
            count[cuts.crossed[tile] & np.uint8(1 << number) > 0] += np.float32(0.5)
        touched = count > 1
        asked = touched.copy()
        asked[:: n - 1] = asked[:, :: n - 1] = True
        vectors = np.zeros(own.shape, np.float32)
        vectors[asked] = to_values(own[asked][:, np.newaxis], kind, signed)[:, 0]
        for number, step in enumerate(STEPS):
            where, _, there = cuts.pairs(tile, number)
            vectors[where] += np.float32(0.5) * cuts.read(name, kind, _back(there, step), signs)
        vectors[touched] /= count[touched][:, np.newaxis]
        _write(own, vectors, touched, kind, signed)
        columns[tile], rows[tile] = vectors[:, :: n - 1], vectors[:: n - 1]
    before = columns.copy(), rows.copy()
    cuts.shared.settle_strips(columns, rows)
    for old, new, strip in zip(
        before, (columns, rows), (pixels[:, :, :: n - 1], pixels[:, :: n - 1]), strict=True
    ):
        _write(strip, new, (new != old).any(axis=-1), kind, signed)


def _strips(pixels: NDArray[Any]) -> tuple[tuple[int, int, int], tuple[int, int, int]]:
    """Shapes of the outermost columns and rows of tiles."""
    count, n = pixels.shape[:2]
    return (count, n, 2), (count, 2, n)


def _write(
    pixels: NDArray[Any], values: Values, where: NDArray[np.bool_], kind: str, signed: bool | None = None
) -> None:
    """Write values over some pixels."""
    pixels[where] = from_values(values[where][:, np.newaxis], kind, pixels, signed)[:, 0]


def _close_heights(pixels: NDArray[Any], cuts: Cuts, name: str, progress: Progress | None) -> None:
    """Move heights near cuts so that slopes go on over them (Perez et al. 2003, section 2, within a band).

    A correction is sought that jumps at cuts by what the heights there jump too much, and is smooth
    elsewhere: at each pixel the mean of its neighbors', relaxed until it settles.
    """
    wanted = np.zeros(pixels.shape, np.float32)
    read = partial(cuts.read, name, "height", signed=[False] * len(cuts.sources))
    for tile, missing in enumerate(wanted):
        for number, step in enumerate(STEPS):
            where, here, there = cuts.pairs(tile, number)
            ours, on = read(here), read(_on(here, step))
            theirs, back = read(there), read(_back(there, step))
            slope = on - ours + theirs - back
            missing[where] += (theirs - ours) - slope / 2
    reach = max(2, round(REACH * pixels.shape[1]))
    band = _band(cuts, reach)

    def tell(done: int, total: int) -> None:
        if progress is not None:
            progress(done, total, f"closing {name}")

    for own, correction, near in zip(pixels, _relaxed(wanted, band, reach, cuts, tell), band, strict=True):
        _write(own, to_values(own, "height") + correction, near[..., 0], "height")


def _relaxed(
    wanted: Values, band: NDArray[np.bool_], reach: int, cuts: Cuts, tell: Callable[[int, int], None]
) -> Values:
    """What is 0 outside the band and inside the mean of its four neighbors and a fourth of what is wanted.

    Chebyshev's semi-iteration, so that the rounds grow with the reach and not with its square.
    """
    from tilewright.kernels.relaxation import relax_tiles

    correction, before = np.zeros((2, *wanted.shape), np.float32)
    slowest = np.cos(np.pi / (4 * reach))  # how much of the smoothest error a plain round leaves
    push, rounds = 1.0, ROUNDS * reach
    for done in range(rounds):
        tell(done, rounds)
        push = 1 / (1 - slowest**2 / 2) if done == 1 else 1 / (1 - slowest**2 * push / 4) if done else 1.0
        for c in range(wanted.shape[3]):
            given = (correction[..., c], wanted[..., c], band[..., 0], cuts.beside)
            relax_tiles(len(wanted), *given, np.float32(push), before[..., c])
        cuts.shared.settle_border(before)
        correction, before = before, correction
    return correction


def _band(cuts: Cuts, reach: int) -> NDArray[np.bool_]:
    """Pixels near cuts, the same in all tiles along what they share; shape (T, n, n, 1)."""
    from tilewright.kernels.relaxation import grow_tiles

    near = (cuts.crossed > 0)[..., np.newaxis]
    n = near.shape[1]
    if not cuts.shared.corners:  # what lies at the corners of Wang tiles is not known to all of them
        near[:, :: n - 1, :: n - 1] = False
    wider = np.empty_like(near)
    for _ in range(reach - 1):
        grow_tiles(len(near), near[..., 0], cuts.beside, wider[..., 0])
        near, wider = wider, near
    same = near.astype(np.float32)
    cuts.shared.settle_border(same)
    return same > 0.999
