"""From one photograph to an endless texture: tile set, picture, viewer page; and a million points.

Without a photograph, scikit-image's gravel is taken (CC0).
"""

import argparse
import sys
import time
from pathlib import Path

import tilewright as tw


def main() -> None:
    """Run the main job and say what was made and how long each step took."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("photo", nargs="?", help="a photograph")
    parser.add_argument("--output", default="out", help="folder for the results")
    given = parser.parse_args()
    out = Path(given.output)
    out.mkdir(parents=True, exist_ok=True)

    with step("photograph"):
        if given.photo:
            photo = tw.read_image(given.photo)
        else:
            import skimage.data

            photo = skimage.data.gravel()
    with step("tile set", out / "tiles"):
        material = tw.texture_tiles(photo, seed=1)
        tw.save(material, out / "tiles")
    print(f"          {describe(material)}")
    with step("picture: 4096 x 4096 pixels of the endless plane", out / "plane.png"):
        field = tw.TextureField(material, tw.direct(material.tiles, seed=7))
        field.save(out / "plane.png", width=4096, height=4096)
    with step("page to pan, zoom and tilt", out / "viewer.html"):
        tw.save_viewer(material, out / "viewer.html", seed=7)
    with step("blue noise: exactly 1,000,000 points", out / "points.npy"):
        blue = tw.ready_tiles()
        points = tw.PointField(blue, tw.direct(blue.tiles, seed=7))
        tw.write_points(out / "points.npy", points.sample(1_000_000))
    print(f"\nOpen {out / 'viewer.html'} in a browser.")


def describe(material: tw.TextureTiles) -> str:
    """What the photograph asked for."""
    asked = {
        "courses": "their rows or columns keep step with the photograph's",
        "things": "large enough for its things",
        "even": "its tone is laid outside them" if material.tone else "of even tone",
    }
    size = material.tile_size
    return (
        f"{len(material.tiles)} corner tiles of {size} x {size} pixels: {asked[material.recipe['treatment']]}"
    )


class step:
    """Times a step and prints it with what it made."""

    def __init__(self, what: str, made: Path | None = None) -> None:
        self.what, self.made = what, made

    def __enter__(self) -> None:
        self.started = time.perf_counter()

    def __exit__(self, failed: object, *rest: object) -> None:
        if failed is None:
            seconds = time.perf_counter() - self.started
            print(f"{seconds:6.1f} s  {self.what}" + (f": {self.made}" if self.made else ""), flush=True)


if __name__ == "__main__":
    try:
        main()
    except tw.TilewrightError as error:
        sys.exit(f"demo: {error}")
