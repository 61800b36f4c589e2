"""Time of a sample on the GPU at hand, beside a plain texture fetch in the same run; reported, not judged.

On a software GPU the figures say what a CPU makes of the shaders and nothing of a real GPU; instruction
counts that hold on any are in ``docs/gpu.md``.
"""

import numpy as np
import pytest

import tilewright as tw
from handmade import under_clouds
from timing import best

pytest.importorskip("wgpu")

from tilewright.errors import GpuError
from tilewright.gpu import GpuField, GpuPicture, OrthographicCamera
from tilewright.gpu.device import open_gpu
from tilewright.gpu.painter import BLOCK

FRAMES = 8


@pytest.fixture(scope="module")
def gpu():
    try:
        return open_gpu()
    except GpuError as error:
        pytest.skip(str(error))


def random_tiles(tiles, size=128):
    rng = np.random.default_rng(0)
    pixels = rng.integers(0, 255, (len(tiles), size, size, 3)).astype(np.uint8)
    origins = np.zeros((*pixels.shape[:3], 3), np.uint16)
    return tw.TextureTiles(tiles, {"a": pixels}, ({"a": pixels[0]},), origins)


def drawing(drawn, scale, tile_size):
    """Draw a block several times; reading a pixel waits for the GPU."""
    camera = OrthographicCamera(0.3, 0.3, BLOCK, BLOCK, scale)
    view = drawn._view(camera.sight(0, 0, BLOCK, BLOCK, tile_size))

    def job():
        for _ in range(FRAMES):
            drawn._painter.draw(view, "trilinear")
        drawn._painter.read(1, 1)

    return job


def report(benchmark, gpu, what, field, plain, scale):
    """Time a field and a plain texture in turn, so that what else runs on the machine slows both."""
    ours, theirs = drawing(field, scale, 128), drawing(plain, scale, 512)
    pairs = [(best(ours, 1), best(theirs, 1)) for _ in range(9)]
    benchmark.pedantic(ours, rounds=3)
    ratio = np.median([a / b for a, b in pairs])
    each = min(a for a, _ in pairs) / FRAMES / BLOCK**2 * 1e9
    print(f"\n{gpu.name}: {what}, {scale} texels a pixel: {each:.1f} ns, {ratio:.2f} of plain")


@pytest.mark.parametrize("scale", [1, 4, 24])
@pytest.mark.parametrize("toned", [False, True])
def test_a_sample_of_the_default_against_a_plain_fetch(benchmark, gpu, toned, scale):
    tiles = tw.classed_corner_tiles(2, 5)
    material, tiling = random_tiles(tiles), tw.direct(tiles, 7)
    plain = GpuPicture(tw.TextureField(material, tiling).render(0, 0, 512, 512))
    if toned:
        material = under_clouds(material, 1)
    report(benchmark, gpu, "under tone" if toned else "classes", GpuField(material, tiling), plain, scale)


@pytest.mark.parametrize("scale", [1, 4, 24])
@pytest.mark.parametrize("hash", ["mixer", "permutation"])
@pytest.mark.parametrize("method", ["array", "atlas", "wei"])
def test_a_sample_against_a_plain_fetch(benchmark, gpu, method, hash, scale):
    tiles = tw.wang_tiles(2) if method == "wei" else tw.corner_tiles(2)
    material, tiling = random_tiles(tiles), tw.direct(tiles, 7, hash=hash)
    field = GpuField(material, tiling, layout="array" if method == "array" else "atlas")
    plain = GpuPicture(tw.TextureField(material, tiling).render(0, 0, 512, 512))
    report(benchmark, gpu, f"{method}, {hash}", field, plain, scale)
