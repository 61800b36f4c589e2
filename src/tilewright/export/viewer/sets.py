"""A tile set and its tiling as the page's shader and scripts take them."""

import base64
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.signals.textures.tone import Tone
from tilewright.tiles import TileSet
from tilewright.tiles.variants import Variants
from tilewright.tilings import stochastic
from tilewright.tilings.algorithms import recognize

BAKED_CELLS = 256
"""Side of the patch of cells shown where the page cannot evaluate the tiling itself."""
_IN_SHADER = ("corners", "classed", "edges", "sums", "bits", "marked-edges", "marked-sums")
_TABLE_WIDTH = 1024


def describe_set(
    tiles: TileSet, variants: Variants, seed: int, maps: list[dict[str, Any]], tone: Tone | None = None
) -> dict[str, Any]:
    """All the page needs to lay the pictures of the maps, and tone over them."""
    tiling = describe_tiling(tiles, variants, seed)
    if tone is not None:
        tiling["tone"] = {"span": tone.span, "texel": tone.texel}
    return {
        "count": len(variants),
        "repeat": _repeatable(tiles),
        "tiling": tiling,
        "defines": _defines(tiling, tiles),
        "maps": maps,
    }


def is_baked(described: dict[str, Any]) -> bool:
    """Whether a described set is shown as a patch, with the seed it was written with."""
    return bool(described["tiling"]["algorithm"] == "baked")


def describe_tiling(tiles: TileSet, variants: Variants, seed: int) -> dict[str, Any]:
    """How the page finds tiles: an algorithm with its colors and, of incomplete sets, tiles by code.

    The algorithms are those of `tilewright.direct`; ``"baked"`` is a stored patch of cells, which hold rows.
    Where tiles have variants, a table has the first row of each tile and the threshold of each row.
    """
    described: dict[str, Any] = {}
    if len(variants) > len(tiles):
        values = np.concatenate([variants.starts, variants.thresholds])
        described["variants"] = _long_table(values, "<u4") | {"tiles": len(tiles)}
    known = recognize(tiles)
    algorithm = known.name if known else ""
    if algorithm not in _IN_SHADER:
        side = BAKED_CELLS
        tiling = stochastic(tiles, side, side, seed)
        cells = tiling.rows(0, 0, side, side, variants=variants)
        chance = str(int(tiling.chance.seed) % 2**64)
        return {
            "algorithm": "baked",
            "radices": [0] * 4,
            "cells": _table(cells),
            "chance": chance,
            **described,
        }
    colors = dict(zip(tiles.shape.slots, tiles.colors, strict=True))
    radices = [colors.get(slot, 1) for slot in ("N", "E")] + [0, colors.get("NW", 1)]
    described |= {"algorithm": algorithm, "radices": radices}
    if algorithm == "classed":
        described["classes"] = tiles.parameters
    if not tiles.is_complete:
        index = np.zeros(int(np.prod(tiles.colors)), np.int64)
        index[tiles.codes] = np.arange(len(tiles))
        described["indexOfCode"] = _long_table(index, "<u2")
    return described


def _defines(tiling: dict[str, Any], tiles: TileSet) -> str:
    """What the shader is compiled for."""
    algorithm = tiling["algorithm"]
    marked = algorithm.startswith("marked")
    cornered = algorithm in ("corners", "classed")
    lines = [f"#define ALGORITHM_{algorithm.upper().replace('-', '_')}"]
    lines += [f"#define {name.upper()} {n}u" for name, n in tiling.get("classes", {}).items()]
    lines += ["#define HAS_TONE"] if "tone" in tiling else []
    if algorithm != "baked":
        lines += ["#define COMPLETE"] if tiles.is_complete else []
        lines += ["#define HAS_EDGES"] if not cornered else []
        lines += ["#define HAS_CORNERS"] if marked or cornered else []
        lines += [f"#define CORNER_STREAM {'uMarks' if marked else 'uFirst'}"]
        lines += ["#define HAS_VARIANTS"] if "variants" in tiling else []
    return "\n".join(lines)


def _long_table(values: NDArray[Any], kind: str) -> dict[str, Any]:
    """A list of whole numbers for a texture, filled up with zeros."""
    return _table(np.pad(values, (0, -len(values) % _TABLE_WIDTH)).reshape(-1, _TABLE_WIDTH), kind)


def _table(rows: NDArray[Any], kind: str = "<u2") -> dict[str, Any]:
    """Whole numbers for a texture: rows of equal width."""
    return {
        "width": rows.shape[1],
        "height": rows.shape[0],
        "values": base64.b64encode(rows.astype(kind).tobytes()).decode(),
    }


def _repeatable(tiles: TileSet) -> int:
    """The first tile that matches itself on every side, or 0 where none does."""
    fits = np.ones(len(tiles), bool)
    for joint in tiles.shape.joints:
        for far, near in joint:
            fits &= tiles.slots[:, far] == tiles.slots[:, near]
    return int(np.argmax(fits))
