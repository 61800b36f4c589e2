"""What cells do to particles: the tiles of flow simulations (Kaji et al. 2016, sections 5 and 6)."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tilewright.checks import as_cells, check_choice, check_int, check_real, type_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError, brief
from tilewright.seeds import derive_key, make_key
from tilewright.tilings.hashes import MixerHash
from tilewright.tilings.streams import FLOWS

WAYS = {"-": (1, 3), "|": (0, 2), "+": (0, 1, 2, 3)}
"""North, east, south, west as 0 to 3."""
_FASTEST, _SLOWEST = 8.0, 0.001
_MOST_BORN = 1000.0


@dataclass(frozen=True)
class FlowTile:
    """What a cell does to particles.

    Parameters
    ----------
    ways : str
        Where a particle goes on from the center: ``"-"`` west or east, ``"|"`` north or south, ``"+"`` any of
        the four. All are equally likely.
    speed : float, optional
        Speed of particles on this cell, in cells per step, 0.001 to 8; default 1.
    emits : float, optional
        New particles in the center of the cell, on average per step, 0 to 1000; default 0.
    kills : float, optional
        Chance that a particle that reaches the center dies there, 0 to 1; default 0.

    Raises
    ------
    TilewrightTypeError
        A number of a wrong type.
    TilewrightValueError
        There are no such ways, or a number is out of range.

    Notes
    -----
    Kaji et al. 2016, section 5; speeds, births and deaths are of section 6 (4).
    """

    ways: str
    speed: float = 1.0
    emits: float = 0.0
    kills: float = 0.0

    def __post_init__(self) -> None:
        check_choice("ways", self.ways, tuple(WAYS))
        check_real("speed", self.speed, _SLOWEST, _FASTEST)
        check_real("emits", self.emits, 0, _MOST_BORN)
        check_real("kills", self.kills, 0, 1)


FLOW_TILES = (FlowTile("-"), FlowTile("|"))
"""The two tiles of Kaji et al. 2016, section 5: 0 goes west or east, 1 north or south."""


def check_tiles(tiles: Sequence[FlowTile], most: int = 256) -> tuple[FlowTile, ...]:
    """The tiles that stand for the numbers 0, 1, ... of cells."""
    if not isinstance(tiles, Sequence):
        raise type_error("tiles", tiles, "a sequence of FlowTile objects")
    kinds = tuple(tiles)
    for tile in kinds:
        if not isinstance(tile, FlowTile):
            raise TilewrightTypeError(
                f"must hold FlowTile objects, not {brief(tile)}",
                argument="tiles",
                value=tile,
                allowed="FlowTile objects",
            )
    check_int("the number of tiles", len(kinds), 1, most)
    return kinds


def strew_tiles(
    cells: ArrayLike,
    *,
    emitting: float = 0.0,
    killing: float = 0.0,
    slow: float = 0.0,
    fast: float = 0.0,
    tiles: Sequence[FlowTile] = FLOW_TILES,
    rate: float = 0.02,
    seed: int = 0,
) -> tuple[NDArray[np.uint8], tuple[FlowTile, ...]]:
    """Make some cells emit, kill, slow down or speed up, by chance, without changing their ways.

    A dappled tiling stays dappled as to the ways of its tiles.

    Parameters
    ----------
    cells : array-like of int, shape (height, width)
        The tile of each cell, an index into ``tiles``.
    emitting : float, optional
        Share of cells that emit, 0 to 1; default 0. All four shares together are at most 1.
    killing : float, optional
        Share of cells that kill all that reach their center, 0 to 1; default 0.
    slow : float, optional
        Share of cells with 0.4 times the speed, but not below 0.001; default 0.
    fast : float, optional
        Share of cells with 2.5 times the speed, but not above 8; default 0.
    tiles : sequence of FlowTile, optional
        What ``cells`` holds, up to 51; default `FLOW_TILES`.
    rate : float, optional
        New particles in an emitting cell, on average per step, 0 to 1000; default 0.02.
    seed : int, optional
        Where chance begins, 0 to 2^64 - 1; default 0.

    Returns
    -------
    cells : uint8 array, shape (height, width)
        Tile ``t + len(tiles) * kind``; kinds are plain, emitting, killing, slow and fast.
    tiles : tuple of FlowTile
        Five times as many as given.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range, or the cells have another shape or other tiles.

    Notes
    -----
    Kaji et al. 2016, section 6 (4).
    """
    given = as_cells(cells)
    plain = check_tiles(tiles, 51)
    count = len(plain)
    if given.min() < 0 or given.max() >= count:
        raise TilewrightValueError(
            f"hold {given.min()} to {given.max()}; tiles are 0 to {count - 1}", argument="cells"
        )
    shares = []
    for name, share in (("emitting", emitting), ("killing", killing), ("slow", slow), ("fast", fast)):
        shares.append(check_real(f"the share of {name} cells", share, 0, 1))
    # Rounding of sums such as 0.7 + 0.2 + 0.1 is forgiven.
    check_real("the sum of the shares", round(sum(shares), 12), 0, 1)
    kinds = list(plain)
    kinds += [replace(tile, emits=rate) for tile in plain]
    kinds += [replace(tile, kills=1.0) for tile in plain]
    for factor in (0.4, 2.5):
        speeds = [min(max(tile.speed * factor, _SLOWEST), _FASTEST) for tile in plain]
        kinds += [replace(tile, speed=speed) for tile, speed in zip(plain, speeds, strict=True)]
    most = np.cumsum(shares[::-1])[::-1] * 2.0**32
    hash = MixerHash(int(derive_key(make_key(seed), FLOWS, 2)))
    words = hash.words(FLOWS, np.arange(given.shape[1]), np.arange(given.shape[0])[:, np.newaxis])
    # Each kind takes the words below its bound and not below the next one's.
    kind = (words[..., np.newaxis] < most).sum(axis=-1)
    return (given + count * kind).astype(np.uint8), tuple(kinds)
