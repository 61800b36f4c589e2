"""What several test files share: real photographs where they are at hand, and one that always is."""

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

PHOTOGRAPHS = Path(__file__).parents[2] / "shared" / "data" / "textures"


@pytest.fixture(scope="session")
def gravel() -> NDArray[np.uint8]:
    """scikit-image's gravel, 512 x 512 x 1."""
    import skimage.data

    return skimage.data.gravel()[..., np.newaxis]


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
