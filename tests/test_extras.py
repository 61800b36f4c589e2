"""The core works without the packages of the extras, and says in one line which extra something needs."""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from tilewright.extras import EXTRAS

ROOT = Path(__file__).parents[1]
WITHOUT = """
import sys

class Without:
    def find_spec(self, name, path=None, target=None):
        without = {"pyarrow", "finufft", "matplotlib", "pandas", "pysat", "wgpu", "imageio_ffmpeg", "trimesh"}
        if name.partition(".")[0] in without:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)

sys.meta_path.insert(0, Without())
"""
CORE = """
import numpy as np
import tilewright as tw
from tilewright.cli.main import app

def do(*words):
    app([str(word) for word in words], standalone_mode=False)

tw.write_image("photo.png", np.random.default_rng(1).integers(0, 256, (96, 96, 3)).astype(np.uint8))
do("texture", "photo.png", "-o", "set", "--tile-size", 32)
do("render", "set", "-o", "plane.png", "--width", 100, "--height", 80)
do("pack", "--colors", 2, "-o", "packing.npy")
for suffix in ("npy", "npz", "csv", "txt", "ply"):
    do("points", "--count", 1000, "-o", f"p.{suffix}")
    do("analyze", f"p.{suffix}", "--width", 6, "--height", 6)
    assert len(tw.read_points(f"p.{suffix}", tw.Box((6, 6), torus=False))) == 1000
found = tw.analyze(tw.sample_points("dart", 500, seed=1))
assert 0.2 < found.figures["effective_nyquist"] < 0.6 and "coverage" in found.figures
assert tw.find_spikes(tw.ready_tiles(3)).doubled > 0
assert not {"pyarrow", "finufft", "matplotlib"} & set(sys.modules)
"""
NEEDS = {
    "parquet written": ('tw.write_points("p.parquet", [[0.5, 0.5]])', "pyarrow", "points"),
    "parquet asked for": ('run("points", "--count", "1", "-o", "p.parquet")', "pyarrow", "points"),
    "parquet read": ('open("p.parquet", "w").close(); tw.read_points("p.parquet")', "pyarrow", "points"),
    "a table of Arrow": ("tw.PointSet([[0.5, 0.5]]).to_arrow()", "pyarrow", "points"),
    "tiles by name": ('tw.make_point_tiles("corner", seed=1)', "finufft", "points"),
    "tiles": ("tw.poisson_tiles(tw.corner_tiles(2), seed=1)", "finufft", "points"),
    "tiles by command": ('run("points", "--count", "1", "--seed", "1", "-o", "p.npy")', "finufft", "points"),
    "a sheet": ('run("analyze", "none.npy", "-o", "sheet.png")', "matplotlib", "plots"),
    "a comparison": ('run("compare", "-o", "folder")', "matplotlib", "plots"),
    "a plot": ("tw.plot_points([[0.5, 0.5]])", "matplotlib", "plots"),
    "a solver": ('tw.complete_dapple([[0, -1]], {"H0": 2})', "python-sat", "solve"),
    "a filling": ("tw.filled_tiling(tw.wang_tiles(2), 3, 3)", "python-sat", "solve"),
    "a mesh": ('open("m.glb", "w").write("x"); tw.read_mesh("m.glb")', "trimesh", "meshes"),
    "a video": ('run("flow", "-o", "f.mp4")', "imageio-ffmpeg", "video"),
    "a table of pandas": ("tw.PointSet([[0.5, 0.5]]).to_pandas()", "pandas", ""),
}
ASKED = """
import tilewright as tw

def run(*words):
    from tilewright.cli.main import app
    app(list(words), standalone_mode=False)

try:
    {}
except tw.MissingExtra as error:
    print(error)
else:
    print("nothing was missing")
"""


def python(code, folder):
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", code], cwd=folder, capture_output=True, text=True, check=False
    )


def test_the_core_works_without_them(tmp_path):
    done = python(WITHOUT + CORE, tmp_path)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("what", NEEDS)
def test_the_need_of_an_extra_is_one_line_that_names_it(tmp_path, what):
    code, package, extra = NEEDS[what]
    done = python(WITHOUT + ASKED.format(code), tmp_path)
    install = rf'"tilewright\[{extra}\]"' if extra else package
    assert re.fullmatch(
        rf".+ needs the package {package}; install it with: pip install {install}\n", done.stdout
    ), done.stdout + done.stderr
    assert [path.name for path in tmp_path.iterdir() if path.name not in ("p.parquet", "m.glb")] == []


def test_extras_are_those_of_the_project():
    listed = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    for extra, package in EXTRAS.values():
        assert not extra or any(re.split("[>=]", one)[0] == package for one in listed[extra])
    everything = {extra for extra, _ in EXTRAS.values() if extra}
    assert set(re.fullmatch(r"tilewright\[(.*)\]", *listed["all"])[1].split(",")) == everything
