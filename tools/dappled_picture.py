"""Make docs/images/dappled.png: a pear in two tiles, dappled; a random tiling in three motifs."""

from pathlib import Path

import numpy as np
from PIL import Image

import tilewright as tw

TARGET = Path(__file__).parents[1] / "docs" / "images" / "dappled.png"
GAP = 12
WIDTH, HEIGHT = 136, 160
LONGEST = 5
INK, PAPER = "#1d1d26", "#faf5e8"


def pear() -> np.ndarray:
    """A still life as brightness from 0 to 1: a pear on a table, lit from the upper left."""
    x, y = np.meshgrid(np.linspace(-1, 1, 4 * WIDTH), np.linspace(-1.17, 1.17, 4 * HEIGHT))
    light = np.array([-0.5, -0.62, 0.6])
    height = np.zeros_like(x)
    for z in np.linspace(0, 0.8, 200):
        inside = _field(x, y, z) > 1
        height[inside] = z
    there = _field(x, y, 0) > 1
    step = 1e-3
    normal = -np.stack([
        _field(x + step, y, height) - _field(x - step, y, height),
        _field(x, y + step, height) - _field(x, y - step, height),
        _field(x, y, height + step) - _field(x, y, height - step),
    ])  # fmt: skip
    normal /= np.maximum(np.linalg.norm(normal, axis=0), 1e-9)
    lit = np.clip(np.tensordot(light / np.linalg.norm(light), normal, 1), 0, 1)
    shade = 0.02 + 0.8 * lit + 0.5 * lit**24
    wall = 0.3 + 0.3 * x + 0.2 * y
    shadow = np.exp(-(((x - 0.36) / 0.62) ** 2 + ((y - 0.83) / 0.12) ** 2) * 1.6)
    ground = np.where(y > 0.5, 0.92, wall) - 0.9 * shadow * (y > 0.5)
    stalk = np.abs(x - 0.02 + 0.28 * (y + 0.66)) < 0.035
    picture = np.where(there, shade, ground)
    picture[stalk & (y > -0.98) & (y < -0.6) & ~there] = 1
    return np.clip(picture, 0, 1)


def _field(x: np.ndarray, y: np.ndarray, z: np.ndarray | float) -> np.ndarray:
    """Two balls that flow into each other: the surface is where this is 1."""
    below = x**2 + (y - 0.38) ** 2 + z**2
    above = (x - 0.02) ** 2 + (y + 0.34) ** 2 + z**2
    return 0.235 / below + 0.062 / above


def main() -> None:
    """Make the two tilings, paint and save."""
    limits = dict.fromkeys(("H0", "V0", "H1", "V1"), LONGEST)
    start = tw.start_from_image(pear(), WIDTH, HEIGHT, dither=True, limits=limits)
    tiling = tw.dapple(start, limits)
    print((tiling != start).sum(), "of", start.size, "cells changed")
    picture = tw.paint_cells(tiling, colors=[INK, PAPER], size=6)

    random = tw.dapple(tw.random_start(20, 13, seed=4), {"H0": 2, "V1": 2})
    panels = [tw.paint_cells(random, motif=motif, size=24) for motif in ("fill", "strokes", "arcs")]
    gap = np.full((GAP, panels[0].shape[1], 3), 255, np.uint8)
    right = np.concatenate([panels[0], gap, panels[1], gap, panels[2]])
    sheet = np.concatenate([picture, np.full((len(picture), GAP, 3), 255, np.uint8), right], axis=1)
    Image.fromarray(sheet).quantize(64).save(TARGET, optimize=True)
    print(TARGET)


if __name__ == "__main__":
    main()
