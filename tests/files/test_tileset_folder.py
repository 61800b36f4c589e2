"""Tile-set folders: what goes in comes out, and nobody else's files are touched."""

import json
import os
import shutil
from pathlib import Path

import msgspec
import numpy as np
import pytest

import tilewright as tw
from handmade import handmade
from tilewright.errors import TilewrightError
from tilewright.files import exchange, images, manifest as files_manifest

SETS = [
    tw.corner_tiles(2),
    tw.wang_tiles(1, 2),
    tw.cohen_tiles(12),
    tw.corner_coded_tiles(scanline_only=True),
]


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("tiles", SETS, ids=repr)
def test_tile_sets_come_back_exactly(tmp_path, tiles, kind):
    material = handmade(tiles, kind=kind, channels=3, maps=2)
    tw.save(material, tmp_path / "set")
    read = tw.load(tmp_path / "set")
    assert read.tiles.shape is tiles.shape
    assert read.tiles.colors == tiles.colors
    assert np.array_equal(read.tiles.slots, tiles.slots)
    assert np.array_equal(read.origins, material.origins)
    assert read.recipe == material.recipe
    for name, given in material.maps.items():
        assert read.maps[name].dtype == kind
        assert np.array_equal(read.maps[name], given)
        assert all(
            np.array_equal(a[name], b[name]) for a, b in zip(read.sources, material.sources, strict=True)
        )
    assert all(np.array_equal(a, b) for a, b in zip(read.masks, material.masks, strict=True))
    assert [p.name for p in tmp_path.iterdir()] == ["set"]


def test_a_set_is_replaced_but_nothing_else(tmp_path):
    tw.save(handmade(tw.corner_tiles(2)), tmp_path / "set")
    tw.save(handmade(tw.corner_tiles(1)), tmp_path / "set")
    assert len(tw.load(tmp_path / "set").tiles) == 1
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("dear")
    with pytest.raises(TilewrightError, match="holds other things"):
        tw.save(handmade(tw.corner_tiles(1)), tmp_path / "mine")
    (tmp_path / "file").write_text("x")
    with pytest.raises(TilewrightError, match="is a file"):
        tw.save(handmade(tw.corner_tiles(1)), tmp_path / "file")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", "mine", "set"]


def test_map_names_cannot_leave_the_folder(tmp_path):
    material = handmade(tw.corner_tiles(1), maps=1)
    pixels_ = material.maps["map0"]
    names = ("../out", "a/b", "a b", "a_b")
    odd = tw.TextureTiles(
        material.tiles,
        dict.fromkeys(names, pixels_),
        tuple(dict.fromkeys(names, s["map0"]) for s in material.sources),
        material.origins,
    )
    tw.save(odd, tmp_path / "set")
    assert list(tw.load(tmp_path / "set").maps) == list(names)
    assert [p.name for p in tmp_path.iterdir()] == ["set"]


def edit(folder, change):
    manifest = json.loads((folder / "tileset.json").read_text())
    change(manifest)
    (folder / "tileset.json").write_text(json.dumps(manifest))


def harm():
    def drop(folder):
        next((folder / "map0").iterdir()).unlink()

    def touch(folder):
        path = sorted((folder / "origins").iterdir())[0]
        path.write_bytes(path.read_bytes() + b"x")

    def link(folder):
        path = sorted((folder / "map0").iterdir())[0]
        shutil.copy(path, folder.parent / "outside.png")
        path.unlink()
        path.symlink_to(folder.parent / "outside.png")

    def name(value):
        def change(folder):
            edit(folder, lambda m: m["maps"]["map0"].__setitem__(0, value))

        return change

    return {
        "missing tile": (drop, "is missing"),
        "changed file": (touch, "checksum is wrong"),
        "newer schema": (lambda f: edit(f, lambda m: m.update(schema=99)), "schema 99; this version"),
        "no json": (lambda f: (f / "tileset.json").write_text("{"), "is damaged"),
        "no manifest": (lambda f: (f / "tileset.json").unlink(), "cannot be read"),
        "wrong type": (
            lambda f: edit(f, lambda m: m.update(tile_size="big")),
            r"damaged: Expected `int`, got `str` - at `$.tile_size`",
        ),
        "unknown field": (lambda f: edit(f, lambda m: m.update(extra=1)), "unknown field"),
        "another size": (lambda f: edit(f, lambda m: m.update(tile_size=8)), "expected"),
        "fewer tiles": (
            lambda f: edit(f, lambda m: m["maps"]["map0"].pop()),
            "lists 15 pictures; the set has 16",
        ),
        "bad colors": (
            lambda f: edit(f, lambda m: m["tiles"].update(colors=[1, 1, 1, 1])),
            "that slot has 1 colors",
        ),
        "bad shape": (lambda f: edit(f, lambda m: m["tiles"].update(shape="hex")), "shape is 'hex'"),
        "ragged slots": (lambda f: edit(f, lambda m: m["tiles"]["slots"][3].pop()), "4 colors"),
        "no checksum": (lambda f: edit(f, lambda m: m.update(checksums={})), "has no checksum"),
        "parent path": (name("../x.png"), "leaves the folder"),
        "absolute path": (name("/etc/passwd"), "leaves the folder"),
        "link outside": (link, "leaves the folder"),
    }


