"""What an exemplar repeats by itself: a period (weave, paving), or a hidden copy of itself."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft2, next_fast_len, rfft2
from scipy.ndimage import gaussian_filter, maximum_filter

from tilewright.checks import check_type, shape_error

PERIODIC = 0.5
"""Autocorrelation from which an exemplar counts as periodic."""
CLONED = 0.55
"""Autocorrelation at one far lag, alone, from which an exemplar counts as containing itself twice."""
_LARGEST_SIDE = 1024


@dataclass(frozen=True)
class Regularity:
    """How an exemplar repeats by itself.

    Attributes
    ----------
    period : (float or None, float or None)
        Vertical and horizontal spacing of rows and columns in pixels, None where there is none.
    strength : (float, float)
        Autocorrelation of the picture itself at those lags, 0 to 1; low where only the courses repeat.
    clone : (int, int) or None
        Lag (y, x) in pixels at which the exemplar shows itself a second time, None if it does not.
    """

    period: tuple[float | None, float | None]
    strength: tuple[float, float]
    clone: tuple[int, int] | None

    @property
    def shortest_period(self) -> float | None:
        """The shorter period in pixels of an exemplar that is periodic, else None."""
        strong = [p for p, s in zip(self.period, self.strength, strict=True) if p and s >= PERIODIC]
        return min(strong, default=None)


def find_regularity(pixels: NDArray[Any]) -> Regularity:
    """Find the periods and hidden copies in one map, from its autocorrelation.

    Parameters
    ----------
    pixels : array, shape (h, w, channels)
        Any type of numbers; channels are averaged.

    Returns
    -------
    Regularity
        Periods in pixels, how strong they are, and where the map shows itself again.

    Raises
    ------
    TilewrightTypeError
        Something else than an array.
    TilewrightValueError
        An array of another shape.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> checks = np.kron(np.indices((16, 16)).sum(axis=0) % 2, np.ones((10, 10)))[..., np.newaxis]
    >>> tw.find_regularity(checks).clone is None
    True
    """
    check_type("pixels", pixels, np.ndarray, "an array")
    if pixels.ndim != 3 or 0 in pixels.shape:
        raise shape_error("pixels", pixels.shape, "(height, width, channels), none of them 0")
    step = -(-max(pixels.shape[:2]) // _LARGEST_SIDE)
    gray = pixels[::step, ::step].astype(np.float32).mean(axis=2)
    gray -= gaussian_filter(gray, min(gray.shape) / 8)
    lags = autocorrelation(gray)
    # Paving repeats its courses but not its stones, so rows and columns are looked at as a whole.
    periods = [
        _axis_period(autocorrelation(gray.mean(axis=1, keepdims=True))[: len(gray) * 2 // 3, 0]),
        _axis_period(autocorrelation(gray.mean(axis=0, keepdims=True))[0, : len(gray[0]) * 2 // 3]),
    ]
    strengths = [
        0.0 if p is None else float(along[round(p) - 2 : round(p) + 3].max())
        for p, along in zip(periods, (lags[:, 0], lags[0]), strict=True)
    ]
    clone = _find_clone(lags)
    return Regularity(
        (periods[0] and periods[0] * step, periods[1] and periods[1] * step),
        (strengths[0], strengths[1]),
        None if clone is None else (clone[0] * step, clone[1] * step),
    )


def autocorrelation(gray: NDArray[np.float32]) -> NDArray[np.float32]:
    """Correlation of the two overlapping parts at each lag; element (y, x), x from -w/2 wrapping around.

    Lags reach three quarters of the size; beyond that the overlap is too small and 0 stands there.
    """
    h, w = gray.shape
    size = (next_fast_len(2 * h, real=True), next_fast_len(2 * w, real=True))
    ones, grays, squares = (
        rfft2(part.astype(float), size) for part in (np.ones_like(gray), gray, gray * gray)
    )

    def correlate(a: NDArray[np.complex128], b: NDArray[np.complex128]) -> NDArray[np.float64]:
        return irfft2(np.conj(a) * b, size)

    count = np.maximum(correlate(ones, ones), 1)
    mean_a, mean_b = correlate(grays, ones) / count, correlate(ones, grays) / count
    var_a = correlate(squares, ones) / count - mean_a**2
    var_b = correlate(ones, squares) / count - mean_b**2
    both = correlate(grays, grays) / count - mean_a * mean_b
    lags = both / np.sqrt(np.maximum(var_a * var_b, 1e-12 * max(float(gray.var()), 1e-12) ** 2))
    lags[count < h * w / 8] = 0
    return np.clip(lags, -1, 1).astype(np.float32)


def _axis_period(along: NDArray[np.float32]) -> float | None:
    """The shortest lag whose multiples all stand out about as much, in pixels.

    A weave has peaks at every thread, but only those at whole checks keep their height.
    """
    reach = len(along) // 2
    peaks = [k for k in range(6, reach) if along[k] == along[max(0, k - 4) : k + 5].max() and along[k] > 0.4]
    tallest = max((along[k] for k in peaks), default=0)
    for k in peaks:
        multiples = _follow_multiples(along, k)
        if len(multiples) > 1 and min(along[m] for m in multiples) >= 0.7 * tallest:
            return float(np.median([m / n for n, m in enumerate(multiples, 1)]))
    return None


def _follow_multiples(along: NDArray[np.float32], period: int) -> list[int]:
    """Lags of the peaks at 1, 2, 3 ... periods, each found near where the last one points."""
    found = [period]
    while (next_ := round(found[-1] * (len(found) + 1) / len(found))) < len(along) - 3:
        near = along[next_ - 3 : next_ + 4]
        found.append(next_ - 3 + int(np.argmax(near)))
    return found


def _find_clone(lags: NDArray[np.float32]) -> tuple[int, int] | None:
    """A lone sharp peak far from the origin."""
    h, w = lags.shape
    y, x = np.meshgrid(np.arange(h), np.arange(w), indexing="ij")
    y, x = np.where(y > h // 2, y - h, y), np.where(x > w // 2, x - w, x)
    away = np.hypot(y / h, x / w)  # in twice the size of the exemplar
    far = np.where((away > 0.1) & (y >= 0), lags, -1)
    at = np.unravel_index(int(np.argmax(far)), far.shape)
    height = far[at]
    near = lags[(away > 0.02) & (away < 0.08)]
    sharp = height - maximum_filter(lags, 3)[(at[0] + 6) % h, (at[1] + 6) % w]
    if height < CLONED or near.max(initial=0) > height / 2 or sharp < height / 4:
        return None
    return int(y[at]), int(x[at])


def suited_tile_size(regularity: Regularity, about: int = 128) -> int:
    """An even tile size near ``about`` that is a whole number of periods, if there are any."""
    wanted = [p for p in regularity.period if p and p <= 2 * about]
    if not wanted:
        return about
    sizes = np.arange(about * 3 // 4 // 2 * 2, about * 2 + 1, 2)
    # A size that fits one axis well beats one that half fits both.
    off = sum(np.minimum(np.abs(sizes - np.maximum(1, np.round(sizes / p)) * p), 6) for p in wanted)
    # Among sizes that fit about equally well, the one nearest to what was asked.
    return int(sizes[np.argmin(off + np.abs(sizes - about) * 0.01)])


def misfit_of_size(regularity: Regularity, size: int) -> float:
    """Pixels by which a tile of this size misses a whole number of strong periods; 0 without any."""
    return max(
        (
            abs(size - max(1, round(size / p)) * p)
            for p, s in zip(regularity.period, regularity.strength, strict=True)
            if p and s >= PERIODIC
        ),
        default=0.0,
    )
