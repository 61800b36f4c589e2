"""The result of point synthesis: the points of each tile, their ranks, and what is promised."""

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, check_real
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.sameness import Alike
from tilewright.showing import Stored, describe, many
from tilewright.tiles import TileSet
from tilewright.tiles.tileset import check_tiles
from tilewright.tiles.variants import NUMBER_BITS, Variants, check_variants, name_variants

_ONE = np.nextafter(np.float32(1), np.float32(0))


@dataclass(frozen=True, eq=False)
class PointTiles(Alike, Stored):
    """Points over a tile set, with one or several variants of each tile.

    Attributes
    ----------
    tiles : TileSet
        What may meet.
    points : float32 array, shape (P, 2)
        The points of all tiles one after another, x first, in tile lengths: 0 <= x, y < 1 within the tile.
        Those of one tile lie in the order of their ranks.
    starts : int64 array, shape (rows + 1,)
        Where the points of each row start and end; a row is a variant of a tile, see ``variants``.
    ranks : float32 array, shape (P,)
        From 0 up to 1: keeping the points of rank below d in every tile leaves a share of about d of them, as
        evenly spread as can be.
    variants : Variants
        Interchangeable fillings of the tiles, and how often each is drawn; one of each by default.
    distance : float
        No two points of any tiling are closer, in tile lengths, 0 to 1.5; default 0, which promises nothing.
    method : str
        Name of the method that made the set; default ``"given"``.
    recipe : dict
        Settings and seed, plain JSON values: what is needed to make the set again.
    figures : dict
        What was found when the set was made: the closeness of points, the spikes of the spectrum.

    Raises
    ------
    TilewrightTypeError
        Something else than a tile set, numbers, a word and a dict.
    TilewrightValueError
        Arrays of other shapes, points outside their tile, or ranks that fall within a tile.

    See Also
    --------
    poisson_tiles, make_point_tiles, ready_tiles
    """

    tiles: TileSet
    points: NDArray[np.float32]
    starts: NDArray[np.int64]
    ranks: NDArray[np.float32]
    variants: Variants = None  # type: ignore[assignment]  # set below, for the set at hand
    distance: float = 0.0
    method: str = "given"
    recipe: dict[str, Any] = field(default_factory=dict)
    figures: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        check_tiles("tiles", self.tiles)
        for name, kind in (("points", np.float32), ("starts", np.int64), ("ranks", np.float32)):
            object.__setattr__(self, name, _as_array(name, getattr(self, name), kind))
        n = len(self.points)
        if self.points.shape != (n, 2) or self.ranks.shape != (n,) or self.starts.ndim != 1:
            raise TilewrightValueError(
                f"has shape {self.points.shape}, ranks {self.ranks.shape} and starts {self.starts.shape}"
                "; expected (P, 2), (P,) and one axis",
                argument="points",
                value=self.points.shape,
                allowed="(P, 2), (P,) and one axis",
            )
        given = Variants.uniform(self.tiles) if self.variants is None else self.variants
        object.__setattr__(self, "variants", check_variants(given, self.tiles))
        object.__setattr__(self, "distance", check_real("distance", self.distance, 0.0, 1.5))
        if not isinstance(self.method, str) or not isinstance(self.recipe, dict):
            raise TilewrightTypeError("method must be a word and recipe a dict")
        if len(self.starts) != len(self.variants) + 1:
            raise TilewrightValueError(
                f"has {len(self.starts)} entries; {len(self.tiles)} tiles with {len(self.variants)} "
                f"variants in all need {len(self.variants) + 1}",
                argument="starts",
                value=len(self.starts),
            )
        if self.starts[0] != 0 or self.starts[-1] != n or (np.diff(self.starts) < 0).any():
            raise TilewrightValueError(f"must rise from 0 to the number of points, {n}", argument="starts")
        if not ((self.points >= 0) & (self.points < 1)).all():
            raise TilewrightValueError("must lie in their tile, from 0 up to 1", argument="points")
        if not ((self.ranks >= 0) & (self.ranks < 1)).all():
            raise TilewrightValueError("must be from 0 up to 1", argument="ranks", allowed="from 0 up to 1")
        firsts = self.starts[:-1][np.diff(self.starts) > 0]
        falls = np.diff(self.ranks, prepend=np.float32(0)) < 0
        falls[firsts] = False
        if falls.any():
            raise TilewrightValueError(
                "must not fall within a tile", argument="ranks", advice="PointTiles.of() sorts points by rank"
            )

    @classmethod
    def of(
        cls,
        tiles: TileSet,
        rows: list[NDArray[np.float64]],
        ranks: list[NDArray[np.float64]] | None = None,
        **rest: Any,
    ) -> "PointTiles":
        """Make point tiles from the points of each tile and their ranks.

        Parameters
        ----------
        tiles : TileSet
            What may meet; T tiles.
        rows : list of float array, shape (n, 2)
            The points of each tile, x first, in tile lengths from 0 up to 1; the variants of a tile one
            after another.
        ranks : list of float array, shape (n,), optional
            Ranks from 0 up to 1 for the same points, by which they are sorted; by default the points' order.
        **rest : Variants, float, str or dict
            Further attributes: ``variants``, ``distance``, ``method``, ``recipe``, ``figures``.

        Returns
        -------
        PointTiles
            The points in the order of their ranks.

        Raises
        ------
        TilewrightTypeError, TilewrightValueError
            As `PointTiles` raises them.
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

    def __repr__(self) -> str:
        each = f"{many(round(self.density, 3), 'point')} each"
        more = name_variants(self.variants)
        return describe(
            self, f"{self.tiles!r}", each, *more, f"method {self.method}", f"distance {self.distance:.6g}"
        )

    @property
    def density(self) -> float:
        """Points per tile, on average over the set, variants by their weights."""
        if self.variants.even:
            return len(self.points) / len(self.variants)
        return float((self.counts * (self.variants.shares / 2**NUMBER_BITS)).sum() / len(self.tiles))

    @property
    def counts(self) -> NDArray[np.int64]:
        """Number of points of every row, int64, shape (rows,)."""
        return np.diff(self.starts)

    def tile(self, index: int, variant: int = 0) -> NDArray[np.float32]:
        """Points of one tile.

        Parameters
        ----------
        index : int
            Which tile, 0 to T - 1.
        variant : int, optional
            Which filling of it, 0 to V - 1; default 0.

        Returns
        -------
        float32 array, shape (n, 2)
            The points in the order of their ranks, x first, in tile lengths from 0 up to 1.

        Raises
        ------
        TilewrightTypeError
            A number that is not an integer.
        TilewrightValueError
            There is no such tile or variant.
        """
        index = check_int("index", index, 0, len(self.tiles) - 1)
        row = self.variants.row(index, variant)
        return self.points[self.starts[row] : self.starts[row + 1]]


def _as_array(name: str, given: Any, kind: type[np.generic]) -> NDArray[Any]:
    """An array of a kind, if numbers were given that it can hold."""
    try:
        array = np.asarray(given)
        if array.dtype.kind not in ("iu" if kind is np.int64 else "iuf"):
            raise TypeError
        return np.ascontiguousarray(array, kind)
    except (TypeError, ValueError):
        raise TilewrightTypeError(
            f"must hold {np.dtype(kind)} numbers", argument=name, allowed=f"{np.dtype(kind)} numbers"
        ) from None
