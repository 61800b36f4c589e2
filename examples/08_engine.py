"""An engine: tiles with their mip levels, the shader and a scene, as a folder that Godot opens.

The same by commands, in the folder where this leaves the photograph; for ``godot`` stands any other target::

    tilewright texture photo.png -o tiles --tile-size 64 --seed 1
    tilewright export tiles --to godot -o godot --lattice-seed 7
"""

import argparse
from pathlib import Path

import skimage.data

import tilewright as tw


def main(out: Path) -> None:
    """Make the tiles, and write the folder."""
    out.mkdir(parents=True, exist_ok=True)
    tw.write_image(out / "photo.png", skimage.data.gravel()[..., None])

    material = tw.texture_tiles(out / "photo.png", tile_size=64, seed=1)
    tw.save(material, out / "tiles")
    tw.save_for_engine(material, out / "godot", "godot", seed=7)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--output", type=Path, default=Path("out/engine"), help="folder for what is made")
    main(parser.parse_args().output)
