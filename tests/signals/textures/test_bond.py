"""Bonds: crossings that are alike are found, and the pattern goes on through the plane."""

import numpy as np
import pytest

import tilewright as tw
from masonry import courses
from tilewright.errors import TilewrightWarning
from tilewright.signals.textures.bond import ALL_ALIKE, Bond, find_bond
from tilewright.signals.textures.character import find_character
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.regularity import find_regularity
from tilewright.signals.textures.rhythm import find_rhythm
from tilewright.signals.textures.treatment import find_treatment

BONDS = [
    ("running-bond", (48, 24), Bond(1, 2, 1)),
    ("running-bond", (32, 12), Bond(1, 2, 1)),
    ("flemish-bond", (64, 24), Bond(1, 2, 1)),
    ("herringbone", (96, 24), Bond(1, 8, 1)),
    ("herringbone", (72, 24), Bond(1, 6, 1)),
    ("basket-weave", (60, 20), Bond(3, 6, 3)),
]


def wall(bond, size, side=512, seed=0):
    return tw.BrickField(tw.BondBricks(bond, size), seed=seed).render(0, 0, side, side)


def seen(photo):
    return find_character(Exemplar([{"albedo": photo}]), find_regularity(photo), 128)


@pytest.mark.parametrize("seed", [0, 1])
@pytest.mark.parametrize(("name", "size", "bond"), BONDS)
def test_a_bond_is_found(name, size, bond, seed):
    character = seen(wall(name, size, seed=seed))
    assert all(character.rhythm)
    assert character.bond == bond


def test_bricks_one_above_the_other_have_crossings_of_one_kind():
    rng = np.random.default_rng(0)
    stack = np.kron(rng.normal(150, 14, (21, 11)), np.ones((24, 48)))
    stack[:, np.arange(stack.shape[1]) % 48 < 3] = 60
    stack[np.arange(stack.shape[0]) % 24 < 3] = 60
    stack += rng.normal(0, 5, stack.shape)
    character = seen(np.clip(np.rint(stack), 0, 255).astype(np.uint8)[..., np.newaxis])
    assert all(character.rhythm)
    assert character.bond == ALL_ALIKE


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
    ("name", "brick", "every"), [("running-bond", (24, 12), 24), ("herringbone", (48, 12), 96)]
)
def test_the_pattern_goes_on_through_the_plane(name, brick, every):
    photo = wall(name, brick, 256)
    material = tw.texture_tiles(photo, seed=1)
    assert material.tile_size % every == 0
    plane = tw.TextureField(material, tw.direct(material.tiles, seed=2)).render(0, 0, 768, 768)

    # In both bonds what lies 12 pixels south-east is alike; mortar, which is pale, is where mortar is.
    def likeness(picture):
        mortar = (picture[..., 2] > 100).astype(float)
        return np.corrcoef(mortar[12:, 12:].ravel(), mortar[:-12, :-12].ravel())[0, 1]

    assert likeness(photo) > 0.4
    assert likeness(plane) > 0.9 * likeness(photo)
    # All lattice points lie on one diagonal of the bond in the photograph.
    places = [p for patch, p in material.recipe["patches"].items() if patch.startswith("corner:")]
    diagonals = np.exp(2j * np.pi * np.array([x - y for _, y, x in places]) / every)
    off = np.angle(diagonals / diagonals[0]) * every / (2 * np.pi)
    assert np.ptp(off) <= 4


def test_seeds_choose_among_the_places_in_step():
    photo = wall("running-bond", (24, 12), 192)
    made = [tw.texture_tiles(photo, tile_size=48, seed=seed) for seed in (1, 2)]
    assert all(m.recipe["treatment"] == "courses" for m in made)
    assert not np.array_equal(made[0].origins, made[1].origins)


@pytest.mark.parametrize(
    ("side", "advice"), [(390, "tile_size 192 keeps it$"), (350, "breaks between them$")]
)
def test_a_size_that_breaks_the_bond_is_said(side, advice):
    photo = wall("herringbone", (96, 24), side)
    with pytest.warns(TilewrightWarning, match=f"one of 8 crossings .*{advice}"):
        made = find_treatment(Exemplar([{"albedo": photo}]), seen(photo), None, 120, None)
    assert made.manner.bond == ALL_ALIKE
    assert all(made.manner.rhythm)
