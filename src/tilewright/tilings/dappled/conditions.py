"""What makes a tiling dappled: how long a run of a tile, or of tiles of a subset, may be."""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from math import inf
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import (
    as_array,
    as_integers,
    check_flag,
    check_function_of_place,
    check_int,
    check_type,
    range_error,
    shape_error,
    type_error,
)
from tilewright.errors import TilewrightValueError

Cells = NDArray[np.uint8]
Integers = NDArray[np.int64]
Most = int | float | ArrayLike | Callable[[Integers, Integers], ArrayLike]
"""A longest run: a number, `inf`, an array ``(height, width)``, or a function of arrays x and y."""

NEVER = 2**30
"""Stands for a run of any length."""
_MOST_TILES = 256
_MOST_SIDE = 65536


@dataclass(frozen=True)
class Limit:
    """One condition: H (along x) or V (along y), of which tiles, and the longest run of them."""

    axis: int
    tiles: tuple[int, ...]
    most: Any

    def __str__(self) -> str:
        return f"{'HV'[self.axis]}{'+'.join(map(str, self.tiles))}"

    def on(self, shape: tuple[int, int]) -> NDArray[np.int32]:
        """The longest run allowed to end at each cell: int32, ``shape``, or (1, 1) where all are the same."""
        given = self.most
        if callable(given):
            given = given(*np.meshgrid(np.arange(shape[1]), np.arange(shape[0])))
        return _as_most(str(self), given, shape)


class Conditions:
    """The conditions L that make a tiling dappled: how long a run of a tile, or of tiles of a subset, may be.

    Parameters
    ----------
    limits : mapping of str to longest run, or Conditions
        ``"H0"`` limits horizontal runs of tile 0, ``"V1"`` vertical runs of tile 1, ``"H0+2"`` horizontal
        runs of tiles 0 and 2. A longest run is a number from 0 on, `math.inf`, an array of shape (height,
        width) or a function of x and y, two arrays of one shape, to an array of that shape: the longest that
        may end at that cell, looking west or north.
    tiles : int, optional
        Number of tiles, 2 to 256; by default one more than the largest named, at least 2.

    Attributes
    ----------
    limits : tuple of Limit
        Each condition, as axis, tiles and longest run.
    tiles : int
        Number of tiles.

    Raises
    ------
    TilewrightTypeError
        The limits are not a mapping.
    TilewrightValueError
        A name that is none of these, or a tile or a number out of range.

    Notes
    -----
    H_t^p and V_t^q of Kaji et al. 2016, definition 1.1; limits that vary over cells are of section 3.1,
    subsets of tiles, H_tau^p, of section 6 (2).
    """

    def __init__(self, limits: "Mapping[str, Most] | Conditions", tiles: int | None = None) -> None:
        self.limits: tuple[Limit, ...]
        self.tiles: int
        if isinstance(limits, Conditions):
            self.limits = limits.limits
            tiles = limits.tiles if tiles is None else tiles
        else:
            check_type("limits", limits, Mapping, "a mapping such as {'H0': 2, 'V1': 2}")
            self.limits = tuple(_parse(name, most) for name, most in limits.items())
        named = max((t for limit in self.limits for t in limit.tiles), default=0)
        self.tiles = max(named + 1, 2) if tiles is None else check_int("tiles", tiles, 2, _MOST_TILES)
        if named >= self.tiles:
            raise TilewrightValueError(
                f"name tile {named}; there are tiles 0 to {self.tiles - 1}", argument="limits"
            )

    def __repr__(self) -> str:
        written = ", ".join(f"{limit}: {_brief(limit.most)}" for limit in self.limits)
        return f"<Conditions on {self.tiles} tiles: {written}>"

    @property
    def is_single(self) -> bool:
        """Whether every condition is about one tile."""
        return all(len(limit.tiles) == 1 for limit in self.limits)

    def table(self, axis: int, shape: tuple[int, int]) -> NDArray[np.int32]:
        """Tabulate the longest run of each single tile along an axis.

        Parameters
        ----------
        axis : int
            0 for horizontal runs, 1 for vertical ones.
        shape : tuple of (int, int)
            Height and width of the tiling.

        Returns
        -------
        int32 array, shape (T, height or 1, width or 1)
            The longest run of each tile that may end at a cell; 2^30 where any may.
        """
        ours = [(limit, limit.on(shape)) for limit in self.limits if limit.axis == axis]
        size = np.broadcast_shapes((1, 1), *(most.shape for _, most in ours))
        most = np.full((self.tiles, *size), NEVER, np.int32)
        for limit, here in ours:
            for tile in limit.tiles if len(limit.tiles) == 1 else ():
                np.minimum(most[tile], here, out=most[tile])
        return most

    def windows(self, shape: tuple[int, int], *, cyclic: bool) -> Iterator[tuple[Limit, Integers]]:
        """List all strips of cells that must not lie in the tiles of one limit.

        Parameters
        ----------
        shape : tuple of (int, int)
            Height and width of the tiling.
        cyclic : bool
            Whether rows and columns close to rings.

        Yields
        ------
        limit : Limit
            One of the conditions.
        strips : int64 array, shape (strips, length)
            Numbers y * width + x of the cells of each strip.
        """
        number = np.arange(shape[0] * shape[1]).reshape(shape)
        for limit in self.limits:
            most = np.broadcast_to(limit.on(shape), shape)
            size = shape[1 - limit.axis]
            for p in np.unique(most[most < NEVER]):
                if p >= size and not cyclic:
                    continue
                ends = most == p
                if not cyclic:
                    ends = ends & (np.indices(shape)[1 - limit.axis] >= p)
                steps = range(min(int(p) + 1, size))
                strips = [np.roll(number, step, 1 - limit.axis)[ends] for step in steps]
                yield limit, np.stack(strips, axis=-1)


