"""Tone laid over a plane: patches of a small picture of it, blended so that their variance stays.

Patches lie around the points of a grid of squares, each cut into two triangles (Heitz & Neyret 2018, section
3, with a grid that goes with the tiles', so that it closes on a torus as they do).
"""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.fields.photos.methods import mirrored
from tilewright.pixels import has_alpha
from tilewright.signals.textures.kinds import to_encoded, to_linear
from tilewright.signals.textures.tone import Texels, Tone, is_linear_light
from tilewright.tilings import Domain, LatticeHash
from tilewright.tilings.domain import fold
from tilewright.tilings.streams import TONES


class Window(NamedTuple):
    """Tone around a window of pixels.

    Attributes
    ----------
    texel : int
        Pixels along a texel.
    left, top : int
        Pixels from the north-west corner of the first texel to that of the window.
    maps : dict of str to float32 array, shape (rows, columns, channels)
    means : dict of str to float32 array, shape (channels,)
        Below these tone is a factor.
    """

    texel: int
    left: int
    top: int
    maps: dict[str, Texels]
    means: dict[str, NDArray[np.float32]]


def tone_window(
    tone: Tone, hash: LatticeHash, domain: Domain, x: int, y: int, width: int, height: int
) -> Window:
    """Texels around a window of pixels, as bilinear interpolation needs them.

    Parameters
    ----------
    hash : LatticeHash
        Where the tiling's chance comes from.
    domain : Domain
        That of the tiling, in cells.
    x, y, width, height : int
        The window in pixels.
    """
    t = tone.texel
    # Middles of texels lie half a texel inside.
    (left, top), (right, bottom) = (
        ((2 * a + 1 - t) // (2 * t), (2 * b + 1 - t) // (2 * t))
        for a, b in ((x, y), (x + width - 1, y + height - 1))
    )
    laid = _lay(tone, hash, domain, left, top, right - left + 2, bottom - top + 2)
    return Window(t, x - left * t, y - top * t, laid, {name: tone.mean(name) for name in laid})


def _lay(
    tone: Tone, hash: LatticeHash, domain: Domain, left: int, top: int, width: int, height: int
) -> dict[str, Texels]:
    """Texels of the plane from (left, top) on, shape (height, width, channels)."""
    tile = tone.tile_size // tone.texel
    spans = [_fitting(tone.span, period) for period in domain.periods]
    # Step 1: the square of the grid that each texel lies in, and where in it.
    (x0, px, i, u), (y0, py, j, v) = (
        _squares(first, count, span * tile)
        for first, count, span in zip((left, top), (width, height), spans, strict=True)
    )
    # Step 2: a place of the photograph for every point of the grid.
    points = (
        fold(first, int(cells[-1]) + 2, period and period // span)
        for first, cells, period, span in zip((x0, y0), (i, j), domain.periods, spans, strict=True)
    )
    places = hash.numbers(TONES, *np.meshgrid(*points))
    h, w = next(iter(tone.maps.values())).shape[:2]
    middles = (places >> 12) * h >> 12, (places & 4095) * w >> 12
    # Step 3: the triangle of each texel, a half of its square, and its barycentric coordinates.
    (u, v), (i, j) = np.meshgrid(u, v), np.meshgrid(i, j)
    far = u + v > 1
    weights = np.where(far, (u + v - 1, 1 - v, 1 - u), (1 - u - v, u, v))
    corners = ((i + far, j + far), (i + 1, j), (i, j + 1))
    # Step 4: three patches, mirrored at the borders of the photograph, blended.
    weights = weights / np.sqrt((weights**2).sum(axis=0))
    laid = {name: np.zeros((height, width, m.shape[2])) for name, m in tone.maps.items()}
    for weight, (ci, cj) in zip(weights, corners, strict=True):
        rows = mirrored(py[:, np.newaxis] - cj * (spans[1] * tile) + middles[0][cj, ci], h)
        columns = mirrored(px - ci * (spans[0] * tile) + middles[1][cj, ci], w)
        for name, texels in tone.maps.items():
            laid[name] += weight[..., np.newaxis] * texels[rows, columns]
    return {name: texels.astype(np.float32) for name, texels in laid.items()}


def _fitting(span: int, period: int | None) -> int:
    """Tiles from grid point to grid point, so that a period is a whole number of them."""
    return span if period is None else next(s for s in range(span, 0, -1) if period % s == 0)


def _squares(
    first: int, count: int, side: int
) -> tuple[int, NDArray[np.int64], NDArray[np.int64], NDArray[np.float64]]:
    """Of ``count`` texels from ``first`` on, in squares of ``side`` texels.

    The first square; each texel counted from that square's; how many squares farther it lies, and at what
    share of that one its middle is.
    """
    square, inside = divmod(first, side)
    texels = inside + np.arange(count)
    farther = texels // side
    return square, texels, farther, (texels - farther * side + 0.5) / side


def add_tone(out: NDArray[Any], laid: Window, name: str, kind: str) -> None:
    """Lay tone over a picture of a map of some kind, in place."""
    if is_linear_light(out, kind):
        shown = np.ascontiguousarray(to_encoded(out))
        _add(shown, laid, name)
        alpha = out[..., -1:].copy() if has_alpha(out.shape[-1]) else out[..., :0]
        out[...] = to_linear(np.maximum(shown, 0))
        out[..., out.shape[-1] - alpha.shape[-1] :] = alpha
        return
    _add(out, laid, name)
    if kind == "roughness" and out.dtype.kind == "f":
        np.clip(out, 0, 1, out=out)


def _add(out: NDArray[Any], laid: Window, name: str) -> None:
    from tilewright.kernels.toning import add_texels

    highest = np.float32(np.iinfo(out.dtype).max if out.dtype.kind == "u" else 0)
    texels, mean = laid.maps[name], laid.means[name]
    add_texels(len(out), texels, mean, laid.texel, laid.left, laid.top, highest, out)
