"""Make docs/images/flow.png, trails and where particles gather, and docs/images/flow.gif."""

from pathlib import Path

import numpy as np
from PIL import Image

import tilewright as tw

FOLDER = Path(__file__).parents[1] / "docs" / "images"
GAP = 16


def limits(longest: int) -> dict[str, int]:
    """The same limit for both tiles, along x and along y."""
    return dict.fromkeys(("H0", "V0", "H1", "V1"), longest)


def crowd(width: int, height: int, **strewn: float) -> tw.Flow:
    """Particles at an eighth of a cell for each step, on a torus."""
    ways = tw.dapple(tw.random_start(width, height, seed=2), limits(3), cyclic=True)
    plain = (tw.FlowTile("-", 0.125), tw.FlowTile("|", 0.125))
    cells, tiles = tw.strew_tiles(ways, tiles=plain, seed=1, **strewn)
    return tw.simulate_flow(cells, tiles, particles=width * height // 5, steps=160, seed=1)


def walked(longest: int | None) -> tw.Flow:
    """20,000 particles on 44 x 44 cells for a long time."""
    start = tw.random_start(44, 44, seed=3)
    cells = tw.dapple(start, limits(longest), cyclic=True) if longest else start
    flow = tw.simulate_flow(cells, particles=20_000, steps=5000, every=5000, seed=1)
    visits = flow.visits()
    print(f"limit {longest}: variation {visits.std() / visits.mean():.2f}, never {(visits == 0).mean():.3f}")
    return flow


def main() -> None:
    """Simulate, draw, save."""
    trails = tw.draw_trails(
        crowd(30, 30, emitting=0.04, killing=0.04, slow=0.12, fast=0.12), size=24, trail=12
    )
    flows = [walked(2), walked(None)]
    most = float(np.quantile(flows[1].arms(), 0.995))
    maps = [tw.draw_density(flow, size=8, most=most) for flow in flows]
    gap = np.full((GAP, maps[0].shape[1], 3), 255, np.uint8)
    right = np.concatenate([maps[0], gap, maps[1]])
    sheet = np.concatenate([trails, np.full((len(trails), GAP, 3), 255, np.uint8), right], axis=1)
    Image.fromarray(sheet).quantize(256, dither=Image.Dither.NONE).save(FOLDER / "flow.png", optimize=True)
    tw.save_animation(FOLDER / "flow.gif", crowd(24, 15), size=16)
    print(FOLDER / "flow.png", FOLDER / "flow.gif")


if __name__ == "__main__":
    main()
