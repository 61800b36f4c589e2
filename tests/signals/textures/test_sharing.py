"""What tiles that meet have in common."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.signals.textures.sharing import Rim, Shared


def test_edges_of_sets_of_many_colors_keep_their_own_numbers():
    # Two tiles whose N edges (NW, NE) are (256, 0) and (0, 1), and so one number in base 256.
    tiles = tw.tile_set([[0, 5, 6, 256], [1, 5, 6, 0], [300, 0, 1, 300]], "corner")
    edges = Shared(tiles, tw.Variants.uniform(tiles)).edges
    for side, ends in {"N": ("NW", "NE"), "S": ("SW", "SE"), "W": ("NW", "SW"), "E": ("NE", "SE")}.items():
        pairs = tiles.slots[:, [tiles.shape.slot(end) for end in ends]].astype(int)
        same = (pairs[:, None] == pairs[None]).all(axis=2)
        assert np.array_equal(edges[side][:, None] == edges[side][None], same), side


@pytest.mark.parametrize(
    "tiles", [tw.corner_tiles(2), tw.wang_tiles(2), tw.classed_corner_tiles(2, 2)], ids=repr
)
def test_the_border_alone_is_settled_as_with_all_pixels(tiles):
    shared = Shared(tiles, tw.Variants.uniform(tiles))
    level = np.random.default_rng(3).random((len(tiles), 9, 9, 2)).astype(np.float32)
    settled, _ = shared.settle(level, Rim(9, 0, None))
    shared.settle_border(level)
    assert np.array_equal(level, settled)
