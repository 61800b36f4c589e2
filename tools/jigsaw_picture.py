"""Make docs/images/jigsaw.svg: the packing of corner tiles over two colors as a puzzle."""

from pathlib import Path

import tilewright as tw

TARGET = Path(__file__).parents[1] / "docs" / "images" / "jigsaw.svg"


def main() -> None:
    """Draw and save."""
    puzzle = tw.random_packing(tw.corner_tiles(2), seed=1)
    tw.save_svg(TARGET, tw.draw_jigsaw(puzzle, piece=30, engrave="colors"))
    print(TARGET)


if __name__ == "__main__":
    main()
