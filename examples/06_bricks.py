"""Bricks: an endless wall without long joints and without crosses, lit from the north-west.

The same by a command::

    tilewright bricks -o wall.png --x 1000000 --width 8 --height 12 --colors sandstone --seed 5
"""

import argparse
from pathlib import Path

import tilewright as tw


def main(out: Path) -> None:
    """Draw 8 x 12 cells of the wall, a million cells to the east."""
    out.mkdir(parents=True, exist_ok=True)
    wall = tw.endless_brick_tiling(3, seed=5, longest=(3, 3))
    width, height = 144, 48
    field = tw.BrickField(wall, tw.BrickStyle("sandstone"), size=(width, height), seed=5)
    field.save(out / "wall.png", 1_000_000 * width, 0, 8 * width, 12 * height)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--output", type=Path, default=Path("out/bricks"), help="folder for what is made")
    main(parser.parse_args().output)