@pytest.mark.parametrize("case", harm())
def test_harmed_folders_get_one_clear_line(tmp_path, case):
    damage, message = harm()[case]
    tw.save(handmade(tw.corner_tiles(2), size=16), tmp_path / "set")
    damage(tmp_path / "set")
    with pytest.raises(TilewrightError) as error:
        tw.load(tmp_path / "set")
    assert message in str(error.value)
    assert "\n" not in str(error.value)


def test_loading_nothing(tmp_path):
    with pytest.raises(TilewrightError, match="is not a folder"):
        tw.load(tmp_path / "none")


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_an_unwritable_folder(tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(TilewrightError, match="permission denied"):
        tw.save(handmade(tw.corner_tiles(1)), tmp_path / "set")


def test_the_manifest_can_be_read_without_tilewright(tmp_path):
    tw.save(handmade(tw.corner_tiles(2)), tmp_path / "set")
    manifest = msgspec.json.decode((tmp_path / "set" / "tileset.json").read_bytes())
    assert manifest["schema"] == files_manifest.SCHEMA
    assert manifest["tiles"]["slot_names"] == ["NE", "SE", "SW", "NW"]
    assert images.lossless_suffix(np.dtype(np.uint8)) == ".png"
    assert (tmp_path / "set" / manifest["maps"]["map0"][0]).is_file()


def refused(material, folder, message):
    """Saving is refused, and what was there is there still."""
    before = {p: p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    with pytest.raises(TilewrightError) as error:
        tw.save(material, folder)
    assert message in str(error.value)
    assert {p: p.read_bytes() for p in folder.rglob("*") if p.is_file()} == before


def test_another_programs_tileset_json_is_left_alone(tmp_path):
    (tmp_path / "game").mkdir()
    (tmp_path / "game" / "tileset.json").write_text('{"tiles": []}')
    (tmp_path / "game" / "hero.png").write_bytes(b"mine")
    refused(handmade(tw.corner_tiles(1)), tmp_path / "game", "no tileset.json of this program")


def test_a_file_that_was_put_beside_the_tiles_is_left_alone(tmp_path):
    tw.save(handmade(tw.corner_tiles(2)), tmp_path / "set")
    (tmp_path / "set" / "map0" / "notes.txt").write_text("mine")
    refused(handmade(tw.corner_tiles(1)), tmp_path / "set", "holds map0/notes.txt, which is not part")
    (tmp_path / "set" / "map0" / "notes.txt").unlink()
    tw.save(handmade(tw.corner_tiles(1)), tmp_path / "set")
    assert len(tw.load(tmp_path / "set").tiles) == 1


def test_the_old_folder_comes_back_when_the_new_one_cannot_take_its_name(tmp_path, monkeypatch):
    tw.save(handmade(tw.corner_tiles(2)), tmp_path / "set")
    rename = os.replace

    def fail(source, target):
        if ".unfinished-" in str(source) and Path(target).name == "set":
            raise OSError(28, "No space left on device")
        rename(source, target)

    monkeypatch.setattr(exchange, "exchange", lambda one, other: False)
    monkeypatch.setattr(os, "replace", fail)
    with pytest.raises(TilewrightError, match="no space left"):
        tw.save(handmade(tw.corner_tiles(1)), tmp_path / "set")
    monkeypatch.undo()
    assert len(tw.load(tmp_path / "set").tiles) == 16
    assert [p.name for p in tmp_path.iterdir()] == ["set"]


def test_sources_and_origins_must_belong_together(tmp_path):
    material = handmade(tw.corner_tiles(2))
    origins = material.origins.copy()
    origins[3, 0, 0] = (0, 9999, 0)
    tw.save(tw.TextureTiles(material.tiles, material.maps, material.sources, origins), tmp_path / "set")
    with pytest.raises(TilewrightError, match="origins"):
        tw.load(tmp_path / "set")


def test_the_manifest_has_a_tile_on_a_line_and_leaves_names_alone(tmp_path):
    recipe = {"name": "photo[1,2].png", "numbers": [1.5, -2.0]}
    tiles = tw.PointTiles.of(tw.corner_tiles(2), [np.zeros((1, 2))] * 16, recipe=recipe)
    tw.save(tiles, tmp_path / "set")
    text = (tmp_path / "set" / "tileset.json").read_text()
    assert "[0, 1, 1, 0]" in text
    assert "[1.5, -2.0]" in text
    assert tw.load(tmp_path / "set").recipe == recipe
