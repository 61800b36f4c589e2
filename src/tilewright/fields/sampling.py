"""Pixels of a plane at scattered places, between pixels and seen from afar.

Colors are averaged as light and normals as vectors, as mip levels are (Williams 1983, "Pyramidal
parametrics"): for a footprint of s pixels the plane is reduced by the power of two that is nearest to s, and
read there between the centers of four texels.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from math import log2
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_int, check_real
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.signals.textures.kinds import from_values, is_signed, to_values
from tilewright.tilings import Domain

MOST_FOOTPRINT = 1024
"""Pixels along a footprint: a texel of it is a mean of up to a million pixels."""
_TEXELS = 32
"""Texels along a block that is rendered at once."""
_BAND = 2**18
"""Pixels of a scaled picture that are read at once."""
_FAR = 2.0**52
"""Beyond it a float has no fractions of a pixel."""

Render = Callable[[int, int, int, int], NDArray[Any]]
"""Gives the pixels of a window x, y, width, height."""


@dataclass(frozen=True, eq=False)
class FarView:
    """Places near an origin that may be far out, in coordinates that floats hold exactly.

    Attributes
    ----------
    base : tuple of int
        Where these coordinates begin: a whole number of the largest footprints from the plane's origin, so
        that reduced pixels are the same ones from everywhere.
    points : float64 array, shape (n, 2)
    shape : tuple of int
        The axes of the points as they were given.
    domain : Domain
        Where there are pixels, in these coordinates.
    """

    base: tuple[int, int]
    points: NDArray[np.float64]
    shape: tuple[int, ...]
    domain: Domain

    @classmethod
    def of(cls, domain: Domain, origin: Any, points: ArrayLike) -> "FarView":
        """Check places and bring them near."""
        at = check_places(points)
        if not isinstance(origin, (tuple, list)) or len(origin) != 2:
            raise TilewrightTypeError("must be two whole numbers, x first", argument="origin", value=origin)
        x, y = (check_int("origin", n, -(2**80), 2**80) for n in origin)
        base = tuple(n - n % MOST_FOOTPRINT for n in (x, y))
        near = at.reshape(-1, 2) + np.array([x - base[0], y - base[1]])
        bounds = tuple(b and (b[0] - n, b[1] - n) for b, n in zip(domain.bounds, base, strict=True))
        for axis, bound in enumerate(bounds):
            if bound is not None and not ((near[:, axis] >= bound[0]) & (near[:, axis] <= bound[1])).all():
                low, high = (n + base[axis] for n in bound)
                raise TilewrightValueError(
                    f"lie outside the plane, which goes from {low} to {high} along {'xy'[axis]}",
                    argument="points",
                )
        return cls((base[0], base[1]), near, at.shape[:-1], replace(domain, bounds=bounds))

    def place(self, x: int, y: int) -> tuple[int, int]:
        """A pixel of the plane."""
        return x + self.base[0], y + self.base[1]


def check_places(points: ArrayLike) -> NDArray[np.float64]:
    """Places as floats, shape (..., 2)."""
    try:
        at = np.asarray(points, np.float64)
    except (TypeError, ValueError):
        problem = "must be numbers, shape (..., 2)"
        raise TilewrightTypeError(problem, argument="points", value=points) from None
    if at.ndim < 1 or at.shape[-1] != 2:
        raise TilewrightValueError(
            f"has shape {at.shape}; expected (..., 2), x first", argument="points", value=at.shape
        )
    if not (np.abs(at) <= _FAR).all():
        raise TilewrightValueError("must be finite, and up to 2^52 pixels from the origin", argument="points")
    return at


def sample_pixels(
    render: Render, domain: Domain, kind: str, points: NDArray[np.float64], footprint: float
) -> NDArray[Any]:
    """The pixels at places, shape (n, 2) in pixels, read as the module says; shape (n, channels)."""
    step = 2 ** round(log2(max(check_real("footprint", footprint, 0, MOST_FOOTPRINT), 1)))
    # Texel k of the reduced plane has its center at (k + 1/2) step.
    at = points / step - 0.5
    texel = np.floor(at).astype(np.int64)
    share = (at - texel).astype(np.float32)
    taken: NDArray[Any] | None = None
    for where, block in _by_block(texel // _TEXELS):
        first = block * _TEXELS
        pixels, low = _render_texels(render, domain, first, step)
        signed = is_signed(pixels) if kind.startswith("normal") else None
        values = _reduce(to_values(pixels, kind, signed), step)
        found = _read_between(values, texel[where] - low, share[where])
        part = from_values(found[:, np.newaxis], kind, pixels, signed)[:, 0]
        taken = np.empty((len(points), part.shape[1]), part.dtype) if taken is None else taken
        taken[where] = part
    if taken is None:  # no places: only the type of pixels is asked for
        (x, _), (y, _) = (bound or (0, 0) for bound in domain.bounds)
        return render(x, y, 1, 1)[0, :0]
    return taken


def _by_block(blocks: NDArray[np.int64]) -> Iterator[tuple[NDArray[np.int64], NDArray[np.int64]]]:
    """For each block that places lie in, their numbers and its own."""
    if not len(blocks):
        return
    order = np.lexsort(blocks.T)
    changes = (np.diff(blocks[order], axis=0) != 0).any(axis=1).nonzero()[0] + 1
    for where in np.split(order, changes):
        yield where, blocks[where[0]]


def _render_texels(
    render: Render, domain: Domain, first: NDArray[np.int64], step: int
) -> tuple[NDArray[Any], NDArray[np.int64]]:
    """The pixels of a block of texels and of one more to the south and east, and its first texel.

    Where the plane ends, its last whole texel is the last.
    """
    low, count = [], []
    for axis, bound in enumerate(domain.bounds):
        start, stop = int(first[axis]), int(first[axis]) + _TEXELS + 1
        if bound is not None:
            least, most = -(-bound[0] // step), bound[1] // step
            if most <= least:
                raise TilewrightValueError(
                    f"is about {step} pixels, and the plane has {bound[1] - bound[0]}", argument="footprint"
                )
            start, stop = min(max(start, least), most - 1), max(min(stop, most), least + 1)
        low.append(start)
        count.append(stop - start)
    x, y = (n * step for n in low)
    return render(x, y, count[0] * step, count[1] * step), np.array(low)


def _reduce(values: NDArray[np.float32], step: int) -> NDArray[np.float32]:
    """Means of step x step values."""
    if step == 1:
        return values
    height, width, channels = values.shape
    blocks = values.reshape(height // step, step, width // step, step, channels)
    return blocks.mean(axis=(1, 3), dtype=np.float32)


def _read_between(
    values: NDArray[np.float32], texel: NDArray[np.int64], share: NDArray[np.float32]
) -> NDArray[np.float32]:
    """Values between four texels, the one at ``texel`` and its neighbors to the south and east."""
    most = np.array(values.shape[1::-1]) - 1
    (x0, y0), (x1, y1) = (np.clip(texel + more, 0, most).T for more in (0, 1))
    u, v = share.T[:, :, np.newaxis]
    north = values[y0, x0] * (1 - u) + values[y0, x1] * u
    south = values[y1, x0] * (1 - u) + values[y1, x1] * u
    return np.asarray(north * (1 - v) + south * v)


def scaled_sides(width: int, height: int, scale: float) -> tuple[int, int]:
    """Width and height of a picture of a window."""
    check_real("scale", scale, 1 / MOST_FOOTPRINT, 64)
    return max(1, round(width * scale)), max(1, round(height * scale))


def scaled_pixels(
    at: Callable[[NDArray[np.float64]], NDArray[Any]],
    scale: float,
    part: tuple[int, int, int, int],
    out: NDArray[Any],
) -> NDArray[Any]:
    """Fill part x, y, width, height of a scaled picture; ``at`` reads places counted from its corner."""
    left, top, columns, rows = part
    x = (left + np.arange(columns) + 0.5) / scale
    band = max(1, _BAND // columns)
    for first in range(0, rows, band):
        y = (top + np.arange(first, min(first + band, rows)) + 0.5) / scale
        out[first : first + band] = at(np.stack(np.meshgrid(x, y), axis=-1))
    return out