def _parse(name: Any, most: Any) -> Limit:
    found = re.fullmatch(r"([HV])(\d{1,3}(?:\+\d{1,3})*)", name) if isinstance(name, str) else None
    if not found:
        raise TilewrightValueError(
            f"name {name!r}; expected H or V and tiles, such as 'H0', 'V1' or 'H0+2'",
            argument="limits",
            allowed="H or V and tiles, such as 'H0', 'V1' or 'H0+2'",
        )
    tiles = tuple(sorted({check_int(name, int(t), 0, _MOST_TILES - 1) for t in found[2].split("+")}))
    if callable(most):
        check_function_of_place(f"the limit of {name}", most)
    else:
        most = _as_most(name, most, None)
    return Limit("HV".index(found[1]), tiles, most)


def _as_most(name: str, given: Any, shape: tuple[int, int] | None) -> NDArray[np.int32]:
    """Longest runs as int32, (1, 1) or ``shape``; where ``shape`` is None, whatever two axes there are."""
    what = f"the limit of {name}"
    most = as_array(what, given)
    if most.dtype.kind not in "iuf":
        raise type_error(what, given, "an integer or inf")
    if most.size == 0 or np.isnan(most).any() or (most < 0).any() or (most[most < inf] % 1 != 0).any():
        raise TilewrightValueError(
            f"is {_brief(most)}; allowed are 0, 1, 2, ... and inf",
            argument=what,
            value=most,
            allowed="0, 1, 2, ... and inf",
        )
    most = np.minimum(most, NEVER).astype(np.int32)
    if most.ndim == 0:
        return most.reshape(1, 1)
    if most.ndim != 2 or (shape is not None and most.shape not in ((1, 1), tuple(shape))):
        expected = "(height, width)" if shape is None else str(tuple(shape))
        raise shape_error(what, most.shape, expected)
    return most


def _brief(most: Any) -> str:
    if callable(most):
        return "function"
    most = np.asarray(most)
    if most.size > 1:
        return f"array {most.shape}"
    return "inf" if most.size and most.item() >= NEVER else str(most.item() if most.size else "empty")


