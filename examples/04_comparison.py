"""A comparison: radius, spectrum and zone plate of methods for points, side by side.

The same by a command::

    tilewright compare -o comparison --methods "uniform,jittered" --sets 1 --seed 1
"""

import argparse
from pathlib import Path

import tilewright as tw


def main(out: Path) -> None:
    """Measure two methods, and write figures and pictures."""
    out.mkdir(parents=True, exist_ok=True)
    found = tw.compare(["uniform", "jittered"], sets=1, seed=1)
    found.save(out / "comparison")
    print(found.table())


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--output", type=Path, default=Path("out/comparison"), help="folder for what is made")
    main(parser.parse_args().output)
