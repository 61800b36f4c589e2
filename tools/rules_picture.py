"""Make docs/images/rules.jpg: a wall, a dappled tiling, a crowd and an aperiodic tiling, side by side."""

from pathlib import Path

import numpy as np
from PIL import Image

import tilewright as tw

TARGET = Path(__file__).parents[1] / "docs" / "images" / "rules.jpg"
WIDTH, HEIGHT, GAP = 400, 300, 12


def wall() -> np.ndarray:
    """Bricks in the sun."""
    return tw.BrickField(tw.endless_brick_tiling(3, seed=3), tw.BrickStyle("red"), size=(96, 32)).render(
        0, 0, WIDTH, HEIGHT
    )


def arcs() -> np.ndarray:
    """A dappled tiling as quarter circles."""
    tiling = tw.dapple(tw.random_start(20, 15, seed=4), {"H0": 2, "V1": 2})
    return tw.paint_cells(tiling, motif="arcs", size=20)


def crowd() -> np.ndarray:
    """Particles on a dappled tiling."""
    limits = dict.fromkeys(("H0", "V0", "H1", "V1"), 3)
    cells = tw.dapple(tw.random_start(20, 15, seed=2), limits, cyclic=True)
    tiles = (tw.FlowTile("-", speed=0.125), tw.FlowTile("|", speed=0.125))
    return tw.draw_trails(tw.simulate_flow(cells, tiles, particles=90, steps=120, seed=1), size=20)


def aperiodic() -> np.ndarray:
    """Jeandel and Rao's tiles, far away."""
    tiling = tw.aperiodic_tiling(tw.aperiodic_tiles("jeandel-rao-11-5"), seed=1)
    return tw.paint_tiling(tiling, 10**12, 10**12, 20, 15, size=20)


def main() -> None:
    """Paint and save."""
    gap = np.full((HEIGHT, GAP, 3), 255, np.uint8)
    sheet = np.concatenate([wall(), gap, arcs(), gap, crowd(), gap, aperiodic()], axis=1)
    Image.fromarray(sheet).save(TARGET, quality=82)
    print(TARGET)


if __name__ == "__main__":
    main()
