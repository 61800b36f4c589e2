"""What makes a tiling dappled: how long a run of a tile, or of tiles of a subset, may be."""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from math import inf
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_integers, check_function_of_place, check_int
from tilewright.errors import TilewrightTypeError, TilewrightValueError

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
    """A set of conditions L on tilings with ``tiles`` tiles.

    Parameters
    ----------
    limits : mapping of str to longest run
        ``"H0"`` limits horizontal runs of tile 0, ``"V1"`` vertical runs of tile 1 (H_t^p and V_t^q of Kaji
        et al. 2016, definition 1.1), ``"H0+2"`` horizontal runs of tiles 0 and 2 (H_tau^p, section 6 (2)).
        A longest run is a number from 0 on, `math.inf`, an array ``(height, width)`` or a function of x and
        y, two arrays of one shape, to an array of that shape: what may end at that cell, looking west or
        north (section 3.1).
    tiles : int, optional
        Number of tiles; by default one more than the largest named, at least 2.

    Raises
    ------
    TilewrightValueError, TilewrightTypeError
        A name that is none of these, a tile or a number out of range.
    """

    def __init__(self, limits: "Mapping[str, Most] | Conditions", tiles: int | None = None) -> None:
        self.limits: tuple[Limit, ...]
        self.tiles: int
        if isinstance(limits, Conditions):
            self.limits = limits.limits
            tiles = limits.tiles if tiles is None else tiles
        elif isinstance(limits, Mapping):
            self.limits = tuple(_parse(name, most) for name, most in limits.items())
        else:
            raise TilewrightTypeError(
                f"limits must be a mapping such as {{'H0': 2, 'V1': 2}}, not {type(limits).__name__}"
            )
        named = max((t for limit in self.limits for t in limit.tiles), default=0)
        self.tiles = max(named + 1, 2) if tiles is None else check_int("tiles", tiles, 2, _MOST_TILES)
        if named >= self.tiles:
            raise TilewrightValueError(f"limits name tile {named}; there are tiles 0 to {self.tiles - 1}")

    def __repr__(self) -> str:
        written = ", ".join(f"{limit}: {_brief(limit.most)}" for limit in self.limits)
        return f"<Conditions on {self.tiles} tiles: {written}>"

    @property
    def is_single(self) -> bool:
        """Whether every condition is about one tile."""
        return all(len(limit.tiles) == 1 for limit in self.limits)

    def table(self, axis: int, shape: tuple[int, int]) -> NDArray[np.int32]:
        """Longest run of each single tile along an axis: int32 (T, h or 1, w or 1)."""
        ours = [(limit, limit.on(shape)) for limit in self.limits if limit.axis == axis]
        size = np.broadcast_shapes((1, 1), *(most.shape for _, most in ours))
        most = np.full((self.tiles, *size), NEVER, np.int32)
        for limit, here in ours:
            for tile in limit.tiles if len(limit.tiles) == 1 else ():
                np.minimum(most[tile], here, out=most[tile])
        return most

    def windows(self, shape: tuple[int, int], *, cyclic: bool) -> Iterator[tuple[Limit, Integers]]:
        """All strips of cells that must not lie in one limit's tiles: flat cell numbers, (strips, length)."""
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
            f"limits name {name!r}; expected H or V and tiles, such as 'H0', 'V1' or 'H0+2'"
        )
    tiles = tuple(sorted({check_int(name, int(t), 0, _MOST_TILES - 1) for t in found[2].split("+")}))
    if callable(most):
        check_function_of_place(f"the limit of {name}", most)
    else:
        most = _as_most(name, most, None)
    return Limit("HV".index(found[1]), tiles, most)


def _as_most(name: str, given: Any, shape: tuple[int, int] | None) -> NDArray[np.int32]:
    """Longest runs as int32, (1, 1) or ``shape``; where ``shape`` is None, whatever two axes there are."""
    try:
        most = np.asarray(given)
    except ValueError:
        raise TilewrightValueError(f"the limit of {name} is not a table of equally long rows") from None
    if most.dtype.kind not in "iuf":
        raise TilewrightTypeError(f"the limit of {name} must be an integer or inf, not {given!r}")
    if most.size == 0 or np.isnan(most).any() or (most < 0).any() or (most[most < inf] % 1 != 0).any():
        raise TilewrightValueError(f"the limit of {name} is {_brief(most)}; allowed are 0, 1, 2, ... and inf")
    most = np.minimum(most, NEVER).astype(np.int32)
    if most.ndim == 0:
        return most.reshape(1, 1)
    if most.ndim != 2 or (shape is not None and most.shape not in ((1, 1), tuple(shape))):
        expected = "(height, width)" if shape is None else str(tuple(shape))
        raise TilewrightValueError(f"the limit of {name} has shape {most.shape}; expected {expected}")
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
    if given is not None and not isinstance(given, Mapping):
        raise TilewrightTypeError(f"{name} must be a mapping such as {{0: 12}}, not {type(given).__name__}")
    return given or {}


def as_cells(name: str, given: ArrayLike, tiles: int, *, free: bool = False) -> NDArray[Any]:
    """A rectangle of tiles 0 to ``tiles`` - 1 as a new array [y, x]; -1 too where cells may be free."""
    truths = isinstance(given, np.ndarray) and given.dtype == bool
    cells = as_integers(name, given.astype(np.uint8) if truths else given)  # type: ignore[union-attr]
    if cells.ndim != 2 or cells.size == 0 or max(cells.shape) > _MOST_SIDE:
        raise TilewrightValueError(
            f"{name} has shape {cells.shape}; expected (height, width), sides 1 to {_MOST_SIDE}"
        )
    low = -1 if free else 0
    if cells.min() < low or cells.max() >= tiles:
        raise TilewrightValueError(
            f"{name} holds {cells.min()} to {cells.max()}; allowed are {low} to {tiles - 1}"
        )
    return cells.astype(np.int16 if free else np.uint8)


def find_violations(
    tiling: ArrayLike,
    limits: Mapping[str, Most] | Conditions,
    *,
    cyclic: bool = False,
    tiles: int | None = None,
) -> dict[str, NDArray[np.bool_]]:
    """Where runs that are too long end, for each condition: the check, independent of every method here.

    Parameters
    ----------
    tiling : array-like of int, shape (height, width)
    limits : mapping or Conditions
        As in `Conditions`.
    cyclic : bool
        Whether rows and columns close to rings. A ring of one tile is a run without end, so that it violates
        every finite limit.
    tiles : int, optional
        Number of tiles.

    Returns
    -------
    dict from ``"H0"`` etc. to bool array (height, width); a dappled tiling has no True in any.
    """
    conditions = Conditions(limits, tiles)
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
