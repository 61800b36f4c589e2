"""Points: blue noise without end from 256 tiles that come with the package.

The same by a command::

    tilewright points -o points.csv --x -1000 --y 0 --width 60 --height 40 --lattice-seed 7
"""

import argparse
from pathlib import Path

import tilewright as tw


def main(out: Path) -> None:
    """Write the points of a window that lies far to the west."""
    out.mkdir(parents=True, exist_ok=True)
    blue = tw.ready_tiles(colors=4, points=32, rho=0.75)
    field = tw.PointField(blue, tw.direct(blue.tiles, seed=7))
    tw.write_points(out / "points.csv", field.points(x=-1000, y=0, width=60, height=40))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--output", type=Path, default=Path("out/points"), help="folder for what is made")
    main(parser.parse_args().output)
