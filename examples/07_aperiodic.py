"""An aperiodic tiling: 24 corner tiles that tile the plane, and never with a period.

The same by a command::

    tilewright aperiodic jeandel-rao-24 -o never.svg --x 1000000 --width 40 --height 30 --seed 1
"""

import argparse
from pathlib import Path

import tilewright as tw


def main(out: Path) -> None:
    """Draw a window of a tiling, far to the east."""
    out.mkdir(parents=True, exist_ok=True)
    tiling = tw.aperiodic_tiling(tw.aperiodic_tiles("jeandel-rao-24"), seed=1)
    tw.save_svg(out / "never.svg", tw.draw_tiling(tiling, 1_000_000, 0, 40, 30))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--output", type=Path, default=Path("out/aperiodic"), help="folder for what is made")
    main(parser.parse_args().output)
