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
    extent : tuple of float, optional
        Width and height, each 1e-100 to 1e100; a third number, the depth, makes a volume. Default (1, 1).
    torus : bool, optional
        Whether opposite sides meet, so that distances go around; default True.

    Raises
    ------
    TilewrightTypeError
        The extent is not two or three numbers, or ``torus`` is not a truth value.
    TilewrightValueError
        A size that is zero, negative, not finite or NaN.

    Notes
    -----
    Lagae 2007, section 4.2.3 for planes and 4.6.1.2 for volumes, measures on unit tori.

    Examples
    --------
    >>> import tilewright as tw
    >>> box = tw.Box((2, 1), torus=False)
    >>> box.dimension, box.volume
    (2, 2.0)
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
        """Per axis, the length after which it repeats: float64, shape (d,); infinity where it does not."""
        return np.array(self.extent if self.torus else (inf,) * self.dimension)

    def check_points(self, points: ArrayLike) -> NDArray[np.float64]:
        """Refuse points outside the box.

        Parameters
        ----------
        points : array-like of float, shape (N, d)
            Coordinates, x first.

        Returns
        -------
        float64 array, shape (N, d)
            The points.

        Raises
        ------
        TilewrightTypeError
            The coordinates are not numbers.
        TilewrightValueError
            They have another shape, are not finite, or lie outside the box; the message names the first.
        """
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