def as_mapping(name: str, given: Any) -> Mapping[Any, Any]:
    """A mapping, or an empty one for None."""
    return check_type(name, {} if given is None else given, Mapping, "a mapping such as {0: 12}")


def as_cells(name: str, given: ArrayLike, tiles: int, *, free: bool = False) -> NDArray[Any]:
    """A rectangle of tiles 0 to ``tiles`` - 1 as a new array [y, x]; -1 too where cells may be free."""
    truths = isinstance(given, np.ndarray) and given.dtype == bool
    cells = as_integers(name, given.astype(np.uint8) if truths else given)  # type: ignore[union-attr]
    if cells.ndim != 2 or cells.size == 0 or max(cells.shape) > _MOST_SIDE:
        raise shape_error(name, cells.shape, f"(height, width), sides 1 to {_MOST_SIDE}")
    low = -1 if free else 0
    if cells.min() < low or cells.max() >= tiles:
        raise range_error(name, cells, f"{low} to {tiles - 1}")
    return cells.astype(np.int16 if free else np.uint8)


def find_violations(
    tiling: ArrayLike,
    limits: Mapping[str, Most] | Conditions,
    *,
    cyclic: bool = False,
    tiles: int | None = None,
) -> dict[str, NDArray[np.bool_]]:
    """Find where runs that are too long end, for each condition.

    It is the check of dappled tilings, independent of every method that makes them.

    Parameters
    ----------
    tiling : array-like of int, shape (height, width)
        The tile of each cell, 0 to 255.
    limits : mapping of str to longest run, or Conditions
        Such as ``{"H0": 2, "V1": 2}``; see `Conditions`.
    cyclic : bool, optional
        Whether rows and columns close to rings; default False. A ring of one tile is a run without end, so
        that it violates every finite limit.
    tiles : int, optional
        Number of tiles, 2 to 256; by default one more than the largest that is named.

    Returns
    -------
    dict of str to bool array, shape (height, width)
        For each condition, such as ``"H0"``, the cells where a run that is too long goes on; a dappled tiling
        has none.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A tile or a number is out of range, or an array has another shape.

    Notes
    -----
    Kaji et al. 2016, definition 1.1.

    Examples
    --------
    >>> import tilewright as tw
    >>> found = tw.find_violations([[0, 0, 0, 1]], {"H0": 2, "V1": 2})
    >>> found["H0"].tolist()
    [[False, False, True, False]]
    """
    conditions = Conditions(limits, tiles)
    check_flag("cyclic", cyclic)
    cells = as_cells("tiling", tiling, conditions.tiles)
    found: dict[str, NDArray[np.bool_]] = {}
    for limit in conditions.limits:
        axis = 1 - limit.axis
        runs = _runs(np.moveaxis(np.isin(cells, limit.tiles), axis, 1), cyclic)
        bad = (np.moveaxis(runs, 1, axis) > limit.on(cells.shape)) & (limit.on(cells.shape) < NEVER)
        found[str(limit)] = found.get(str(limit), False) | bad
    return found


def _runs(member: NDArray[np.bool_], cyclic: bool) -> Integers:
    """Length of the run of True along the rows that ends at each place; 2^31 in a ring of nothing else."""
    width = member.shape[1]
    line = np.concatenate([member, member], axis=1) if cyclic else member
    at = np.arange(line.shape[1])
    last_break = np.maximum.accumulate(np.where(line, -1, at), axis=1)
    runs = (at - last_break)[:, -width:]
    if cyclic:
        runs[member.all(axis=1)] = 2**31
    return runs


def explain_violation(found: Mapping[str, NDArray[np.bool_]]) -> str | None:
    """One line about the first violation in reading order, or None."""
    places = [(*map(int, np.argwhere(bad)[0]), name) for name, bad in found.items() if bad.any()]
    if not places:
        return None
    y, x, name = min(places)
    count = sum(int(bad.sum()) for bad in found.values())
    return f"{count} runs are too long, the first one against {name}, ending at cell x={x}, y={y}"
