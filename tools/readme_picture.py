"""Make docs/images/readme.jpg: two photographs, each cropped and repeated, and as an endless plane."""

import sys
from pathlib import Path

import numpy as np
import skimage.data
from numpy.typing import NDArray
from PIL import Image

import tilewright as tw

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "examples"))

from gallery import labeled, synthesized, wall  # noqa: E402

TARGET = ROOT / "docs" / "images" / "readme.jpg"
SIDE = 480


def main() -> None:
    """Make the picture."""
    shown = panels("Hubble's deep field (NASA)", skimage.data.hubble_deep_field(), 2)
    shown |= panels("A wall", wall("herringbone", (96, 24)), 1)
    Image.fromarray(labeled(shown)).save(TARGET, quality=85)
    print(TARGET)


def panels(name: str, photo: NDArray[np.uint8], reduced: int) -> dict[str, NDArray[np.uint8]]:
    """A photograph, a part of it repeated, and a plane; ``reduced`` pixels along one of the picture."""
    side = SIDE * reduced
    part = photo[: side // 3, : side // 3]
    material = synthesized(photo)
    field = tw.TextureField(material, tw.direct(material.tiles, seed=7))
    shown = {
        f"{name}: what is given": photo[:side, :side],
        f"{name}: a part repeated": np.tile(part, (3, 3, 1)),
        f"{name}: tilewright, without end": field.render(-1000, 2000, side, side),
    }
    size = (SIDE, SIDE)
    return {
        label: np.asarray(Image.fromarray(pixels).resize(size, Image.Resampling.LANCZOS))
        for label, pixels in shown.items()
    }


if __name__ == "__main__":
    main()
