"""The program as a process: one line on stderr, exit code 2, nothing left behind."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import tilewright as tw
from tilewright.cli.main import run

PROGRAM = Path(sys.executable).with_name("tilewright")

pytestmark = pytest.mark.skipif(not PROGRAM.exists(), reason="the program is not installed")


@pytest.fixture(scope="module")
def work(tmp_path_factory, gravel):
    folder = tmp_path_factory.mktemp("program")
    tw.write_image(folder / "g.png", gravel[:200, :200])
    assert call(folder, "texture", "g.png", "-o", "set", "--tile-size", 32, "--colors", 2).returncode == 0
    return folder


def call(folder, *arguments, **options):
    command = [str(PROGRAM), *map(str, arguments)]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=120, **options)


def snapshot(folder):
    return {p.relative_to(folder): p.read_bytes() for p in folder.rglob("*") if p.is_file()}


REFUSED = {
    "threads": (("texture", "g.png", "-o", "t", "--threads", -1), "threads is -1; allowed are 1 to 1024"),
    "weight NaN": (("texture", "g.png", "-o", "t", "--weight", "albedo=nan"), "'albedo' is nan"),
    "weight of none": (("texture", "g.png", "-o", "t", "--weight", "foo=1"), "'foo'; allowed are albedo"),
    "weights 0": (("texture", "g.png", "-o", "t", "--weight", "albedo=0"), "at least one map must count"),
    "twice": (("texture", "g.png", "-o", "t", "--map", "albedo=g.png"), "albedo is given twice"),
    "from and more": (("texture", "--from", "set", "-o", "t", "--seed", 9), "--seed has no use with --from"),
    "method": (("texture", "g.png", "-o", "t", "--method", ""), "method is ''"),
    "sheet": (("analyze", "set", "-o", "sheet"), "the sheet's suffix is ''"),
    "sheet kind": (("analyze", "set", "-o", "a.npy"), "the sheet's suffix is '.npy'"),
    "into the set": (("render", "set", "-o", "set/albedo/00.png", "--width", 9, "--height", 9),
                     "lies in the tile-set folder"),
    "early": (("texture", "g.png", "-o", "g.png", "--tile-size", 512), "g.png is a file"),
    "not UTF-8": (("texture", os.fsdecode(b"b\xff.png"), "-o", "t"), "not a name in UTF-8"),
    "no rows": (("texture", "short.png", "-o", "t"), "short.png is truncated or damaged"),
    "escapes": (("texture", "\x1b[31mred.png", "-o", "t"), "\\x1b[31mred.png does not exist"),
}  # fmt: skip


# The others run in this process, which is the same but for its start.
AS_PROCESS = {"threads", "not UTF-8", "no rows"}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_refused(work, case, monkeypatch, capfd):
    arguments, message = REFUSED[case]
    (work / "notes").write_text("precious")
    (work / "short.png").write_bytes(cut_rows((work / "g.png").read_bytes()))
    before = snapshot(work)
    if case in AS_PROCESS:
        done = call(work, *arguments)
        code, out, error = done.returncode, done.stdout, done.stderr
    else:
        monkeypatch.chdir(work)
        with pytest.raises(SystemExit) as end:
            run([str(a) for a in arguments])
        code, (out, error) = end.value.code, capfd.readouterr()
    assert code == 2
    assert message in error
    assert error.count("\n") == 1
    assert out == ""
    assert snapshot(work) == before


def cut_rows(png):
    """A PNG whose header promises more rows than there are, with right checksums."""
    import zlib

    header = bytearray(png[12:29])
    header[8:12] = (999).to_bytes(4)
    return png[:12] + bytes(header) + zlib.crc32(bytes(header)).to_bytes(4) + png[33:]


@pytest.mark.skipif(not hasattr(signal, "SIGTERM") or os.name == "nt", reason="needs POSIX signals")
@pytest.mark.parametrize("number", ["SIGINT", "SIGTERM"])
def test_an_ended_program_leaves_nothing(work, tmp_path, number):
    size = ["--width", "60000", "--height", "60000"]
    command = [str(PROGRAM), "render", str(work / "set"), "-o", str(tmp_path / "a.png"), *size]
    # A shell in the background hands its children an ignored SIGINT.
    running = subprocess.Popen(
        command, stderr=subprocess.PIPE, preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)
    )
    for _ in range(200):
        if any(tmp_path.iterdir()):
            break
        time.sleep(0.05)
    assert any(tmp_path.iterdir())
    running.send_signal(getattr(signal, number))
    said = running.communicate(timeout=60)[1]
    assert running.returncode == 130
    assert said == b"tilewright: stopped\n"
    assert not any(tmp_path.iterdir())


def test_a_damaged_recipe_is_told_when_it_is_needed(work, tmp_path):
    shutil.copytree(work / "set", tmp_path / "set")
    manifest = tmp_path / "set" / "tileset.json"
    whole = json.loads(manifest.read_text())
    for broken in ({}, whole["recipe"] | {"weights": "x"}, whole["recipe"] | {"patches": {"center:0": 1}}):
        manifest.write_text(json.dumps(whole | {"recipe": broken}))
        done = call(tmp_path, "texture", "--from", "set", "-o", "t", "--reject", "center:0")
        assert (done.returncode, done.stderr.count("\n")) == (2, 1)
        assert "recipe cannot be replayed" in done.stderr
    manifest.write_bytes(json.dumps(whole).encode().replace(b"corner", b"c\xffrner"))
    assert "is damaged" in call(tmp_path, "analyze", "set").stderr
    manifest.write_text(json.dumps(whole | {"tiles": whole["tiles"] | {"colors": [10**30] * 4}}))
    done = call(tmp_path, "analyze", "set")
    assert (done.returncode, done.stderr.count("\n")) == (2, 1)
    manifest.unlink()
    if hasattr(os, "mkfifo"):
        os.mkfifo(manifest)
        assert "not a plain file" in call(tmp_path, "analyze", "set").stderr


def test_full_output_is_one_line(work):
    if not Path("/dev/full").exists():
        pytest.skip("there is no /dev/full")
    with open("/dev/full", "w") as full:
        command = [str(PROGRAM), "analyze", "set", "--json", "--quiet"]
        done = subprocess.run(command, cwd=work, stdout=full, stderr=subprocess.PIPE, timeout=120)
    assert (done.returncode, done.stderr.count(b"\n")) == (2, 1)


@pytest.mark.skipif(os.name == "nt", reason="needs a POSIX shell")
def test_it_works_without_a_stderr(work):
    command = f"'{PROGRAM}' pack --colors 3 -o packed.npy 2>&-"
    done = subprocess.run(["sh", "-c", command], cwd=work, capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stderr) == (0, "")
    (work / "packed.npy").unlink()


def test_names_beyond_ascii(work):
    done = call(work, "render", "set", "-o", "ü.png", "--width", 5, "--height", 5,
                env=os.environ | {"PYTHONIOENCODING": "ascii"})  # fmt: skip
    assert (done.returncode, done.stderr) == (0, "")
    assert tw.read_image(work / "ü.png").shape == (5, 5, 1)
    (work / "ü.png").unlink()


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda g: tw.texture_tiles(g, "x"), "tiles must be a TileSet"),
        (lambda g: tw.texture_tiles(g, tile_size=np.zeros(3)), "tile_size must be an integer"),
        (lambda g: tw.texture_tiles(g, threads=float("nan")), "threads must be an integer"),
        (lambda g: tw.texture_tiles(g, pick=[1]), "pick must be a dict"),
        (lambda g: tw.texture_tiles(g, pick={"center:0": (0, 1)}), r"must hold \(source, y, x\)"),
        (lambda g: tw.texture_tiles(g, reject={"center:0": (0, 1, 1)}), r"must hold \(source, y, x\)"),
        (lambda g: tw.texture_tiles(g, second_mask=g), "give second too"),
        (lambda g: tw.texture_tiles(g, weights=[1]), "weights must be a dict"),
        (lambda g: tw.texture_tiles({1: g}), "a map is named '1'"),
        (lambda g: tw.texture_tiles(g, second=3), "second must be a path"),
        (lambda g: tw.texture_tiles(g.astype(np.float32) * 1e30), "allowed are -1e\\+12"),
        (lambda g: tw.read_image(None), "path must be a str"),
        (lambda g: tw.load(""), "path is empty"),
        (lambda g: tw.save(None, "x"), "material must be TextureTiles"),
        (lambda g: tw.analyze(None), "material must be TextureTiles"),
        (lambda g: tw.resynthesize(None), "material must be TextureTiles"),
        (lambda g: tw.TextureField(None, None), "a field takes TextureTiles"),
        (lambda g: tw.ListedTileSet(tw.corner_tiles(2).shape, [[0] * 4], (10**30,) * 4), "colors is 1000000"),
        (lambda g: tw.save_viewer("x", "a.html"), "material must be TextureTiles"),
        (lambda g: tw.make_atlas("x"), "material must be TextureTiles"),
        (lambda g: tw.save_atlas("x", "a.png"), "material must be TextureTiles"),
        (lambda g: tw.save_array("x", "a.png"), "material must be TextureTiles"),
        (lambda g: tw.find_regularity("photo.png"), "pixels must be an array"),
        (lambda g: tw.find_regularity(g[..., 0]), r"pixels has shape \(200, 200\)"),
        (lambda g: tw.TextureTiles(1, 2, 3, 4), "tiles must be a TileSet"),
        (lambda g: tw.TextureTiles(tw.corner_tiles(2), {"a": 1}, (), g), "map 'a' must be an array"),
        (lambda g: tw.array_tiling(tw.corner_tiles(2), [[0]], torus=np.zeros(3)), "torus must be True or"),
        (lambda g: tw.dapple(np.zeros((3, 3), int), {"H0": 2}, cyclic=np.zeros(3)), "cyclic must be True or"),
        (
            lambda g: tw.texture_tiles(g, tw.corner_tiles(2), tile_size=16, progress=3),
            "progress must be a func",
        ),
        (lambda g: tw.ListedTileSet(tw.corner_tiles(2).shape, [[0] * 4], (2, 2, 2, 3)), "need equally many"),
    ],
)
def test_wrong_types_get_one_clear_line(gravel, make, message):
    with pytest.raises(tw.TilewrightError, match=message) as error:
        make(gravel[:200, :200])
    assert "\n" not in str(error.value)


LOADING = """
import os, signal, sys, threading
from tilewright.__main__ import main
sys.argv = ["tilewright", "pack", "--colors", "4", "-o", sys.argv[2]]
threading.Timer({delay}, os.kill, (os.getpid(), signal.SIGINT)).start()
main()
"""


@pytest.mark.skipif(os.name == "nt", reason="needs POSIX signals")
@pytest.mark.parametrize("delay", [0.02, 0.1, 0.3])
def test_a_signal_while_the_program_loads_is_one_line(tmp_path, delay):
    command = [sys.executable, "-c", LOADING.format(delay=delay), "-", str(tmp_path / "p.png")]
    # A shell in the background hands its children an ignored SIGINT.
    done = subprocess.run(
        command, capture_output=True, timeout=60, check=False,
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (130, b"tilewright: stopped\n")
    assert not any(tmp_path.iterdir())
