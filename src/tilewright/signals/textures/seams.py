"""Maps whose cuts are closed after copying: normals as vectors, heights by their slopes.

Color is cut where it fits, and stays as it was copied. A map of normals shows a cut as a crease of light, and
a map of heights as a cliff, however well the color fits there, so both are mended beside the cuts. What
lies over a tile's border takes part, and tiles that share a border stay alike there.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress
from tilewright.signals.textures.kinds import Values, from_values, is_normal, to_values
from tilewright.signals.textures.sharing import Rim, Shared, with_gutters
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
        self.here = origins.astype(np.int32)
        around = with_gutters(self.here, 1, shared)
        self.beyond = {step: _shift(around, step) for step in _STEPS}
        sizes = np.array([next(iter(s.values())).shape[:2] for s in sources], np.int32)
        self.crossed = {}
        for step, there in self.beyond.items():
            # A pair is closed only where both patches go on in their sources.
            inside = _is_inside(_back(there, step), sizes) & _is_inside(_on(self.here, step), sizes)
            self.crossed[step] = (there != _on(self.here, step)).any(axis=3) & inside

    def read(self, values: list[Values], spots: NDArray[np.int32]) -> Values:
        """Values of sources at (source, y, x), shape (k, 3)."""
        out = np.empty((len(spots), values[0].shape[2]), np.float32)
        for number, source in enumerate(values):
            mine = spots[:, 0] == number
            out[mine] = source[spots[mine, 1], spots[mine, 2]]
        return out


def _is_inside(origins: NDArray[np.int32], sizes: NDArray[np.int32]) -> NDArray[np.bool_]:
    spot = origins[..., 1:]
    return np.all((spot >= 0) & (spot < sizes[origins[..., 0]]), axis=3)


def _on(origins: NDArray[np.int32], step: tuple[int, int]) -> NDArray[np.int32]:
    """The origins a step further in the same source."""
    return origins + np.array((0, *step), np.int32)


def _back(origins: NDArray[np.int32], step: tuple[int, int]) -> NDArray[np.int32]:
    return origins - np.array((0, *step), np.int32)


def _blend_normals(pixels: NDArray[Any], cuts: Cuts, name: str, kind: str) -> NDArray[Any]:
    """Beside a cut, the sum of the patch's own vector and half of what the other patch has there."""
    sources = [to_values(s[name], kind) for s in cuts.sources]
    vectors = to_values(pixels, kind)
    touched = np.zeros(pixels.shape[:3], bool)
    for step, crossed in cuts.crossed.items():
        other = cuts.read(sources, _back(cuts.beyond[step][crossed], step))
        vectors[crossed] += np.float32(0.5) * other
        touched |= crossed
    count = 1 + np.float32(0.5) * sum(c.astype(np.float32) for c in cuts.crossed.values())
    vectors /= np.asarray(count)[..., np.newaxis]
    settled, _ = cuts.shared.settle(vectors, Rim(pixels.shape[1], 0, None))
    touched |= (settled != vectors).any(axis=3)
    blended = pixels.copy()
    blended[touched] = from_values(settled, kind, pixels)[touched]
    return blended


def _close_heights(pixels: NDArray[Any], cuts: Cuts, name: str, progress: Progress | None) -> NDArray[Any]:
    """Heights near cuts moved so that slopes go on over them (Perez et al. 2003, section 2, within a band).

    A correction is sought that jumps at cuts by what the heights there jump too much, and is smooth
    elsewhere: at each pixel the mean of its neighbors', relaxed until it settles (Chebyshev's semi-iteration,
    so that the rounds grow with the reach and not with its square).
    """
    sources = [to_values(s[name], "height") for s in cuts.sources]
    wanted = np.zeros(pixels.shape, np.float32)
    for step, crossed in cuts.crossed.items():
        here, there = cuts.here[crossed], cuts.beyond[step][crossed]
        ours, theirs = cuts.read(sources, here), cuts.read(sources, there)
        slope = cuts.read(sources, _on(here, step)) - ours + theirs - cuts.read(sources, _back(there, step))
        wanted[crossed] += (theirs - ours) - slope / 2
    n = pixels.shape[1]
    reach = max(2, round(REACH * n))
    band = _band(cuts, reach)
    correction, before = np.zeros((2, *pixels.shape), np.float32)
    rim = Rim(n, 0, None)
    slowest = np.cos(np.pi / (4 * reach))  # how much of the smoothest error a plain round leaves
    push, rounds = 1.0, ROUNDS * reach
    for done in range(rounds):
        if progress is not None:
            progress(done, rounds, f"closing {name}")
        around = with_gutters(correction, 1, cuts.shared)
        total = wanted + sum(_shift(around, step) for step in _STEPS)
        relaxed = cuts.shared.settle(np.where(band, total / 4, 0), rim)[0]
        push = 1 / (1 - slowest**2 / 2) if done == 1 else 1 / (1 - slowest**2 * push / 4) if done else 1.0
        correction, before = before + np.float32(push) * (relaxed - before), correction
    closed = pixels.copy()
    moved = np.broadcast_to(band, pixels.shape)
    closed[moved] = from_values(to_values(pixels, "height") + correction, "height", pixels)[moved]
    return closed


def _band(cuts: Cuts, reach: int) -> NDArray[np.bool_]:
    """Pixels near cuts, the same in all tiles along what they share; shape (T, n, n, 1)."""
    near = np.any(list(cuts.crossed.values()), axis=0)[..., np.newaxis]
    n = near.shape[1]
    if not cuts.shared.corners:  # what lies at the corners of Wang tiles is not known to all of them
        near[:, :: n - 1, :: n - 1] = False
    for _ in range(reach - 1):
        around = with_gutters(near, 1, cuts.shared)
        near = near | np.any([_shift(around, step) for step in _STEPS], axis=0)
    same, _ = cuts.shared.settle(near.astype(np.float32), Rim(n, 0, None))
    return same > 0.999


def _shift(around: NDArray[Any], step: tuple[int, int]) -> NDArray[Any]:
    """What lies a step away from each pixel, of tiles with a gutter of one pixel."""
    dy, dx = step
    n = around.shape[1] - 2
    return around[:, 1 + dy : 1 + dy + n, 1 + dx : 1 + dx + n]
