"""Dappled tilings of the endless plane, evaluated anywhere."""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import check_function_of_place, check_real
from tilewright.errors import TilewrightValueError
from tilewright.seeds import check_seed
from tilewright.showing import describe
from tilewright.tiles import free_tiles
from tilewright.tilings.dappled.conditions import NEVER, Cells, Conditions, Most, as_cells
from tilewright.tilings.dappled.surgery import is_remark
from tilewright.tilings.domain import Domain
from tilewright.tilings.streams import DAPPLE_ENDLESS
from tilewright.tilings.tiling import Tiling

SIDE = 256
"""Cells along the side of the blocks that are rectified by themselves."""

Start = float | Callable[[NDArray[np.int64], NDArray[np.int64]], ArrayLike]


class EndlessDappledTiling(Tiling):
    """A dappled tiling of the plane with two tiles; made by `endless_dappled_tiling`.

    Its tiles are `free_tiles`, so that every signal made for two of those lies on it.

    Parameters
    ----------
    conditions : Conditions
        Constant limits of single tiles.
    start : float or callable
        The share of tile 1, or a function of int64 arrays x and y to tiles.
    seed : int
        Where chance begins, 0 to 2^64 - 1.

    Attributes
    ----------
    conditions : Conditions
        As given.
    start : float or callable
        As given.
    domain : Domain
        The plane.

    Notes
    -----
    Kaji et al. 2016, section 6 (5).
    """

    def __repr__(self) -> str:
        start = "function" if callable(self.start) else f"{self.start:g}"
        return describe(self, repr(self.conditions), f"start {start}", f"seed {int(self.seed) % 2**64}")

    def __init__(self, conditions: Conditions, start: Start, seed: int) -> None:
        self.tiles = free_tiles(2)
        self.conditions = conditions
        self.start = start
        self.seed = np.uint64(seed).astype(np.int64)
        self.domain = Domain.plane(None)
        self._most = [conditions.table(axis, (1, 1)) for axis in (0, 1)]
        self._across = int(np.argmin(self._most[0][:, 0, 0]))

    def cells(self, x: int, y: int, width: int, height: int) -> Cells:
        """Give the tiles of a window as bytes, a quarter of what `indices` takes; otherwise the same.

        Parameters
        ----------
        x : int
            First cell along x, within +-2^61.
        y : int
            First cell along y, within +-2^61.
        width : int
            Cells along x; a window has 2^31 of them at most.
        height : int
            Cells along y.

        Returns
        -------
        uint8 array, shape (height, width)
            Tiles 0 and 1.

        Raises
        ------
        TilewrightTypeError
            An argument of a wrong type.
        TilewrightValueError
            The window is too large or too far out, or ``start`` gives something but 0 and 1.
        """
        self.domain.check_window((x, y), (width, height))
        return self._cells(x, y, width, height)

    def _fill(self, start: tuple[int, ...], out: NDArray[np.int32]) -> None:
        (x, y), (height, width) = start, out.shape
        out[...] = self._cells(x, y, width, height)

    def _cells(self, x: int, y: int, width: int, height: int) -> Cells:
        from tilewright.kernels.dappling import fill_blocks

        out = np.empty((height, width), np.uint8)
        given, threshold = np.empty((0, 0), np.uint8), 0
        if callable(self.start):
            given = self._evaluate(self.start, x, y, width, height)
        else:
            threshold = round(self.start * 2**31)
        columns, rows = ((at + size - 1) // SIDE - at // SIDE + 1 for at, size in ((x, width), (y, height)))
        chance = (self.seed, DAPPLE_ENDLESS, threshold, given)
        fill_blocks(columns * rows, x, y, SIDE, *chance, *self._most, self._across, out)
        return out

    def _evaluate(
        self,
        start: Callable[[NDArray[np.int64], NDArray[np.int64]], ArrayLike],
        x: int,
        y: int,
        width: int,
        height: int,
    ) -> Cells:
        """The start on whole blocks and two cells more."""
        across, down = (
            np.arange(at // SIDE * SIDE, -(-(at + size) // SIDE) * SIDE + 2)
            for at, size in ((x, width), (y, height))
        )
        shape = (down.size, across.size)
        found = np.asarray(start(*np.meshgrid(across, down)))
        try:
            given = np.broadcast_to(found, shape)
        except ValueError:
            raise TilewrightValueError(
                f"gave shape {found.shape}; expected {shape}", argument="start", allowed=f"{shape}"
            ) from None
        return as_cells("start", given, 2).astype(np.uint8)


def endless_dappled_tiling(
    limits: Mapping[str, Most] | Conditions, *, start: Start = 0.5, seed: int = 0
) -> EndlessDappledTiling:
    """Make a dappled tiling of the endless plane, whose cells depend on their place and the seed only.

    The plane is cut into blocks of 256 x 256 cells. The first two rows and columns of each alternate and
    depend on the start alone; so every block can be rectified by itself, and blocks run in parallel.

    Parameters
    ----------
    limits : mapping of str to longest run, or Conditions
        Such as ``{"H0": 2, "V1": 2}``; see `Conditions`. Constant limits of two tiles: all from 3 on, or one
        horizontal limit of one tile and one vertical limit of the other, from 2 on.
    start : float or callable, optional
        The tiling to follow: the share of tile 1, 0 to 1, or a function of int64 arrays x and y to tiles 0
        and 1; default 0.5.
    seed : int, optional
        Where chance begins, 0 to 2^64 - 1; default 0.

    Returns
    -------
    EndlessDappledTiling
        Its ``cells`` give any window.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The limits are others, or a number is out of range.

    Notes
    -----
    Kaji et al. 2016, section 6 (5), with the first rows and columns of remark 3.4.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiling = tw.endless_dappled_tiling({"H0": 2, "V1": 2}, seed=3)
    >>> tiling.cells(-10**12, 5, 4, 2).shape
    (2, 4)
    """
    conditions = Conditions(limits)
    given = [limit.most for limit in conditions.limits]
    if conditions.tiles != 2 or not conditions.is_single or any(callable(m) or m.size > 1 for m in given):
        raise TilewrightValueError(
            "must be constant and of single tiles, of two, for an endless tiling",
            argument="limits",
            allowed="constant and of single tiles, of two, for an endless tiling",
        )
    least = min((int(most.min()) for most in given), default=NEVER)
    if least < 2 or (least == 2 and not is_remark(conditions.limits, 2, (1, 1))):
        raise TilewrightValueError(
            f"go down to {least}; an endless tiling needs limits from 3 on, or from 2 on for just one "
            "horizontal limit of one tile and one vertical limit of the other",
            argument="limits",
        )
    if callable(start):
        check_function_of_place("start", start)
    else:
        check_real("start", start, 0, 1)
    return EndlessDappledTiling(conditions, start, check_seed(seed))
