"""Bonds: crossings that are alike are found, and the pattern goes on through the plane."""

import numpy as np
import pytest

import tilewright as tw
from masonry import courses, planks
from tilewright.errors import TilewrightWarning
from tilewright.signals.textures.bond import ALL_ALIKE, Bond, find_bond
from tilewright.signals.textures.character import find_character
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.regularity import find_regularity
from tilewright.signals.textures.rhythm import find_rhythm

BONDS = {
    "running": Bond(1, 2, 1),
    "stack": ALL_ALIKE,
    "basket": Bond(3, 6, 3),
    "herringbone": Bond(1, 8, 1),
}


def seen(photo):
    return find_character(Exemplar([{"albedo": photo}]), find_regularity(photo), 128)


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize("name", BONDS)
def test_a_bond_is_found(name, seed):
    character = seen(planks(name, seed=seed))
    assert all(character.rhythm)
    assert character.bond == BONDS[name]


def test_a_weave_has_crossings_of_one_kind(photograph):
    assert seen(photograph("weave")).bond == ALL_ALIKE


@pytest.mark.parametrize("seed", range(5))
def test_chance_is_no_bond(seed):
    # Stones of random width in rows, looked at as if their columns were in step.
    picture = courses([32] * 12, 384, seed=seed)
    rhythm = find_rhythm(picture, 32.0)
    assert find_bond(picture, rhythm, rhythm) == ALL_ALIKE


def test_like_crossings():
    i, j = np.meshgrid(np.arange(-9, 9), np.arange(-9, 9), indexing="ij")
    assert (Bond(1, 8, 1).alike(i, j) == ((j - i) % 8 == 0)).all()
    basket = Bond(3, 6, 3).alike(i, j)
    assert (basket == ((i % 3 == 0) & (j % 3 == 0) & ((i // 3 + j // 3) % 2 == 0))).all()
    sizes = np.arange(1, 17)
    assert sizes[Bond(1, 8, 1).fits(sizes, sizes)].tolist() == [8, 16]
    assert sizes[Bond(3, 6, 3).fits(sizes, sizes)].tolist() == [6, 12]
    assert ALL_ALIKE.fits(sizes, sizes).all()


@pytest.mark.parametrize(
    ("name", "size", "step"), [("running", 96, (24, 24)), ("herringbone", 192, (24, 24))]
)
def test_the_pattern_goes_on_through_the_plane(name, size, step):
    photo = planks(name)
    material = tw.texture_tiles(photo, tile_size=None if name == "herringbone" else size, seed=1)
    assert material.tile_size == size
    plane = tw.TextureField(material, tw.direct(material.tiles, seed=2)).render(0, 0, 1024, 1024)[..., 0]
    dark = (plane < 90).astype(float)
    dy, dx = step
    # Of the joints a plank's step away as many are joints as in the photograph, but for few.
    told = [
        np.corrcoef(p[dy:, dx:].ravel(), p[:-dy, :-dx].ravel())[0, 1]
        for p in ((photo[..., 0] < 90).astype(float), dark)
    ]
    assert told[0] > 0.8
    assert told[1] > told[0] - 0.1


def test_a_size_that_breaks_the_bond_is_said():
    with pytest.warns(TilewrightWarning, match="one of 8 crossings .* tile_size 192 or 384 keeps it"):
        tw.texture_tiles(planks("herringbone", 384), tile_size=120, seed=1)
