"""Outputs of commands: their names where none is given, and that none is lost."""

import numpy as np
import pytest

import tilewright as tw
from commands import call
from tilewright.errors import TilewrightError


@pytest.fixture
def here(tmp_path, monkeypatch, gravel):
    """A folder to work in, with two photographs."""
    monkeypatch.chdir(tmp_path)
    tw.write_image("grass.png", gravel[:64, :64])
    tw.write_image("sand.png", gravel[64:128, :64])
    tw.write_image("mask.png", np.pad(np.full((50, 50, 1), 255, np.uint8), ((0, 14), (0, 14), (0, 0))))
    return tmp_path


def texture(*arguments):
    call("texture", *arguments, "--tile-size", 16, "--colors", 1)


def snapshot(folder):
    return {p: p.read_bytes() for p in folder.rglob("*") if p.is_file()}


def test_a_set_is_named_after_its_photograph(here):
    texture("grass.png")
    texture("sand.png")
    texture("grass.png", "--seed", 2)
    seeds = {name: tw.load(name).recipe["seed"] for name in ("grass-tiles", "sand-tiles", "grass-tiles-2")}
    assert seeds == {"grass-tiles": 0, "sand-tiles": 0, "grass-tiles-2": 2}


OTHERS = {
    "photograph": ("sand.png",),
    "seed": ("grass.png", "--seed", 1),
    "method": ("grass.png", "--method", "ng"),
    "mask": ("grass.png", "--mask", "mask.png"),
    "weights that change nothing but the recipe": ("grass.png", "--weight", "albedo=3"),
}


@pytest.mark.parametrize("case", OTHERS)
def test_another_set_is_replaced_only_by_force(here, case):
    texture("grass.png", "-o", "set")
    before = snapshot(here)
    with pytest.raises(TilewrightError, match="set is there already; name another --output, or give --force"):
        texture(*OTHERS[case], "-o", "set")
    assert snapshot(here) == before
    texture(*OTHERS[case], "-o", "set", "--force")
    assert snapshot(here) != before


@pytest.mark.parametrize("options", [("--tile-size", 16, "--colors", 1), ("--tile-size", 16)], ids=str)
def test_the_same_recipe_may_be_made_again(here, options):
    for _ in range(2):
        call("texture", "grass.png", "-o", "set", "--seed", 3, *options)
    assert tw.load("set").recipe["seed"] == 3


def test_a_set_made_again_gets_a_name_of_its_own(here):
    texture("grass.png")
    call("texture", "--from", "grass-tiles", "--reject", "center:0")
    assert tw.load("grass-tiles-2") != tw.load("grass-tiles")
    with pytest.raises(TilewrightError, match="is there already"):
        call("texture", "--from", "grass-tiles", "--reject", "center:0", "-o", "grass-tiles")


def test_maps_are_added_in_place(here):
    texture("grass.png")
    call("texture", "--like", "grass-tiles", "--map", "height=grass.png")
    assert list(tw.load("grass-tiles").maps) == ["albedo", "height"]


COMMANDS = {
    "pack": ("pack", "--colors", 2),
    "dapple": ("dapple", "--width", 9, "--height", 9),
    "aperiodic": ("aperiodic", "ammann-16", "--width", 5, "--height", 5),
    "render": ("render", "set", "--width", 9, "--height", 9),
    "view": ("view", "set"),
    "export": ("export", "set", "--to", "glsl"),
    "points": ("points", "--count", 9),
}
NAMES = {
    "pack": "corner-2-packing.png",
    "dapple": "dapple.png",
    "aperiodic": "ammann-16.svg",
    "render": "set.png",
    "view": "set.html",
    "export": "set-glsl",
    "points": "corner-points.npy",
}


@pytest.mark.parametrize("name", COMMANDS)
def test_one_rule_for_the_outputs_of_all_commands(here, name, gravel):
    tw.save(tw.texture_tiles(gravel[:64, :64], tw.corner_tiles(2), tile_size=16), "set")
    call(*COMMANDS[name])
    first = here / NAMES[name]
    assert first.exists()
    call(*COMMANDS[name])
    assert first.with_stem(f"{first.stem}-2").exists()
    with pytest.raises(TilewrightError, match="is there already"):
        call(*COMMANDS[name], "-o", first)
    call(*COMMANDS[name], "-o", first, "--force")
    deep = here / "not" / "there" / NAMES[name]
    call(*COMMANDS[name], "-o", deep)
    assert deep.exists()


def test_a_folder_of_other_things_is_not_replaced_by_force(here):
    (here / "mine").mkdir()
    (here / "mine" / "letter.txt").write_text("dear")
    with pytest.raises(TilewrightError, match="holds other things"):
        texture("grass.png", "-o", "mine", "--force")


def test_sets_that_hold_the_same_are_equal(here, gravel):
    made = tw.texture_tiles(gravel[:128, :128], tile_size=16, seed=1)
    tw.save(made, "set")
    assert tw.load("set") == made
    assert hash(tw.load("set")) == hash(made)
    assert tw.texture_tiles(gravel[:128, :128], tile_size=16, seed=2) != made
    assert made != "set"
    blue = tw.ready_tiles()
    tw.save(blue, "blue")
    assert tw.load("blue") == blue
    assert blue != made
    assert tw.corner_tiles(2) == tw.tile_set(tw.corner_tiles(2).slots, "corner")
    assert tw.corner_tiles(2) != tw.corner_tiles(3)
    assert tw.corner_tiles(2) != np.zeros(3).tolist()
