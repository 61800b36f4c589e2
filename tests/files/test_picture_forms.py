"""Renders in formats that hold another form of pixels: light in EXR, JPEG and WebP for looking at."""

import numpy as np
import pytest

import tilewright as tw
from commands import call
from tilewright.signals.textures.kinds import to_linear


@pytest.fixture
def folder(tmp_path, gravel):
    photo = np.stack([gravel[:96, :96, 0]] * 2 + [gravel[96:192, :96, 0]], axis=-1)
    maps = {"albedo": photo, "height": photo[..., :1].astype(np.uint16) * 257}
    tw.save(tw.texture_tiles(maps, tw.corner_tiles(1), tile_size=32), tmp_path / "set")
    return tmp_path / "set"


def render(folder, *arguments):
    call("render", folder, "--width", 64, "--height", 48, *arguments)


def test_exr_of_8_and_16_bits_holds_light_and_shares(folder, tmp_path):
    render(folder, "-o", tmp_path / "a.exr")
    render(folder, "-o", tmp_path / "h.exr", "--map", "height")
    field = tw.TextureField(tw.load(folder), tw.direct(tw.corner_tiles(1)))
    color, height = field.render(0, 0, 64, 48), field.render(0, 0, 64, 48, map="height")
    assert np.allclose(tw.read_image(tmp_path / "a.exr"), to_linear(color / np.float32(255)), atol=1e-6)
    assert np.allclose(tw.read_image(tmp_path / "h.exr"), height / 65535, atol=1e-6)


@pytest.mark.parametrize("suffix", [".jpg", ".jpeg", ".webp"])
def test_pictures_for_looking_at(folder, tmp_path, suffix):
    for map, name in (("albedo", "a"), ("height", "h")):
        render(folder, "-o", tmp_path / f"{name}{suffix}", "--map", map)
        field = tw.TextureField(tw.load(folder), tw.direct(tw.corner_tiles(1)))
        wanted = field.render(0, 0, 64, 48, map=map)
        wanted = np.rint(wanted / 257) if map == "height" else wanted
        found = tw.read_image(tmp_path / f"{name}{suffix}").astype(float)
        assert found.shape[:2] == (48, 64)
        assert np.abs(found.mean(axis=2) - wanted.mean(axis=2)).mean() < 4


def test_all_maps_of_a_window_in_a_folder(folder, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    render(folder, "--map", "all", "--scale", 0.5)
    assert sorted(p.name for p in (tmp_path / "set-maps").iterdir()) == ["albedo.png", "height.png"]
    assert tw.read_image("set-maps/height.png").shape == (24, 32, 1)
    (tmp_path / "set-maps" / "letter.txt").write_text("dear")
    with pytest.raises(tw.TilewrightError, match=r"holds letter\.txt, which is no map of this set"):
        render(folder, "--map", "all", "-o", "set-maps", "--force")


@pytest.mark.parametrize(
    ("name", "channels", "message"),
    [
        ("a.jpg", 4, "jpg holds no alpha; use .webp, .png or .tif"),
        ("a.gif", 3, "allowed are .png, .tif, .tiff, .exr, .jpg, .jpeg, .webp"),
        ("a", 3, "has no suffix"),
    ],
)
def test_what_no_file_of_the_suffix_holds(tmp_path, name, channels, message):
    plane = tw.RepeatField(np.zeros((32, 32, channels), np.uint8))
    with pytest.raises(tw.TilewrightError, match=message):
        plane.save(tmp_path / name, width=8, height=8)
    with pytest.raises(tw.TilewrightError, match=r"use .tif or .exr"):
        tw.RepeatField(np.zeros((32, 32, 3), np.float32)).save(tmp_path / "a.jpg", width=8, height=8)
    with pytest.raises(tw.TilewrightError, match=r"at most 16,383 on a side; write a \.tif"):
        plane.save(tmp_path / "a.webp", width=20000, height=8)
    assert not any(tmp_path.iterdir())
