"""The result of point synthesis: the points of each tile, their ranks, and what is promised."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.tiles import TileSet

_ONE = np.nextafter(np.float32(1), np.float32(0))


@dataclass(frozen=True, eq=False)
class PointTiles:
    """Points over a tile set: V variants of T tiles.

    Attributes
    ----------
    tiles : TileSet
        What may meet.
    points : float32 array, shape (P, 2)
        The points of all tiles one after another, 0 <= x, y < 1 within the tile, x first. Those of one
        tile lie in the order of their ranks.
    starts : int64 array, shape (T V + 1,)
        Where each tile's points start and end; variant v of tile t is number t V + v.
    ranks : float32 array, shape (P,)
        0 <= rank < 1: keeping the points of rank below d in every tile leaves a share of about d of them,
        as evenly spread as can be.
    variants : int
        Interchangeable fillings of every tile.
    distance : float
        No two points of any tiling are closer, in tile lengths; 0 where nothing is promised.
    method : str
    recipe : dict
        Settings and seed, plain JSON values: what is needed to make the set again.
    figures : dict
        What was found when the set was made: the promise's check, spikes.
    """

    tiles: TileSet
    points: NDArray[np.float32]
    starts: NDArray[np.int64]
    ranks: NDArray[np.float32]
    variants: int = 1
    distance: float = 0.0
    method: str = "given"
    recipe: dict[str, Any] = field(default_factory=dict)
    figures: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        n = len(self.points)
        if self.points.shape != (n, 2) or self.ranks.shape != (n,):
            raise TilewrightValueError(
                f"points has shape {self.points.shape} and ranks {self.ranks.shape}; expected (P, 2) and (P,)"
            )
        if self.variants < 1 or len(self.starts) != len(self.tiles) * self.variants + 1:
            raise TilewrightValueError(
                f"starts has {len(self.starts)} entries; {len(self.tiles)} tiles of {self.variants} variants "
                f"need {len(self.tiles) * self.variants + 1}"
            )
        if self.starts[0] != 0 or self.starts[-1] != n or (np.diff(self.starts) < 0).any():
            raise TilewrightValueError(f"starts must rise from 0 to the number of points, {n}")
        if not ((self.points >= 0) & (self.points < 1)).all():
            raise TilewrightValueError("points must lie in their tile, from 0 up to 1")
        if not ((self.ranks >= 0) & (self.ranks < 1)).all():
            raise TilewrightValueError("ranks must be from 0 up to 1")

    @classmethod
    def of(
        cls,
        tiles: TileSet,
        rows: list[NDArray[np.float64]],
        ranks: list[NDArray[np.float64]] | None = None,
        **rest: Any,
    ) -> "PointTiles":
        """From the points of each tile (variants of a tile one after another) and their ranks.

        Points without ranks get those of their order.
        """
        if ranks is None:
            ranks = [np.arange(len(r)) / max(len(r), 1) for r in rows]
        starts = np.concatenate([[0], np.cumsum([len(r) for r in rows])]).astype(np.int64)
        orders = [np.argsort(r, kind="stable") for r in ranks]
        points = np.concatenate([row[o] for row, o in zip(rows, orders, strict=True)]).reshape(-1, 2)
        sorted_ranks = np.concatenate([r[o] for r, o in zip(ranks, orders, strict=True)])
        return cls(
            tiles,
            np.clip(points.astype(np.float32), 0, _ONE),
            starts,
            np.clip(sorted_ranks.astype(np.float32), 0, _ONE),
            **rest,
        )

    @property
    def density(self) -> float:
        """Points per tile, on average over the set."""
        return len(self.points) / (len(self.starts) - 1)

    @property
    def counts(self) -> NDArray[np.int64]:
        """Points of every tile and variant, shape (T V,)."""
        return np.diff(self.starts)

    def tile(self, index: int, variant: int = 0) -> NDArray[np.float32]:
        """Points of one tile, shape (n, 2), in the order of their ranks."""
        row = index * self.variants + variant
        return self.points[self.starts[row] : self.starts[row + 1]]
