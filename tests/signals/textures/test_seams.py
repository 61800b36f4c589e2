"""Maps that are mended beside cuts: all channels, and floats of either sign."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.signals.textures.seams import copy_maps
from tilewright.tiles.variants import Variants

N = 24
TILES = tw.corner_tiles(1)
Y, X = np.indices((N, N))


def two_patches(*places):
    """Tiles whose west and east half come from two places each, (y, x of the one, x of the other)."""
    origins = np.zeros((len(places), N, N, 3), np.uint16)
    for tile, (y, west, east) in zip(origins, places, strict=True):
        tile[..., 1], tile[..., 2] = Y + y, np.where(X < N // 2, X + west, X + east)
    return origins


def copied(name, source, origins):
    return copy_maps(
        ({name: source},), origins, {name: KINDS[name]}, TILES, Variants.uniform(TILES, len(origins))
    )[name]


KINDS = {"height": "height", "normal": "normal-gl"}


@pytest.mark.parametrize("channels", [1, 2, 3])
def test_all_channels_of_heights_are_closed(channels):
    ramp = np.broadcast_to(np.linspace(0, 1, 96, dtype=np.float32)[None, :, None], (96, 96, channels))
    closed = copied("height", np.ascontiguousarray(ramp), two_patches((5, 3, 40)))
    before = (40 - 3) / 95
    assert (np.abs(closed[0, 12, 12] - closed[0, 12, 11]) < before / 2).all()
    assert (closed == closed[..., :1]).all()


def test_normals_of_floats_keep_their_encoding_where_a_tile_shows_one_slope():
    across = np.linspace(-1, 1, 96)
    hill = np.stack(np.broadcast_arrays(0.6 * across, 0.6 * across[:, np.newaxis], 1.0), axis=2)
    hill = (hill / np.linalg.norm(hill, axis=2, keepdims=True)).astype(np.float32)
    origins = two_patches((5, 5, 40), (66, 66, 69))
    blended = copied("normal", hill, origins)
    shown = hill[origins[..., 1], origins[..., 2]]
    inner = np.s_[1, 1:-1, 1:-1]  # borders are those of both tiles
    assert np.abs(blended[inner] - shown[inner]).max() < 0.1
    assert np.abs(np.linalg.norm(blended, axis=3) - 1).max() < 1e-5


def test_a_tile_without_cuts_is_copied():
    source = np.zeros((N, N, 3), np.float32)
    source[..., 2] = 1
    origins = np.zeros((1, N, N, 3), np.uint16)
    origins[0, ..., 1], origins[0, ..., 2] = Y, X
    assert np.array_equal(copied("normal", source, origins)[0], source)
