"""Assemble the viewer page from its parts and a material.

The parts lie beside this file: ``template.html`` and ``style.css``; ``plane.frag``, ``lattice.glsl`` and
``mip.frag``, the shaders; ``lattice.js``, ``camera.js``, ``renderer.js``, ``controls.js`` and ``main.js``.
"""

import base64
import html
import io
import json
import re
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright import __version__
from tilewright.errors import TilewrightValueError, check_int
from tilewright.export.display import is_light, screen_bytes, to_linear
from tilewright.files.whole import as_path, whole_file
from tilewright.signals.textures import TextureTiles
from tilewright.tiles import TileSet
from tilewright.tilings import stochastic
from tilewright.tilings.direct import recognize

BAKED_CELLS = 256
"""Side of the patch of cells shown where the page cannot evaluate the tiling itself."""
_IN_SHADER = ("corners", "edges", "sums", "bits", "marked-edges", "marked-sums")
_SCRIPTS = ("lattice.js", "camera.js", "renderer.js", "controls.js", "main.js")
_TABLE_WIDTH = 1024


def save_viewer(material: TextureTiles, path: str | Path, *, seed: int = 0) -> None:
    """Write a page that shows an endless texture: pan, zoom, tilt, and compare with plain repetition.

    One HTML file with the tiles inside; it needs a browser with WebGL 2 and no network. At one texel per
    pixel it shows the pixels of `TextureField` over ``direct(material.tiles, seed)``.

    Parameters
    ----------
    material : TextureTiles
        Tiles of any set. With complete sets, `summed_wang_tiles`, `shifted_wang_tiles` and their
        corner-coded forms the plane is endless; with others the page shows a patch of 256 x 256 cells from
        (0, 0) on, laid by `direct` where it can and by `scanline` where not, and the seed cannot be changed.
    path : str or Path
        The ``.html`` file; its name is the page's title.
    seed : int
        The seed of the tiling that the page starts with, 0 to 2^64 - 1.

    Raises
    ------
    TilewrightValueError
        Another suffix than ``.html``, a seed out of range, or a set that leads into a dead end.
    TilewrightFileError
        The file cannot be written.

    Notes
    -----
    16-bit maps are rounded to 8 bit for the screen; float maps are scaled, and light encoded as sRGB (the
    page says from what to what). Mip levels of light are averaged linearly.
    """
    path = as_path(path)
    if path.suffix.lower() not in (".html", ".htm"):
        raise TilewrightValueError(f"{path} ends in {path.suffix or 'nothing'!r}; a viewer is an .html file")
    check_int("seed", seed, 0, 2**64 - 1)
    page = _assemble(material, seed, path.stem)
    with whole_file(path) as unfinished:
        unfinished.write_text(page, encoding="utf-8")


def _assemble(material: TextureTiles, seed: int, title: str) -> str:
    tiling = describe_tiling(material.tiles, seed)
    baked = tiling["algorithm"] == "baked"
    data = {
        "count": len(material.tiles),
        "tileSize": material.tile_size,
        "seed": str(seed),
        "repeat": _repeatable(material.tiles),
        "tiling": tiling,
        "maps": [_describe_map(name, pixels) for name, pixels in material.maps.items()],
    }
    shape, colors = material.tiles.shape.name, max(material.tiles.colors)
    subtitle = f"{len(material.tiles)} {shape} tiles, {colors} colors, {material.tile_size} px"
    if baked:
        subtitle += f"; a patch of {BAKED_CELLS} x {BAKED_CELLS} cells"
    return _fill(
        "template.html",
        version=__version__,
        title=html.escape(title),
        subtitle=subtitle,
        style=_part("style.css"),
        seed_disabled="disabled" if baked else "",
        map_hidden="hidden" if len(material.maps) == 1 else "",
        map_options="".join(f"<option>{html.escape(name)}</option>" for name in material.maps),
        material=json.dumps(data, separators=(",", ":")).replace("<", "\\u003c"),
        plane=_fill("plane.frag", defines=_defines(tiling, material.tiles), lattice=_part("lattice.glsl")),
        mip=_part("mip.frag"),
        script="\n".join(_part(name) for name in _SCRIPTS),
    )


def _part(name: str) -> str:
    return (files(__package__) / name).read_text(encoding="utf-8").strip()


