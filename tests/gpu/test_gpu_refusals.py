"""What a GPU cannot draw, said in one line."""

import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest

import tilewright as tw
from drawing import drawn
from handmade import handmade
from tilewright.errors import GpuError, TilewrightError, TilewrightTypeError, TilewrightValueError
from tilewright.gpu import (
    GpuField,
    GpuPicture,
    OrthographicCamera,
    PerspectiveCamera,
    device as device_module,
)
from tilewright.gpu.device import open_gpu
from tilewright.gpu.painter import check_fits
from tilewright.shaders.assembly import VERTEX, read_part
from tilewright.shaders.layouts import make_layout


def test_nothing_imports_wgpu_before_a_field_is_made():
    code = "import sys, tilewright, tilewright.gpu.field; sys.exit('wgpu' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_without_wgpu(monkeypatch):
    monkeypatch.setitem(sys.modules, "wgpu", None)
    monkeypatch.setattr(device_module, "open_gpu", open_gpu.__wrapped__)
    with pytest.raises(GpuError, match=r'pip install "tilewright\[gpu\]"$'):
        device_module.open_gpu()
    assert issubclass(GpuError, TilewrightError)


def test_without_a_driver(monkeypatch):
    def refuse(**given):
        raise RuntimeError("no adapter")

    monkeypatch.setitem(
        sys.modules, "wgpu", SimpleNamespace(gpu=SimpleNamespace(request_adapter_sync=refuse))
    )
    with pytest.raises(GpuError, match=r"apt-get install mesa-vulkan-drivers$"):
        open_gpu.__wrapped__()


@drawn
def test_a_refused_shader_shows_its_log():
    broken = "#version 450\nvoid main() { nonsense(1); }"
    with pytest.raises(GpuError, match=r"could not be compiled; the compiler says:\n(.|\n)*nonsense"):
        open_gpu().program(read_part(VERTEX), broken, "rgba8unorm")


def test_what_does_not_fit():
    tiles = tw.corner_tiles(2)
    gpu = SimpleNamespace(name="Small", longest_side=63, most_layers=15)
    with pytest.raises(
        GpuError, match="atlas is 64 x 64 texels, Small takes 63 along a side; use fewer colors"
    ):
        check_fits(make_layout(handmade(tiles, 16), "atlas", None), gpu)
    with pytest.raises(GpuError, match="16 layers, Small takes 15; use layout='atlas'"):
        check_fits(make_layout(handmade(tiles, 16), "array", None), gpu)


@pytest.mark.parametrize(
    ("tiles", "given", "message"),
    [
        (tw.corner_tiles(3, 2), {}, "and complete Wang sets, not the .* set of 54"),
        (tw.wang_tiles(2), {"layout": "array"}, "Wang tiles need 'atlas'"),
        (tw.corner_tiles(2), {"layout": "cube"}, "layout is 'cube'; allowed are array, atlas"),
        (tw.corner_tiles(2), {"map": "gloss"}, "map is 'gloss'"),
    ],
)
def test_materials_without_a_shader(tiles, given, message):
    with pytest.raises(TilewrightValueError, match=message):
        GpuField(handmade(tiles, 16), tw.direct(tiles), **given)


@pytest.mark.parametrize(
    ("tiling", "message"),
    [
        (
            lambda t: tw.direct(t, hash="long-period"),
            "hash is long-period; on a GPU there are mixer and perm",
        ),
        (lambda t: tw.direct(t, hash=tw.PermutationHash(0, nested=False)), "nested=False"),
        (lambda t: tw.direct(t, hash=tw.PermutationHash(0, 100)), "100 entries; for 3 colors"),
        (lambda t: tw.direct(t, period=(4, None)), "repeats after"),
        (lambda t: tw.scanline(t, 4, 4), r"use direct\(tiles, seed\)"),
    ],
)
def test_tilings_without_a_shader(tiling, message):
    tiles = tw.corner_tiles(3)
    with pytest.raises(TilewrightValueError, match=message):
        GpuField(handmade(tiles, 16), tiling(tiles))


def test_hashes_by_sums_have_no_shader():
    tiles = tw.wang_tiles(2)
    with pytest.raises(TilewrightValueError, match="wang='edge-hash'"):
        GpuField(handmade(tiles, 16), tw.direct(tiles, wang="two-hashes"))


@pytest.mark.parametrize(
    ("kind", "given", "message"),
    [
        (OrthographicCamera, {"width": 0}, "width is 0; allowed are 1 to 32768"),
        (OrthographicCamera, {"scale": 0}, "scale is 0"),
        (OrthographicCamera, {"x": float("nan")}, "x is nan"),
        (PerspectiveCamera, {"tilt": 2}, "tilt is 2"),
        (PerspectiveCamera, {"altitude": -1}, "altitude is -1"),
    ],
)
def test_cameras_out_of_range(kind, given, message):
    with pytest.raises(TilewrightValueError, match=message):
        kind(**given)


def test_the_end_of_the_plane():
    with pytest.raises(TilewrightValueError, match=r"x is \d+; cells reach to \+-2\^61"):
        OrthographicCamera(2**65 + 16, 0).sight(0, 0, 8, 8, 16)


@drawn
def test_a_camera_is_needed():
    tiles = tw.corner_tiles(2)
    with pytest.raises(TilewrightTypeError, match="camera must be"):
        GpuField(handmade(tiles, 16), tw.direct(tiles)).render((0, 0, 8, 8))
    with pytest.raises(TilewrightValueError, match="expected a square"):
        GpuPicture(np.zeros((4, 5, 3), np.uint8))
