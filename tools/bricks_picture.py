"""Make docs/images/bricks.jpg: walls of brick Wang tiles, a bond to compare with, and the maps of a wall."""

from pathlib import Path

import numpy as np
from PIL import Image

import tilewright as tw

TARGET = Path(__file__).parents[1] / "docs" / "images" / "bricks.jpg"
WIDTH, HEIGHT, GAP = 600, 360, 8


def arch() -> np.ndarray:
    """Cells of a wall with a gate and two windows."""
    y, x = np.mgrid[:15, :15]
    gate = (np.abs(x - 7) < 3) & (y > 7) | (np.abs(x - 7) < 2) & (y > 6)
    windows = (np.abs(np.abs(x - 7) - 5) < 1) & (y > 4) & (y < 9)
    return ~(gate | windows) & (y > (x % 4 < 2) * 1)


def on_paper(pixels: np.ndarray) -> np.ndarray:
    """A picture with alpha on white."""
    share = pixels[..., 3:] / 255
    return (share * pixels[..., :3] + (1 - share) * 255).astype(np.uint8)


def maps(field: tw.BrickField) -> np.ndarray:
    """Strips of one window: light, color, height, normals, roughness, who is who."""
    strip = WIDTH // 6
    found = field.render_maps(30, 40, WIDTH, HEIGHT)
    gray = {name: np.repeat(found[name], 3, axis=2) for name in ("height", "roughness")}
    names = np.random.default_rng(2).integers(40, 256, (64, 64, 3))
    shown = (
        field.render(30, 40, WIDTH, HEIGHT),
        found["color"],
        gray["height"] >> 8,
        found["normal"],
        gray["roughness"],
        names[found["id"][..., 0] % 64, found["id"][..., 1] % 64],
    )
    parts = [map[:, k * strip : (k + 1) * strip] for k, map in enumerate(shown)]
    return np.concatenate(parts, axis=1).astype(np.uint8)


def main() -> None:
    """Draw and save."""
    endless = tw.BrickField(tw.endless_brick_tiling(3, seed=5), size=(120, 40))
    gate = tw.BrickField(tw.brick_region(arch(), 3, seed=2), tw.BrickStyle("sandstone"), size=(40, 24))
    herringbone = tw.BrickField(tw.BondBricks("herringbone", (96, 32)), tw.BrickStyle("yellow"))
    panels = (
        endless.render(10**9, 0, WIDTH, HEIGHT),
        on_paper(gate.render(0, 0, WIDTH, HEIGHT)),
        herringbone.render(0, 0, WIDTH, HEIGHT),
        maps(endless),
    )
    sheet = Image.new("RGB", (2 * WIDTH + GAP, 2 * HEIGHT + GAP), "white")
    for k, panel in enumerate(panels):
        sheet.paste(Image.fromarray(panel), (k % 2 * (WIDTH + GAP), k // 2 * (HEIGHT + GAP)))
    sheet.save(TARGET, quality=76, optimize=True)


if __name__ == "__main__":
    main()
