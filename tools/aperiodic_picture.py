"""Make docs/images/aperiodic.png: windows of four aperiodic tilings."""

from pathlib import Path

import numpy as np
from PIL import Image

import tilewright as tw

TARGET = Path(__file__).parents[1] / "docs" / "images" / "aperiodic.png"
GAP = 12


def panel(name: str) -> np.ndarray:
    """Some tiles of a set, far away."""
    tiling = tw.aperiodic_tiling(tw.aperiodic_tiles(name), seed=1)
    return tw.paint_tiling(tiling, 10**12, 10**12, 28, 18, size=22)


def main() -> None:
    """Paint and save."""
    upper, lower = (
        np.concatenate([panel(west), np.full((18 * 22, GAP, 3), 255, np.uint8), panel(east)], axis=1)
        for west, east in (("jeandel-rao-11-5", "kari-14"), ("ammann-16", "jeandel-rao-24"))
    )
    sheet = np.concatenate([upper, np.full((GAP, upper.shape[1], 3), 255, np.uint8), lower])
    Image.fromarray(sheet).quantize(128).save(TARGET, optimize=True)
    print(TARGET)


if __name__ == "__main__":
    main()
