"""Where a sampler puts points: a rectangle or a torus; a box of any dimension."""

from dataclasses import dataclass
from math import inf, prod

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_flag, check_real, shape_error, type_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError

_SMALLEST, _LARGEST = 1e-100, 1e100


@dataclass(frozen=True)
class Box:
    """The domain of a point set: [0, extent[0]) x [0, extent[1]), x first.

    Parameters
    ----------
    extent : tuple of float
        Width and height; a third number makes a volume.
    torus : bool
        Whether opposite sides meet, so that distances go around.

    Raises
    ------
    TilewrightValueError
        A size that is zero, negative, not finite or NaN.
    """

    extent: tuple[float, ...] = (1.0, 1.0)
    torus: bool = True

    def __post_init__(self) -> None:
        if not isinstance(self.extent, (tuple, list, np.ndarray)) or len(self.extent) not in (2, 3):
            raise type_error("extent", self.extent, "two or three numbers, x first")
        check_flag("torus", self.torus)
        names = ("width", "height", "depth")
        sizes = (check_real(n, e, _SMALLEST, _LARGEST) for n, e in zip(names, self.extent, strict=False))
        object.__setattr__(self, "extent", tuple(sizes))

    @property
    def dimension(self) -> int:
        """2 for planes, 3 for volumes."""
        return len(self.extent)

    @property
    def volume(self) -> float:
        """Area, or volume in three dimensions."""
        return prod(self.extent)

    @property
    def periods(self) -> NDArray[np.float64]:
        """Per axis, the length after which it repeats; infinity where it does not."""
        return np.array(self.extent if self.torus else (inf,) * self.dimension)

    def check_points(self, points: ArrayLike) -> NDArray[np.float64]:
        """``points`` as float64, shape (N, d), each of them inside the box."""
        given = as_points(points, self.dimension)
        outside = ((given < 0) | (given >= self.extent)).any(axis=1)
        if outside.any():
            at = int(np.argmax(outside))
            raise TilewrightValueError(
                f"is {tuple(given[at].tolist())}, outside the domain from 0 up to {self.extent}",
                argument=f"point {at}",
                value=tuple(given[at].tolist()),
            )
        return given


def as_points(points: ArrayLike, dimension: int = 2) -> NDArray[np.float64]:
    """``points`` as float64, shape (N, d), finite."""
    try:
        given = np.ascontiguousarray(points, np.float64)
    except (TypeError, ValueError):
        raise TilewrightTypeError(
            "must be numbers, one row for each point",
            argument="points",
            allowed="numbers, one row for each point",
        ) from None
    if given.ndim != 2 or given.shape[1] != dimension:
        raise shape_error("points", given.shape, f"(N, {dimension})")
    bad = ~np.isfinite(given).all(axis=1)
    if bad.any():
        at = int(np.argmax(bad))
        raise TilewrightValueError(
            f"is {tuple(given[at].tolist())}; coordinates must be finite",
            argument=f"point {at}",
            value=tuple(given[at].tolist()),
        )
    return given
