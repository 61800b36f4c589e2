"""Make docs/images/readme.jpg: two photographs, each cropped and repeated, and as an endless plane."""

import sys
from pathlib import Path

import numpy as np
import skimage.data
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

import tilewright as tw

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "examples"))

from gallery import make_parquet  # noqa: E402

TARGET = ROOT / "docs" / "images" / "readme.jpg"
SIDE = 480
GAP = 12
LINE = 30


def main() -> None:
    """Make the picture."""
    deep_field = skimage.data.hubble_deep_field()
    rows = [
        panels("Hubble's deep field (NASA)", deep_field, 2, seed=1),
        panels("Parquet", make_parquet(), 1, seed=1),
    ]
    height = len(rows) * (SIDE + LINE)
    sheet = Image.new("RGB", (3 * SIDE + 2 * GAP, height), "white")
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(20)
    for row, shown in enumerate(rows):
        for column, (label, pixels) in enumerate(shown.items()):
            x, y = column * (SIDE + GAP), row * (SIDE + LINE)
            draw.text((x, y + 3), label, "black", font)
            sheet.paste(Image.fromarray(pixels), (x, y + LINE))
    sheet.save(TARGET, quality=85)
    print(TARGET)


def panels(name: str, photo: NDArray[np.uint8], reduced: int, seed: int) -> dict[str, NDArray[np.uint8]]:
    """A photograph, a part of it repeated, and a plane; ``reduced`` pixels along one of the picture."""
    side = SIDE * reduced
    part = photo[: side // 3, : side // 3]
    material = tw.texture_tiles(photo, seed=seed)
    field = tw.TextureField(material, tw.direct(material.tiles, seed=7))
    shown = {
        f"{name}: the photograph": photo[:side, :side],
        "a part of it repeated": np.tile(part, (4, 4, 1))[:side, :side],
        "tilewright, without end": field.render(-1000, 2000, side, side),
    }
    return {label: fitted(pixels) for label, pixels in shown.items()}


def fitted(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """A picture as large as a panel."""
    return np.asarray(Image.fromarray(pixels).resize((SIDE, SIDE), Image.Resampling.LANCZOS))


if __name__ == "__main__":
    main()
