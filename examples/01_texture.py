"""A texture: one photograph becomes tiles, and these an endless plane.

The same by commands, in the folder where this leaves the photograph::

    tilewright texture photo.png -o tiles --tile-size 64 --seed 1
    tilewright render tiles -o plane.png --x -500 --width 1200 --height 800 --lattice-seed 7
"""

import argparse
from pathlib import Path

import skimage.data

import tilewright as tw


def main(out: Path) -> None:
    """Make the tiles, and a picture of a part of the plane."""
    out.mkdir(parents=True, exist_ok=True)
    tw.write_image(out / "photo.png", skimage.data.gravel()[..., None])

    material = tw.texture_tiles(out / "photo.png", tile_size=64, seed=1)
    tw.save(material, out / "tiles")

    plane = tw.TextureField(material, tw.direct(material.tiles, seed=7))
    plane.save(out / "plane.png", x=-500, y=0, width=1200, height=800)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--output", type=Path, default=Path("out/texture"), help="folder for what is made")
    main(parser.parse_args().output)
