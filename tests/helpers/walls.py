"""Small walls for tests."""

import numpy as np

from tilewright.fields.bricks.bonds import BONDS, BondBricks
from tilewright.fields.bricks.patterns import WangBricks
from tilewright.signals.bricks.style import BrickStyle
from tilewright.tiles.bricks import brick_tiles
from tilewright.tilings import Domain, Tiling

SMALL = (48, 24)


class Draughtboard(Tiling):
    """Tiles with a line along x and along y in turn: the simplest endless wall; closes after 12 cells."""

    def __init__(self, count=3, period=None):
        self.tiles, self.count = brick_tiles(count), count
        self.domain = Domain.plane(period)

    def _fill(self, start, out):
        x, y = np.meshgrid(*(self.domain.wrap(a, start[a], out.shape[1 - a]) for a in (0, 1)))
        slots = [self.level(x, y), self.upright(x + 1, y), self.level(x, y + 1), self.upright(x, y)]
        out[...] = self.tiles.find(np.stack(slots, axis=-1))

    def upright(self, x, y):
        """Position on the edge west of a cell: the same west and east of cells whose line lies."""
        return (x - y % 2) // 2 % self.count

    def level(self, x, y):
        return ((y - (x + 1) % 2) // 2 + x) % self.count


def plain(**options):
    return BrickStyle(wear=0.0, variation=0.0, grain=0.0, **options)


WALLS = {
    "wang": lambda: WangBricks(Draughtboard(), SMALL),
    "wang of 2, closed": lambda: WangBricks(Draughtboard(2, (12, 12)), (30, 31)),
    **{bond: lambda bond=bond: BondBricks(bond, SMALL) for bond in BONDS},
}


def brick_classes(tiles):
    """Class of every tile of a set of brick tiles: 0 for H, traversed along the row, 1 for V."""
    return (tiles.slots[:, 0] == tiles.slots[:, 2]).astype(np.uint8)
