"""Assemble the viewer page from its parts and a material.

The parts lie beside this file: ``template.html`` and ``style.css``; the shaders ``plane.frag``, to which
``lattice.glsl`` and ``tiles.glsl`` are added, and ``mip.frag``; the scripts from ``lattice.js`` to
``main.js``. ``compared.py`` adds what only a comparison has.
"""

import html
import json
from pathlib import Path
from typing import Any

from tilewright import __version__
from tilewright.checks import check_type
from tilewright.errors import TilewrightValueError
from tilewright.export.display import screen_bytes
from tilewright.export.viewer.compared import describe_comparison, fill_comparison
from tilewright.export.viewer.parts import fill, part, shader
from tilewright.export.viewer.patches import describe_patches
from tilewright.export.viewer.pictures import describe_map, describe_tone
from tilewright.export.viewer.sets import BAKED_CELLS, describe_set, is_baked
from tilewright.fields.photos.contenders import SideBySide
from tilewright.files.atomic import AnyPath, as_path, check_file, whole_file
from tilewright.files.texts import write_text
from tilewright.seeds import check_seed
from tilewright.signals.textures import TextureTiles

_SCRIPTS = (
    "lattice.js",
    "camera.js",
    "patches.js",
    "renderer.js",
    "photo.js",
    "controls.js",
    "comparison.js",
    "main.js",
)
_SHADERS = ("plane.frag", "mip.frag", "lattice.glsl", "tiles.glsl")


def save_viewer(
    material: TextureTiles, path: AnyPath, *, seed: int = 0, compare: SideBySide | None = None
) -> None:
    """Write a page that shows an endless texture: pan, zoom, tilt, and compare with other methods.

    One HTML file with the tiles inside; it needs a browser with WebGL 2 and no network. At one texel per
    pixel it shows the pixels of `TextureField` over ``direct(material.tiles, seed)``.

    Parameters
    ----------
    material : TextureTiles
        Tiles of any set. With complete sets, `summed_wang_tiles`, `shifted_wang_tiles` and their
        corner-coded forms the plane is endless; with others the page shows a patch of 256 x 256 cells from
        (0, 0) on, laid by `direct` where it can and by `scanline` where not, and the seed cannot be changed.
    path : str or path-like
        The ``.html`` file; its name is the page's title.
    seed : int, optional
        The seed of the tiling that the page starts with, 0 to 2^64 - 1; default 0.
    compare : SideBySide, optional
        The material by five methods, from `compare_textures` or, without figures, `side_by_side`: the page
        then shows plain repeat, hex-tiling, by-example noise, Wang tiles and corner tiles under one camera,
        one at a time or two with a divider between them. It holds the photograph and both tile sets, of the
        main map only and without alpha. By default only the material is shown.

    Raises
    ------
    TilewrightTypeError
        An argument of another type.
    TilewrightValueError
        Another suffix than ``.html``, a seed out of range, a set that leads into a dead end, or a comparison
        of another material.
    TilewrightFileError
        The file cannot be written.

    Notes
    -----
    16-bit maps are rounded to 8 bit for the screen; float maps are scaled, and light encoded as sRGB (the
    page says from what to what). Mip levels of light are averaged linearly.

    Examples
    --------
    >>> import os
    >>> import tempfile
    >>> import numpy as np
    >>> import tilewright as tw
    >>> photo = np.random.default_rng(1).integers(0, 256, (64, 64, 3), np.uint8)
    >>> material = tw.texture_tiles(photo, tw.corner_tiles(2), tile_size=16)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tw.save_viewer(material, f"{folder}/noise.html", seed=7)
    ...     print(os.listdir(folder))
    ['noise.html']
    """
    path = check_page(path)
    check_type("material", material, TextureTiles, "TextureTiles")
    seed = check_seed(seed)
    if compare is not None:
        _check_comparison(compare, material)
    page = _assemble(material, seed, path.stem, compare)
    with whole_file(path) as unfinished:
        write_text(unfinished, page)


def check_page(path: AnyPath) -> Path:
    """Where a page can be written; an error where not, before the work is done."""
    path = as_path(path)
    if path.suffix.lower() not in (".html", ".htm"):
        raise TilewrightValueError(
            f"{path} ends in {path.suffix or 'nothing'!r}; a viewer is an .html file", value=path
        )
    check_file(path)
    return path


def _check_comparison(compare: Any, material: TextureTiles) -> None:
    check_type("compare", compare, SideBySide, "what compare_textures() returns")
    if compare.material is not material:
        raise TilewrightValueError(
            "is about another material",
            argument="compare",
            advice="give compare_textures() of the one that is shown",
        )


def _assemble(material: TextureTiles, seed: int, title: str, compare: SideBySide | None) -> str:
    data: dict[str, Any] = {"seed": str(seed), "tileSize": material.tile_size}
    data |= _describe(material, seed) if compare is None else describe_comparison(compare, seed)
    sets = [plane["tiles"] for plane in data["planes"] if "tiles" in plane]
    maps = [found["name"] for found in data["maps"]]
    baked = any(is_baked(tiles) for tiles in sets)
    shape, colors = material.tiles.shape.name, max(material.tiles.colors)
    subtitle = f"{len(material.tiles)} {shape} tiles, {colors} colors, {material.tile_size} px"
    if len(material.variants) > len(material.tiles):
        subtitle += f", {len(material.variants)} pictures"
    if baked:
        subtitle += f"; a patch of {BAKED_CELLS} x {BAKED_CELLS} cells"
    shaders = _SHADERS if compare is None else (*_SHADERS, "photo.glsl")
    return fill(
        "template.html",
        version=__version__,
        title=html.escape(title),
        subtitle=subtitle,
        style=part("style.css"),
        seed_disabled="disabled" if baked else "",
        map_hidden="hidden" if len(maps) == 1 else "",
        map_options="".join(f"<option>{html.escape(name)}</option>" for name in maps),
        repeat_hidden="" if compare is None else "hidden",
        material=json.dumps(data, separators=(",", ":")).replace("<", "\\u003c"),
        shaders="\n".join(_shader(name) for name in shaders),
        script="\n".join(part(name) for name in _SCRIPTS),
        **fill_comparison(compare),
    )


def _shader(name: str) -> str:
    return f'<script type="x-shader/x-fragment" id="{name}">\n{shader(name)}\n</script>'


def _describe(material: TextureTiles, seed: int) -> dict[str, Any]:
    """One plane: all maps of the material's own tiles."""
    maps, notes = [], []
    for name, pixels in material.maps.items():
        light = material.kinds[name] == "color"
        if material.kinds[name] == "roughness" and pixels.dtype.kind == "f":
            pixels = pixels.clip(0, 1)  # dark specks are below 0 until tone is laid
        texels = None if material.tone is None else material.tone.maps.get(name)
        room = (0.0, 0.0) if texels is None else (float(texels.min()), float(texels.max()))
        shown = screen_bytes(pixels, light, room=room)
        tone = describe_tone(material, name, shown.span)
        maps.append(describe_map(name, shown.pixels, light, tone))
        notes.append({"name": name, "note": shown.note})
    tiles = describe_set(material.tiles, material.variants, seed, maps, material.tone)
    tiles["patches"] = describe_patches(material)
    return {"maps": notes, "planes": [{"name": "tiles", "label": "Tiles", "own": True, "tiles": tiles}]}