def _fill(part: str, **values: str) -> str:
    """A part with each ``{{name}}`` (in shaders after ``//``) replaced, in one pass."""
    return re.sub(r"(?:// )?\{\{(\w+)\}\}", lambda match: values[match[1]], _part(part))


def _defines(tiling: dict[str, Any], tiles: TileSet) -> str:
    """What the shader is compiled for."""
    algorithm = tiling["algorithm"]
    marked = algorithm.startswith("marked")
    lines = [f"#define ALGORITHM_{algorithm.upper().replace('-', '_')}"]
    if algorithm != "baked":
        lines += ["#define COMPLETE"] if tiles.is_complete else []
        lines += ["#define HAS_EDGES"] if algorithm != "corners" else []
        lines += ["#define HAS_CORNERS"] if marked or algorithm == "corners" else []
        lines += [f"#define CORNER_STREAM {'uMarks' if marked else 'uFirst'}"]
    return "\n".join(lines)


def describe_tiling(tiles: TileSet, seed: int) -> dict[str, Any]:
    """How the page finds tiles: an algorithm with its colors and, of incomplete sets, tiles by code.

    The algorithms are those of `tilewright.direct`; ``"baked"`` is a stored patch of cells.
    """
    algorithm = recognize(tiles)
    if algorithm not in _IN_SHADER:
        side = BAKED_CELLS
        cells = stochastic(tiles, side, side, seed).indices(0, 0, side, side)
        return {"algorithm": "baked", "radices": [0] * 4, "cells": _table(cells)}
    colors = dict(zip(tiles.shape.slots, tiles.colors, strict=True))
    radices = [colors.get(slot, 1) for slot in ("N", "E")] + [0, colors.get("NW", 1)]
    described: dict[str, Any] = {"algorithm": algorithm, "radices": radices}
    if not tiles.is_complete:
        index = np.zeros(int(np.prod(tiles.colors)), np.int64)
        index[tiles.codes] = np.arange(len(tiles))
        described["indexOfCode"] = _table(np.pad(index, (0, -len(index) % _TABLE_WIDTH))[np.newaxis])
    return described


def _table(values: NDArray[Any]) -> dict[str, Any]:
    """Small whole numbers for a texture: rows of equal width."""
    rows = values if values.shape[0] > 1 else values.reshape(-1, min(values.size, _TABLE_WIDTH))
    return {
        "width": rows.shape[1],
        "height": rows.shape[0],
        "values": base64.b64encode(rows.astype("<u2").tobytes()).decode(),
    }


def _repeatable(tiles: TileSet) -> int:
    """The first tile that matches itself on every side, or 0 where none does."""
    fits = np.ones(len(tiles), bool)
    for joint in tiles.shape.joints:
        for far, near in joint:
            fits &= tiles.slots[:, far] == tiles.slots[:, near]
    return int(np.argmax(fits))


def _describe_map(name: str, pixels: NDArray[Any]) -> dict[str, Any]:
    light = is_light(name)
    shown, note = screen_bytes(pixels, light)
    return {
        "name": name,
        "light": light,
        "note": note,
        "mean": [round(float(v), 6) for v in _mean(shown, light)],
        "tiles": [base64.b64encode(_png(tile)).decode() for tile in shown],
    }


def _mean(shown: NDArray[np.uint8], light: bool) -> NDArray[np.float64]:
    """Mean of all tiles as the shader adds them up: linear where light, color multiplied by alpha."""
    values = np.arange(256) / 255
    table = to_linear(values) if light else values
    channels = shown.shape[-1]
    if channels in (1, 3):
        color = np.array([table[shown[..., c]].mean() for c in range(channels)])
        return np.append(np.resize(color, 3), 1.0)
    alpha = values[shown[..., -1]]
    color = np.array([(table[shown[..., c]] * alpha).mean() for c in range(channels - 1)])
    return np.append(np.resize(color, 3), alpha.mean())


def _png(pixels: NDArray[np.uint8]) -> bytes:
    from PIL import Image

    stream = io.BytesIO()
    Image.fromarray(pixels.squeeze(-1) if pixels.shape[-1] == 1 else pixels).save(
        stream, "PNG", compress_level=9
    )
    return stream.getvalue()
