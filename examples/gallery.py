"""Pictures of photographs as tile sets, planes and comparisons: tiles, wide view, close view, five methods.

Without a folder of photographs it takes scikit-image's gravel (CC0) and two exemplars made by rule. Run it
from the root of the repository; ``--docs`` writes the small pictures that docs/gallery.md shows.
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
from PIL import Image

import tilewright as tw

SUFFIXES = (".png", ".jpg", ".jpeg", ".tif", ".tiff")
PICTURES = ("tiles", "wide", "close", "compare")
GAP = 4
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
    """What is free of rights: gravel, fine noise and bricks."""
    import skimage.data

    yield "gravel", skimage.data.gravel()
    yield "noise", make_noise()
    yield "bricks", make_bricks()


def make_noise(side: int = 512, seed: int = 1) -> Picture:
    """Sand-like noise: grains of two sizes in two colors."""
    from scipy.ndimage import gaussian_filter

    rng = np.random.default_rng(seed)
    fine, grains, tone = (
        gaussian_filter(rng.normal(size=(side, side)), s, mode="wrap") for s in (0.7, 1.6, 9)
    )
    light = sum(weight * layer / layer.std() for weight, layer in ((14, fine), (10, grains), (6, tone)))
    tint = 10 * tone / tone.std()
    channels = (168 + light, 146 + light - 0.3 * tint, 112 + light - tint)
    return np.clip(np.stack(channels, axis=2), 0, 255).astype(np.uint8)


def make_bricks(side: int = 512, seed: int = 2) -> Picture:
    """Running bond of 64 x 32 pixels with mortar, every brick of its own tone."""
    from scipy.ndimage import gaussian_filter

    rng = np.random.default_rng(seed)
    y, x = np.mgrid[:side, :side]
    course = y // 32
    shifted = x + 32 * (course % 2)
    tones = rng.normal(size=(side // 32, side // 64 + 1))[course, shifted // 64]
    mortar = np.minimum(np.minimum(shifted % 64, 63 - shifted % 64), np.minimum(y % 32, 31 - y % 32)) < 2
    rough = gaussian_filter(rng.normal(size=(side, side)), 1)
    rough *= 9 / rough.std()
    brick = np.array([150, 82, 62]) + (18 * tones + rough)[..., np.newaxis] * (1, 0.8, 0.7)
    color = np.where(mortar[..., np.newaxis], np.array([176, 170, 160]) + rough[..., np.newaxis], brick)
    return np.clip(color, 0, 255).astype(np.uint8)


def compare(photo: Picture) -> tw.SideBySide:
    """The photograph on 16 corner tiles, and by the other methods."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", tw.TilewrightWarning)
        material = tw.texture_tiles(photo, tw.corner_tiles(2), tile_size="auto", seed=1)
        return tw.compare_textures(material, seed=7)


def gallery_pictures(planes: tw.SideBySide) -> dict[str, Picture]:
    """Pictures for a screen."""
    return {
        "tiles": tile_sheet(planes),
        "wide": window(planes, "corner", 4096, 1024),
        "close": window(planes, "corner", 512, 1024),
        "compare": strip(planes, 320),
    }


def docs_pictures(planes: tw.SideBySide) -> dict[str, Picture]:
    """Pictures small enough to be kept."""
    return {"compare": strip(planes, 128)}


def tile_sheet(planes: tw.SideBySide) -> Picture:
    """The tiles with gaps, four in a row."""
    tiles = planes.material.pixels[..., :3]
    framed = np.pad(tiles, ((0, 0), (0, GAP), (0, GAP), (0, 0)), constant_values=255)
    rows = [np.concatenate(list(framed[k : k + 4]), axis=1) for k in range(0, len(framed), 4)]
    return as_rgb(np.concatenate(rows))


def strip(planes: tw.SideBySide, side: int) -> Picture:
    """The five methods: above, three photographs' widths from afar; below, a part at full size."""
    far = 3 * max(planes.photo.shape[:2])
    panes = [
        np.concatenate(
            [
                window(planes, name, far, side),
                np.full((GAP, side, 3), 255, np.uint8),
                window(planes, name, side, side),
            ]
        )
        for name in planes.contenders
    ]
    gap = np.full((2 * side + GAP, GAP, 3), 255, np.uint8)
    return np.concatenate([part for pane in panes for part in (gap, pane)][1:], axis=1)


def window(planes: tw.SideBySide, method: str, extent: int, side: int) -> Picture:
    """A square of the plane of a method, reduced or enlarged to a size."""
    pixels = as_rgb(planes.contenders[method].field.render(0, 0, extent, extent))
    picture = Image.fromarray(pixels)
    filtering = Image.Resampling.BOX if extent % side == 0 else Image.Resampling.LANCZOS
    return np.asarray(picture.resize((side, side), filtering))


def as_rgb(pixels: Picture) -> Picture:
    """Three channels."""
    return np.ascontiguousarray(np.repeat(pixels, 3, axis=2) if pixels.shape[2] < 3 else pixels[..., :3])


if __name__ == "__main__":
    try:
        main()
    except tw.TilewrightError as error:
        sys.exit(f"gallery: {error}")
