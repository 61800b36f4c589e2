"""Speed, each figure beside a peer or a physical limit in the same run; ratios are what counts.

``make bench`` fails where one is missed, and tells which fell by more than a third since they were stored in
``ratios.json``; ``-s`` shows them all.
"""

import subprocess
import sys

import numpy as np
import pytest

import tilewright as tw
from timing import best


def test_render_against_copyto(benchmark, record_ratio):
    tiles = tw.corner_tiles(2)
    rng = np.random.default_rng(0)
    pixels = rng.integers(0, 255, (16, 256, 256, 3)).astype(np.uint8)
    origins = np.zeros((16, 256, 256, 3), np.uint16)
    material = tw.TextureTiles(tiles, {"a": pixels}, ({"a": pixels[0]},), origins)
    field = tw.TextureField(material, tw.direct(tiles, 7))
    out = np.empty((8192, 8192, 3), np.uint8)
    given = rng.integers(0, 255, out.shape).astype(np.uint8)
    field.render(5, 9, 8192, 8192, out=out)
    peer = best(lambda: np.copyto(out, given))
    benchmark.pedantic(lambda: field.render(5, 9, 8192, 8192, out=out), rounds=5)
    took = benchmark.stats.stats.median
    record_ratio("render 8192 x 8192: of copyto", peer, benchmark.stats.stats.min)
    print(f"\nrender 8192 x 8192: {peer / took:.2f} of copyto")
    assert peer / took >= 0.5


@pytest.mark.parametrize(("colors", "most"), [(2, 5), (3, 25)])
def test_building_a_set(benchmark, colors, most):
    import skimage.data

    photo = np.repeat(skimage.data.gravel()[..., None], 3, axis=2)
    tw.texture_tiles(photo, tw.corner_tiles(1))
    benchmark.pedantic(lambda: tw.texture_tiles(photo, tw.corner_tiles(colors), seed=1), rounds=3)
    assert benchmark.stats.stats.median <= most


def test_import(benchmark):
    def start(code):
        subprocess.run([sys.executable, "-c", code], check=True)

    empty = best(lambda: start("pass"))
    benchmark.pedantic(lambda: start("import tilewright"), rounds=7)
    assert benchmark.stats.stats.median - empty <= 0.15


STREAM = """
import sys
import tilewright as tw
material = tw.load(sys.argv[1])
field = tw.TextureField(material, tw.direct(material.tiles))
field.save(sys.argv[2], width=16384, height=int(sys.argv[3]))
# The figure of getrusage starts from the parent's, so the process's own memory map is read.
print(int(next(line for line in open("/proc/self/status") if line.startswith("VmHWM")).split()[1]) / 1024)
"""


def test_streaming_16384(benchmark, tmp_path):
    import skimage.data

    photo = np.repeat(skimage.data.gravel()[..., None], 3, axis=2)
    tw.save(tw.texture_tiles(photo, seed=1), tmp_path / "set")

    def peak(height):
        command = [sys.executable, "-c", STREAM, str(tmp_path / "set"), str(tmp_path / "a.tif"), str(height)]
        done = subprocess.run(command, check=True, capture_output=True, text=True)
        return float(done.stdout)

    small = peak(2048)
    large = benchmark.pedantic(lambda: peak(16384), rounds=1)
    print(f"\npeak memory: {small:.0f} MB at 16384 x 2048, {large:.0f} MB at 16384 x 16384")
    assert large < 500
    assert large < small + 40
