"""Names of patches on a sheet: those that lie there, and that `reject` takes."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.analysis.textures.patches import named_pieces
from tilewright.analysis.textures.sample import lay_sample


@pytest.fixture(scope="module")
def made(gravel):
    return tw.texture_tiles(gravel[:200, :200], tw.corner_tiles(2), tile_size=32, seed=1)


def test_patches_are_named_where_they_lie(made):
    sample, slots = lay_sample(made, 4), made.tiles.slots
    pieces = named_pieces(sample, 4)
    names = {piece.name for piece in pieces}
    assert names <= made.recipe["patches"].keys()
    for piece in pieces:
        row, column = int(piece.y // 32), int(piece.x // 32)
        kind, _, number = piece.name.partition(":")
        if kind == "center":
            assert int(number) == sample.cells[row, column]
        if kind == "corner":  # of the nearest lattice point
            y, x = round(piece.y / 32), round(piece.x / 32)
            at = sample.cells[min(y, 3), min(x, 3)]
            slot = {(0, 0): 3, (0, 1): 0, (1, 1): 1, (1, 0): 2}[y // 4, x // 4]
            assert int(number) == slots[at, slot]
    # The tile's own patch holds its middle, in every cell.
    assert sum(piece.name.startswith("center") for piece in pieces) >= 16


def test_a_named_patch_can_be_rejected(made):
    sample = lay_sample(made, 4)
    piece = next(p for p in named_pieces(sample, 4) if p.name.startswith("center"))
    spot = made.recipe["patches"][piece.name]
    again = tw.resynthesize(made, reject=[piece.name])
    assert again.recipe["patches"][piece.name] != spot


@pytest.mark.parametrize(
    ("tiles", "options"),
    [
        (tw.corner_tiles(2), {"method": "ng"}),
        (tw.corner_tiles(2), {"method": "squares"}),
        (tw.wang_tiles(2), {}),
        (tw.wang_tiles(2), {"method": "burke"}),
        (tw.corner_tiles(2), {"variants": 2}),
        (None, {}),
    ],
    ids=str,
)
def test_every_method_names_its_patches(gravel, tiles, options):
    material = tw.texture_tiles(gravel[:200, :200], tiles, tile_size=32, seed=1, **options)
    pieces = named_pieces(lay_sample(material, 4), 4)
    assert {piece.name for piece in pieces} <= material.recipe["patches"].keys()
    y, x = np.array([(piece.y, piece.x) for piece in pieces]).T
    assert len({(row, column) for row, column in zip(y // 64, x // 64, strict=True)}) == 4


def test_sets_without_a_recipe_have_no_names(made):
    from dataclasses import replace

    assert named_pieces(lay_sample(replace(made, recipe={}), 4), 4) == []
