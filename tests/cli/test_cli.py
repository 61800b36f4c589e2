"""The command line: what it makes, what it prints, how it refuses."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest

import tilewright as tw
from tilewright.cli.main import run


@pytest.fixture(scope="module")
def photo(tmp_path_factory, gravel):
    path = tmp_path_factory.mktemp("photo") / "gravel.png"
    tw.write_image(path, gravel[:256, :256])
    return path


@pytest.fixture(scope="module")
def folder(photo):
    path = photo.parent / "set"
    assert call("texture", photo, "-o", path, "--tile-size", 32, "--seed", 1)[0] == 0
    return path


def call(*arguments, capture=None):
    with pytest.raises(SystemExit) as ended:
        run([str(a) for a in arguments])
    out = capture.readouterr() if capture else None
    return ended.value.code, out


def test_from_photograph_to_picture_page_and_figures(photo, folder, tmp_path, capsys):
    code, out = call("texture", photo, "-o", tmp_path / "t", "--tile-size", 32, "--json", capture=capsys)
    figures = json.loads(out.out)
    assert (code, figures["tiles"], figures["tile_size"], figures["treatment"]) == (0, 80, 32, "even")
    picture = tmp_path / "a.png"
    code, out = call("render", folder, "-o", picture, "--x", -50, "--width", 200, "--height", 100,
                     "--lattice-seed", 7, "--json", capture=capsys)  # fmt: skip
    assert (code, json.loads(out.out)["width"]) == (0, 200)
    material = tw.load(folder)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))
    assert np.array_equal(tw.read_image(picture), field.render(-50, 0, 200, 100))
    code, out = call("analyze", folder, "-o", tmp_path / "sheet.png", "--json", capture=capsys)
    assert code == 0
    assert json.loads(out.out)["edge_cut_share"] < 0.06
    assert tw.read_image(tmp_path / "sheet.png").shape[0] > 500
    code, out = call("view", folder, "-o", tmp_path / "v.html", "--json", capture=capsys)
    assert (code, json.loads(out.out)["bytes"]) == (0, (tmp_path / "v.html").stat().st_size)


def test_a_gray_map_steers_a_two_source_set(photo, tmp_path):
    second = tmp_path / "second.png"
    tw.write_image(second, 255 - tw.read_image(photo))
    assert (
        call("texture", photo, "-o", tmp_path / "t", "--second", second, "--tile-size", 32, "--colors", 2)[0]
        == 0
    )
    tw.write_image(tmp_path / "map.png", np.array([[[0] * 3, [255] * 3]], np.uint8))
    assert call("render", tmp_path / "t", "-o", tmp_path / "a.png", "--density", tmp_path / "map.png",
                "--cells-per-pixel", 4, "--width", 256, "--height", 64)[0] == 0  # fmt: skip
    material = tw.load(tmp_path / "t")
    tiling = tw.density_tiling(material.tiles, np.array([[0.0, 1.0]]), cells_per_pixel=4)
    wanted = tw.TextureField(material, tiling).render(0, 0, 256, 64)
    assert np.array_equal(tw.read_image(tmp_path / "a.png"), wanted)


def test_the_same_seed_gives_the_same_folder(photo, folder, tmp_path):
    assert (
        call("texture", photo, "-o", tmp_path / "t", "--tile-size", 32, "--seed", 1, "--threads", 1)[0] == 0
    )
    files = sorted(p.relative_to(folder) for p in folder.rglob("*") if p.is_file())
    assert all((folder / f).read_bytes() == (tmp_path / "t" / f).read_bytes() for f in files)


def test_reject_and_pick(folder, tmp_path):
    assert call("texture", "--from", folder, "--reject", "center:3", "-o", tmp_path / "t")[0] == 0
    before, after = tw.load(folder).recipe, tw.load(tmp_path / "t").recipe
    assert before["patches"]["center:3"] != after["patches"]["center:3"]
    assert (
        call("texture", "--from", tmp_path / "t", "--pick", "center:3=0,10,20", "-o", tmp_path / "u")[0] == 0
    )
    assert tw.load(tmp_path / "u").recipe["patches"]["center:3"] == [0, 10, 20]


@pytest.mark.parametrize("tiles", ["wang", "cohen-18", "corner-coded"])
def test_other_sets_are_laid_too(photo, tmp_path, tiles):
    assert call("texture", photo, "-o", tmp_path / "t", "--tile-size", 16, "--tiles", tiles)[0] == 0
    assert call("render", tmp_path / "t", "-o", tmp_path / "a.tif", "--width", 100, "--height", 90)[0] == 0
    assert tw.read_image(tmp_path / "a.tif").shape == (90, 100, 1)


def test_pack(tmp_path, capsys):
    code, out = call(
        "pack", "--tiles", "wang", "--colors", 3, "-o", tmp_path / "p.npy", "--json", capture=capsys
    )
    assert (code, json.loads(out.out)["size"]) == (0, [9, 9])
    assert np.array_equal(np.sort(np.load(tmp_path / "p.npy").ravel()), np.arange(81))


def test_help_names_an_example_and_the_call(capsys):
    for command in ("texture", "render", "view", "analyze", "pack", "export"):
        code, out = call(command, "--help", capture=capsys)
        assert code == 0
        assert f"Example: tilewright {command}" in " ".join(out.out.split())
        assert "Calls tilewright." in out.out
        assert "--json" in out.out
        assert ("--seed" if command in ("texture", "analyze", "pack") else "--lattice-seed") in out.out


def test_completion_names_the_options_of_a_command():
    asked = {
        "_TILEWRIGHT_COMPLETE": "complete_bash",
        "COMP_WORDS": "tilewright texture --ti",
        "COMP_CWORD": "2",
    }
    start = "import sys; sys.argv = ['tilewright']; from tilewright.cli.main import main; main()"
    done = subprocess.run(
        [sys.executable, "-c", start], env=os.environ | asked, capture_output=True, text=True, check=False
    )
    assert done.stdout.split() == ["--tiles", "--tile-size"]


REFUSED = {
    "no such file": (("texture", "none.png"), "none.png does not exist"),
    "nothing": (("texture",), "PHOTO is missing"),
    "no colors": (("texture", "PHOTO", "--colors", "0"), "colors is 0; allowed are 1 to 16"),
    "many colors": (("texture", "PHOTO", "--colors", "17"), "colors is 17"),
    "odd size": (("texture", "PHOTO", "--tile-size", "33"), "must be even"),
    "size 0": (("texture", "PHOTO", "--tile-size", "0"), "--tile-size is 0"),
    "huge size": (("texture", "PHOTO", "--tile-size", "4096"), "allowed are 16 to 1024"),
    "size in words": (("texture", "PHOTO", "--tile-size", "big"), "expected a number of pixels or auto"),
    "too large": (("texture", "PHOTO", "--tile-size", "250"), "choose a smaller tile size"),
    "map without a name": (("texture", "--map", "a.png"), "expected NAME=FILE"[:12]),
    "pick": (("texture", "PHOTO", "--pick", "center:0=5"), "SOURCE,Y,X"),
    "tiles": (("texture", "PHOTO", "--tiles", "hex"), "--tiles is 'hex'"),
    "reject alone": (("texture", "PHOTO", "--reject", "center:0"), "give it with --from"),
    "no folder": (("render", "none", "-o", "a.png", "--width", "5", "--height", "5"), "is not a folder"),
    "seed of nothing": (("render", "none", "-o", "a.png", "--seed", "2"), "--lattice-seed gives another"),
    "no command": (("paint",), "paint"),
    "suffix": (("pack", "-o", "a.txt"), "allowed are .npy"),
    "where": (("texture", "PHOTO", "--tile-size", "32", "-o", "PHOTO/set"), "is not a folder"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refusals_are_one_line_and_exit_with_2(photo, tmp_path, monkeypatch, capsys, case):
    arguments, message = REFUSED[case]
    monkeypatch.chdir(tmp_path)
    code, out = call(*(a.replace("PHOTO", str(photo)) for a in arguments), capture=capsys)
    assert code == 2
    assert out.out == ""
    assert message in out.err
    assert len(out.err.strip().splitlines()) == 1
    assert not any(tmp_path.iterdir())


def test_importing_is_light():
    code = "import sys, tilewright; print([m for m in ('numba', 'scipy', 'numpy') if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_every_public_name_loads():
    for name in tw.__all__:
        assert getattr(tw, name) is not None
    with pytest.raises(AttributeError, match="attribute nonsense"):
        tw.nonsense  # noqa: B018
