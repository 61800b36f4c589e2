"""A set made again with some patches elsewhere: what does not touch them stays as it was, pixel for pixel."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.signals.textures.patchwork import Patchwork
from tilewright.signals.textures.plan import Plan
from tilewright.signals.textures.sheet import Sheet

Place = tuple[int, int]


@dataclass(frozen=True, eq=False)
class Earlier:
    """A set that exists.

    Attributes
    ----------
    origins : uint16 array, shape (rows, size, size, 3)
        Where every pixel came from, as in `TextureTiles`.
    changed : frozenset of str
        Names of the patches that are to be laid elsewhere.
    """

    origins: NDArray[np.uint16]
    changed: frozenset[str]


@dataclass(frozen=True, eq=False)
class Kept:
    """Tiles of the set as it was.

    Attributes
    ----------
    changed : frozenset of str
        Names of the patches that are laid elsewhere.
    canvas : Patchwork
        What every picture shows, shape (rows, size, size).
    variants : int
        Pictures of each tile.
    """

    changed: frozenset[str]
    canvas: Patchwork
    variants: int

    @classmethod
    def of(cls, sheet: Sheet, earlier: Earlier, variants: int) -> "Kept":
        """The pictures of a set, in coordinates of the sheet of its sources."""
        origins = earlier.origins
        tops = np.array(sheet.tops, np.int32)
        rows = origins[..., 1].astype(np.int32) + tops[origins[..., 0]]
        return cls(earlier.changed, Patchwork(rows, origins[..., 2].astype(np.int32)), variants)

    @property
    def moves_corners(self) -> bool:
        """Whether any corner patch is laid elsewhere."""
        return any(name.startswith("corner:") for name in self.changed)

    def shares_change(self, plan: Plan, tile: int) -> bool:
        """Whether a tile shares a patch with others that is laid elsewhere."""
        corners = {f"corner:{number}" for number in plan.tile_corners[tile]}
        edges = {plan.edges[number].name for number in plan.tile_edges[tile]}
        return bool(self.changed & (corners | edges))

    def edges_to_lay(self, plan: Plan) -> set[int]:
        """The edges of all tiles that are laid anew, in part or whole."""
        tiles = (t for t in range(len(plan.tile_edges)) if self._is_new(plan, t))
        return {int(edge) for tile in tiles for edge in plan.tile_edges[tile]}

    def stays(self, name: str, tile: int, plan: Plan | None) -> bool:
        """Whether the picture whose own patch has that name is as it was.

        Without a plan it is not known what tiles share; then all change unless only their own patches do.
        """
        if plan is None:
            return name not in self.changed and all(n.startswith("center:") for n in self.changed)
        return name not in self.changed and not self.shares_change(plan, tile)

    def _is_new(self, plan: Plan, tile: int) -> bool:
        own = {f"center:{tile}", *(f"center:{tile}:{variant}" for variant in range(1, self.variants))}
        return bool(self.changed & own) or self.shares_change(plan, tile)

    def picture(self, tile: int, variant: int) -> Patchwork:
        """What a tile showed."""
        row = tile * self.variants + variant
        return Patchwork(self.canvas.rows[row], self.canvas.columns[row])

    def shown(self, tile: int, variant: int, place: Place) -> NDArray[np.bool_]:
        """Where a tile's own patch lay."""
        picture = self.picture(tile, variant)
        height, width = picture.rows.shape
        whole = Patchwork.of_patch(height, width, place)
        return (picture.rows == whole.rows) & (picture.columns == whole.columns)
