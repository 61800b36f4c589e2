"""What several test files share: real photographs where they are at hand, and one that always is."""

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from browsing import CHROMIUM, FLAGS, on_one_core

SHARED = Path(__file__).parents[2] / "shared"
PHOTOGRAPHS = SHARED / "data" / "textures"


@pytest.fixture(scope="session")
def gravel() -> NDArray[np.uint8]:
    """scikit-image's gravel, 512 x 512 x 1."""
    import skimage.data

    return skimage.data.gravel()[..., np.newaxis]


@pytest.fixture
def small_photographs(monkeypatch):
    """A part of each of scikit-image's photographs that pages and examples name: the code is the same."""
    import skimage.data

    for name in ("gravel", "grass"):
        part = getattr(skimage.data, name)()[:200, :200]
        monkeypatch.setattr(skimage.data, name, part.copy)


@pytest.fixture(scope="session")
def gravel_tiles(gravel):
    """Sixteen corner tiles of 64 pixels of gravel."""
    import tilewright as tw

    return tw.texture_tiles({"a": gravel}, tw.corner_tiles(2), tile_size=64, seed=1, method="nested")


@pytest.fixture(scope="session")
def crossed_points():
    """Points in Wang tiles that know the edges around their corners: 4,096 tiles of 16 points."""
    import tilewright as tw

    return tw.make_point_tiles("edge", 16, 0.7, seed=4)


@pytest.fixture(scope="session")
def photograph():
    """Load a photograph by name from the folder beside the checkout, or skip the test."""
    from PIL import Image

    def load(name: str) -> NDArray[np.uint8]:
        path = PHOTOGRAPHS / f"{name}.png"
        if not path.exists():
            pytest.skip(f"{path.name} is not at hand")
        pixels = np.asarray(Image.open(path))
        return pixels if pixels.ndim == 3 else pixels[..., np.newaxis]

    return load


@pytest.fixture(scope="session")
def case():
    """Find a file or folder as people bring them, in the folder beside the checkout, or skip the test."""

    def find(name: str) -> Path:
        path = SHARED / "cases" / name
        if not path.exists():
            pytest.skip(f"{name} is not at hand")
        return path

    return find


@pytest.fixture(scope="session")
def darts():
    """Ten sets of 4,096 points by dart throwing."""
    from tilewright.samplers import dart_throwing

    return [dart_throwing(4096, 0.7, seed=seed) for seed in range(10)]


@pytest.fixture(scope="session")
def dart_report(darts):
    """What is measured of them."""
    from tilewright.analysis import analyze_points
    from tilewright.samplers import dart_throwing

    return analyze_points(darts, plate=dart_throwing(2**18, 0.7, seed=10), name="darts")


@pytest.fixture(scope="module")
def browser():
    """Headless Chromium."""
    if CHROMIUM is None:
        pytest.skip("no Chromium was found")
    from playwright.sync_api import sync_playwright

    with on_one_core():
        play = sync_playwright().start()
        opened = play.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
    yield opened
    opened.close()
    play.stop()
