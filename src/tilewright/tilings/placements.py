"""What lies in each cell: the tile, which of its variants, and how it is turned."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.showing import describe_record
from tilewright.tiles.variants import Variants
from tilewright.tilings.domain import Domain
from tilewright.tilings.hashes import LatticeHash, MixerHash, as_grid, split_row
from tilewright.tilings.streams import VARIANTS


@dataclass(frozen=True, eq=False, repr=False)
class Placements:
    """Tile, variant and turn of each cell of a window; arrays of the window's shape.

    Attributes
    ----------
    indices : int32 array
        Tile of each cell.
    variants : int32 array
        Which of the tile's variants lies there, counted from 0.
    turns : int8 array
        Quarter turns. No tiling turns tiles yet: all are 0.
    """

    indices: NDArray[np.int32]
    variants: NDArray[np.int32]
    turns: NDArray[np.int8]

    def __repr__(self) -> str:
        return describe_record(self)


def draw_rows(
    indices: NDArray[np.int32],
    variants: Variants,
    hash: LatticeHash,
    domain: Domain,
    start: tuple[int, ...],
) -> NDArray[np.int32]:
    """Which row of a signal each cell shows, drawn at the cell's place folded into the domain's periods.

    Parameters
    ----------
    indices : int32 array, shape (height, width), (width,) or (depth, height, width)
        Tiles of the window that starts at cell ``start``.
    """
    extent = tuple(reversed(indices.shape))
    axes = tuple(domain.wrap(a, first, n) for a, (first, n) in enumerate(zip(start, extent, strict=True)))
    if not isinstance(hash, MixerHash):
        return variants.rows(indices, hash.numbers(VARIANTS, *as_grid(axes))).astype(np.int32)
    from tilewright.kernels.variants import choose_rows

    zero = np.zeros(1, np.int64)
    x, y, z = (*axes, zero, zero)[:3]
    rows = indices.copy()
    row = split_row(x)
    for layer, at in zip(rows.reshape(len(z), len(y), len(x)), z, strict=True):
        table = (variants.starts, variants.thresholds, variants.even)
        choose_rows(len(y), *row, y, at, VARIANTS, hash.seed, *table, layer)
    return rows
