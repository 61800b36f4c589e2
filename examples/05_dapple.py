"""A dappled tiling: two tiles at random, of which neither has long runs, drawn as quarter circles.

The same by a command::

    tilewright dapple -o arcs.svg --width 40 --height 25 --limit H0=2 --limit V1=2 --motif arcs --seed 4
"""

import argparse
from pathlib import Path

import tilewright as tw


def main(out: Path) -> None:
    """Begin at random, mend what breaks the limits, draw."""
    out.mkdir(parents=True, exist_ok=True)
    start = tw.random_start(40, 25, seed=4)
    cells = tw.dapple(start, {"H0": 2, "V1": 2}, seed=4)
    tw.save_svg(out / "arcs.svg", tw.draw_cells(cells, motif="arcs"))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--output", type=Path, default=Path("out/dapple"), help="folder for what is made")
    main(parser.parse_args().output)
