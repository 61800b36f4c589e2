"""Pictures of photographs as tile sets and planes: tiles, wide and close view, methods near and from afar.

Without a folder of photographs it takes scikit-image's gravel (CC0) and Hubble's deep field (NASA), and two
walls of its own bricks. Run it from the root of the repository; ``--docs`` writes the small pictures that
docs/gallery.md shows.
"""

import argparse
import html
import json
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

import tilewright as tw

SUFFIXES = (".png", ".jpg", ".jpeg", ".tif", ".tiff")
PICTURES = ("tiles", "wide", "close", "near", "far")
GAP = 4
FAR = 8
"""Pixels of the plane along one of the picture, from afar."""
Picture = NDArray[np.uint8]


def main() -> None:
    """Make all pictures, and ``figures.json``."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--photos", help="a folder of photographs; all 8-bit pictures in it are taken")
    parser.add_argument("--output", default="out/gallery", help="folder for the pictures")
    parser.add_argument("--docs", action="store_true", help="write docs/images/gallery-*.jpg instead")
    given = parser.parse_args()
    out = Path("docs/images" if given.docs else given.output)
    out.mkdir(parents=True, exist_ok=True)
    figures = {}
    for name, photo in photographs(Path(given.photos)) if given.photos else exemplars():
        planes = compare(photo)
        figures[name] = planes.figures
        pictures = docs_pictures(planes) if given.docs else gallery_pictures(planes)
        for what, picture in pictures.items():
            path = out / (f"gallery-{name}-{what}.jpg" if given.docs else f"{name}-{what}.jpg")
            Image.fromarray(picture).save(path, quality=70 if given.docs else 90)
            print(path, flush=True)
        if not given.docs:
            tw.save_viewer(planes.material, out / f"{name}.html", compare=planes)
    print(json.dumps(figures, indent=1))
    if not given.docs:
        (out / "figures.json").write_text(json.dumps(figures, indent=1))
        (out / "index.html").write_text(index_page(figures), encoding="utf-8")


def index_page(figures: dict[str, dict[str, dict[str, float]]]) -> str:
    """A page of all pictures; the methods stand in the order of the strips."""
    parts = []
    for name, methods in figures.items():
        said = " · ".join(f"{method} {found['repetition']:.2f}" for method, found in methods.items())
        parts.append(
            f"<h2>{html.escape(name)}</h2><p>Repetition: {said}. <a href='{name}.html'>Side by side</a></p>"
        )
        parts += [f"<a href='{name}-{what}.jpg'><img src='{name}-{what}.jpg'></a>" for what in PICTURES]
    style = "body{font:1rem sans-serif;margin:2rem}img{max-width:47%;max-height:26rem;margin:.3rem}"
    return f"<!doctype html><meta charset=utf-8><title>Gallery</title><style>{style}</style>{''.join(parts)}"


def photographs(folder: Path) -> Iterator[tuple[str, Picture]]:
    """All 8-bit pictures of a folder by name."""
    found = sorted(path for path in folder.iterdir() if path.suffix.lower() in SUFFIXES)
    if not found:
        sys.exit(f"gallery: {folder} holds no pictures ({', '.join(SUFFIXES)})")
    for path in found:
        pixels = tw.read_image(path)
        if pixels.dtype == np.uint8:
            yield path.stem, pixels


def exemplars() -> Iterator[tuple[str, Picture]]:
    """What is free of rights: gravel, galaxies, and walls of our own."""
    import skimage.data

    yield "gravel", skimage.data.gravel()
    yield "galaxies", skimage.data.hubble_deep_field()
    yield "herringbone", wall("herringbone", (96, 24))
    yield "bricks", wall("running-bond", (64, 32))


def wall(bond: str, size: tuple[int, int]) -> Picture:
    """Bricks of a size in a bond."""
    return tw.BrickField(tw.BondBricks(bond, size), seed=2).render(0, 0, 512, 512)


def synthesized(photo: Picture, tiles: tw.TileSet | None = None) -> tw.TextureTiles:
    """A photograph on a tile set, the default where none is given."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", tw.TilewrightWarning)
        return tw.texture_tiles(photo, tiles, tile_size="auto" if tiles else None, seed=1)


def compare(photo: Picture) -> tw.SideBySide:
    """The photograph on the tiles that it gets by default, and by the other methods."""
    return tw.compare_textures(synthesized(photo), seed=7)


def gallery_pictures(planes: tw.SideBySide) -> dict[str, Picture]:
    """Pictures for a screen."""
    return {
        "tiles": tile_sheet(planes),
        "wide": window(planes.contenders["corner"].field, 4096, 1024),
        "close": window(planes.contenders["corner"].field, 512, 1024),
    } | methods(planes, 512)


def docs_pictures(planes: tw.SideBySide) -> dict[str, Picture]:
    """Pictures small enough to be kept."""
    return methods(planes, 320)


def tile_sheet(planes: tw.SideBySide) -> Picture:
    """The tiles with gaps, four in a row."""
    tiles = planes.material.pixels[..., :3]
    framed = np.pad(tiles, ((0, 0), (0, GAP), (0, GAP), (0, 0)), constant_values=255)
    rows = [np.concatenate(list(framed[k : k + 4]), axis=1) for k in range(0, len(framed), 4)]
    return as_rgb(np.concatenate(rows))


def methods(planes: tw.SideBySide, side: int) -> dict[str, Picture]:
    """All methods in two pictures: a part at full size, and from afar, where pixels are means of 8 x 8."""
    fields = {one.label: one.field for one in planes.contenders.values()}
    *others, ours = fields
    old = synthesized(planes.photo, tw.corner_tiles(2))
    named = {label: fields[label] for label in others}
    named["16 corner tiles, method nested"] = tw.TextureField(old, tw.direct(old.tiles, seed=7))
    named[f"{len(planes.material.tiles)} corner tiles, the default"] = fields[ours]
    return {
        name: labeled({label: window(field, step * side, side) for label, field in named.items()})
        for name, step in (("near", 1), ("far", FAR))
    }


def labeled(panels: dict[str, Picture]) -> Picture:
    """Panels three in a row, each under its name."""
    side = len(next(iter(panels.values())))
    line = max(18, side // 20)
    rows = -(-len(panels) // 3)
    sheet = Image.new("RGB", (3 * side + 2 * GAP, rows * (side + line + GAP)), "white")
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(line * 0.7)
    for number, (label, panel) in enumerate(panels.items()):
        x, y = number % 3 * (side + GAP), number // 3 * (side + line + GAP)
        draw.text((x, y + line * 0.1), label, "black", font)
        sheet.paste(Image.fromarray(panel), (x, y + line))
    return np.asarray(sheet)


def window(field: tw.PixelField, extent: int, side: int) -> Picture:
    """A square of a plane, reduced or enlarged to a size."""
    pixels = as_rgb(field.render(1000, 700, extent, extent))
    filtering = Image.Resampling.BOX if extent % side == 0 else Image.Resampling.LANCZOS
    return np.asarray(Image.fromarray(pixels).resize((side, side), filtering))


def as_rgb(pixels: Picture) -> Picture:
    """Three channels."""
    return np.ascontiguousarray(np.repeat(pixels, 3, axis=2) if pixels.shape[2] < 3 else pixels[..., :3])


if __name__ == "__main__":
    try:
        main()
    except tw.TilewrightError as error:
        sys.exit(f"gallery: {error}")
