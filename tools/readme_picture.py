"""Make docs/images/readme.jpg: a photograph, the photograph cropped and repeated, and the endless plane."""

from pathlib import Path

import numpy as np
import skimage.data
from PIL import Image

import tilewright as tw

TARGET = Path(__file__).parents[1] / "docs" / "images" / "readme.jpg"
SIDE = 640
GAP = 16


def main() -> None:
    """Make the picture."""
    photo = skimage.data.gravel()
    material = tw.texture_tiles(photo, method="faithful", seed=1)
    field = tw.TextureField(material, tw.direct(material.tiles, seed=7))
    plane = field.render(-1000, 2000, 2 * SIDE, 2 * SIDE)[..., 0]
    repeated = np.tile(photo[:256, :256], (5, 5))
    alone = np.full((2 * SIDE, 2 * SIDE), 255, np.uint8)
    top = SIDE - 256
    alone[top : top + 512, top : top + 512] = photo
    white = np.full((2 * SIDE, 2 * GAP), 255, np.uint8)
    whole = Image.fromarray(np.concatenate([alone, white, repeated, white, plane], axis=1))
    whole.resize((3 * SIDE + 2 * GAP, SIDE), Image.Resampling.LANCZOS).save(TARGET, quality=80)
    print(TARGET)


if __name__ == "__main__":
    main()
