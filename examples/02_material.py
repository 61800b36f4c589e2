"""A material: all maps of a stack are cut alike, each averaged as what it holds.

The same by commands, in the folder where this leaves the maps::

    tilewright texture maps -o material --normal gl --seed 1
    tilewright render material -o plane.png --map height --width 800 --height 600
"""

import argparse
from pathlib import Path

import tilewright as tw


def main(out: Path) -> None:
    """Draw a wall as a stack of maps, cut tiles from it, and show its heights."""
    out.mkdir(parents=True, exist_ok=True)
    wall = tw.BrickField(tw.endless_brick_tiling(3, seed=1), size=(32, 16))
    drawn = wall.render_maps(0, 0, 192, 192)
    (out / "maps").mkdir(exist_ok=True)
    for name in ("color", "height", "normal", "roughness"):
        tw.write_image(out / "maps" / f"wall_{name}.png", drawn[name])

    maps = tw.find_maps(out / "maps")
    material = tw.texture_tiles(maps, normal="gl", seed=1)
    tw.save(material, out / "material")

    plane = tw.TextureField(material, tw.direct(material.tiles))
    plane.save(out / "plane.png", width=800, height=600, map="height")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--output", type=Path, default=Path("out/material"), help="folder for what is made")
    main(parser.parse_args().output)
