"""What a folder holds, and what can be asked for by name."""

import json

import pytest

import tilewright as tw
from commands import call
from tilewright.errors import TilewrightError


def test_a_folder_of_textures_and_one_of_points(tmp_path, gravel, capsys):
    photo = {"albedo": gravel[:96, :96], "height": gravel[:96, :96]}
    made = tw.texture_tiles(photo, tw.corner_tiles(2), tile_size=16, seed=3, variants=2)
    tw.save(tw.resynthesize(made, reject=["center:1"]), tmp_path / "set")
    call("info", tmp_path / "set", "--json")
    said = json.loads(capsys.readouterr().out)
    assert {name: said[name] for name in ("tiles", "shape", "tile_size", "pictures", "seed", "method")} == {
        "tiles": 16, "shape": "corner", "tile_size": 16, "pictures": 32, "seed": 3, "method": "nested",
    }  # fmt: skip
    assert said["maps"] == {"albedo": "color, uint8", "height": "height, uint8"}
    assert said["photographs"] == [[96, 96]]
    assert list(said["rejected"]) == ["center:1"]
    call("info", tmp_path / "set")
    text = capsys.readouterr().out
    assert "maps: albedo (color, uint8), height (height, uint8)\nphotographs: 96 x 96\ntone: no\n" in text
    tw.save(tw.ready_tiles(), tmp_path / "blue")
    call("info", tmp_path / "blue", "--json")
    assert json.loads(capsys.readouterr().out)["density"] == 32


def test_all_names_are_listed(capsys):
    call("info", "--json")
    said = json.loads(capsys.readouterr().out)
    assert said["version"] == tw.__version__
    assert "faithful" in said["methods_of_texture"]
    assert {"dart", "lloyd"} <= set(said["methods_of_points_without"])
    assert "godot" in said["targets_of_export"]
    assert "herringbone" in said["patterns_of_bricks"]
    assert "ammann-16" in said["sets_of_aperiodic"]


def test_no_folder(tmp_path):
    with pytest.raises(TilewrightError, match="is not a folder"):
        call("info", tmp_path / "none")
