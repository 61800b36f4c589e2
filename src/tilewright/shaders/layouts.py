"""How texture tiles lie in textures, and what a shader must be told to read them there."""

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice
from tilewright.errors import TilewrightValueError
from tilewright.shaders.mipmaps import Mipmaps, atlas_mipmaps, layer_mipmaps, tone_mean
from tilewright.signals.textures import TextureTiles
from tilewright.signals.textures.frame import shared_border
from tilewright.tiles import CORNER, WANG, TileSet, corner_tiles
from tilewright.tiles.classes import are_by_class
from tilewright.tiles.variants import MOST_SHADED, name_variants
from tilewright.tilings import packing
from tilewright.tilings.packings.closed_form import train

LAYOUTS = ("array", "atlas")
_MOST_LAYERS = 256
"""Layers that every GPU has; sets with more tiles go into an atlas unless told otherwise."""
WEI_PARTS = ("train.glsl", "wei.glsl")


@dataclass(frozen=True, eq=False)
class Layout:
    """Textures of a material, and how they are read.

    Attributes
    ----------
    parts : tuple of str
        Shader files, without the hash.
    defines : dict of str to str
    textures : tuple of Mipmaps
        In the order of their bindings, from 3 on.
    density : int
        Lattice points of the hash along a tile.
    places : uint32 array
        Column of each tile in the packing, and 2^16 times its row, where the shader looks it up.
    """

    name: str
    parts: tuple[str, ...]
    defines: dict[str, str]
    textures: tuple[Mipmaps, ...]
    density: int = 1
    places: NDArray[np.uint32] = field(default_factory=lambda: np.empty(0, np.uint32))

    @property
    def layered(self) -> bool:
        """Whether tiles are layers."""
        return self.name == "array"

    @property
    def address(self) -> str:
        """What coordinates outside the texture mean."""
        return "clamp-to-edge" if self.layered else "repeat"


def check_set(tiles: TileSet) -> None:
    """Raise unless shaders can lay a set."""
    if tiles.family not in ("corner", "wang") and not (tiles.family == "classed" and are_by_class(tiles)):
        raise TilewrightValueError(
            "on a GPU there are complete and classed sets of corner tiles, and complete Wang sets, not the "
            f"{tiles.name} set of {len(tiles)} {tiles.shape.name} tiles",
            advice="make the texture over corner_tiles()",
        )


def make_layout(material: TextureTiles, layout: str | None, map: str | None) -> Layout:
    """The textures of a map in a layout, by default a good one for the set."""
    tiles = material.tiles
    if layout is None:
        layout = "array" if tiles.shape is CORNER and len(material.variants) <= _MOST_LAYERS else "atlas"
    check_choice("layout", layout, LAYOUTS)
    if tiles.shape is WANG:
        if layout == "array":
            raise TilewrightValueError(
                "is 'array'; Wang tiles need 'atlas', as their corners are those of four tiles",
                argument="layout",
            )
        return _wei(material, map)
    if layout == "atlas" and tiles.family == "classed":
        raise TilewrightValueError(
            "is 'atlas'; tiles in classes go into an array, of as many layers as the GPU has",
            argument="layout",
        )
    return _array(material, map) if layout == "array" else _atlas(material, map)


def with_tone(layout: Layout, material: TextureTiles, map: str) -> Layout:
    """A layout over which the tone of a map is laid."""
    tone = material.tone
    assert tone is not None
    defines = {"SPAN": _real(tone.span), "TONE_TEXELS": _real(tone.tile_size / tone.texel)}
    defines[f"TONE_OF_{material.kinds[map].upper()}"] = "1"
    defines["TONE_MEAN"] = f"vec3({', '.join(_real(value) for value in tone_mean(material, map))})"
    return replace(layout, parts=(*layout.parts, "tone.glsl"), defines=layout.defines | defines)


def even_variants(material: TextureTiles) -> int:
    """How many variants every tile has; an error where shaders and pictures for them cannot have them so."""
    variants = material.variants
    if not 1 <= variants.even <= MOST_SHADED:
        raise TilewrightValueError(
            f"has {', '.join(name_variants(variants))}; here every tile needs as many, drawn alike, 1 to "
            f"{MOST_SHADED}",
            argument="material",
            value=variants,
            advice="TextureField and the viewer page show others",
        )
    return variants.even


def packed_rows(material: TextureTiles) -> NDArray[np.int64]:
    """The picture in each cell of an atlas: a packing for each variant, side by side from west to east.

    All of them hold the same tiles, and variants share their borders, so neighbors match where two packings
    meet and around the whole.
    """
    count, packed = even_variants(material), packing(material.tiles)
    cells = packed.indices(0, 0, *packed.size).astype(np.int64)
    return np.hstack([cells * count + variant for variant in range(count)])


def _variant_defines(variants: int) -> dict[str, str]:
    return {"VARIANTS": f"{variants}u"} if variants > 1 else {}


def _array(material: TextureTiles, map: str | None) -> Layout:
    mips = layer_mipmaps(material, map)
    defines = corner_defines(material.tiles) | array_defines(material.tile_size, mips.gutter)
    defines |= _variant_defines(even_variants(material))
    return Layout("array", ("array.glsl",), defines, (mips,))


def _atlas(material: TextureTiles, map: str | None) -> Layout:
    tiles = material.tiles
    mips = atlas_mipmaps(material, packed_rows(material), map)
    defines = corner_defines(tiles) | _variant_defines(even_variants(material))
    return Layout("atlas", atlas_parts(tiles), defines, (mips,), places=packed_places(tiles))


def atlas_parts(tiles: TileSet) -> tuple[str, ...]:
    """Shader files of the corner atlas: places by closed form where that is shorter than a table."""
    if _has_short_form(tiles):
        return "train.glsl", "torus.glsl", "atlas.glsl"
    return "torus_table.glsl", "atlas.glsl"


def packed_places(tiles: TileSet) -> NDArray[np.uint32]:
    """Column and 2^16 times row of each corner tile in the packing, where shaders look them up."""
    x, y = packing(tiles).place(np.arange(0 if _has_short_form(tiles) else len(tiles)))
    return (x + 65536 * y).astype(np.uint32)


def _has_short_form(tiles: TileSet) -> bool:
    return tiles.colors[0] == 2 or tiles.colors[0] % 2 == 1


def _wei(material: TextureTiles, map: str | None) -> Layout:
    # Near corners all variants of a tile are alike.
    corners = material.variants.starts[corner_configurations(material.tiles)]
    textures = tuple(atlas_mipmaps(material, rows, map) for rows in (packed_rows(material), corners))
    defines = wang_defines(material.tiles, material.tile_size) | _variant_defines(even_variants(material))
    return Layout("atlas", WEI_PARTS, defines, textures, density=2)


def plain_layout(pixels: NDArray[Any], kind: str) -> Layout:
    """One picture repeated, with plain mip levels."""
    one = corner_tiles(1)
    origins = np.zeros((1, *pixels.shape[:2], 3), np.uint16)
    whole = TextureTiles(
        one, {"picture": pixels[None]}, ({"picture": pixels},), origins, kinds={"picture": kind}
    )
    mips = atlas_mipmaps(whole, np.zeros((1, 1), np.int64))
    return Layout("plain", ("plain.glsl",), {"SIDES": "vec2(1.0)"}, (mips,))


def corner_configurations(tiles: TileSet) -> NDArray[np.int32]:
    """A toroidal tiling, shape (C_v^2, C_h^2), in which four edges meet in every way there is once.

    North and south edges of a column have one color and so have west and east edges of a row; columns follow
    one train and rows another, so any two colors follow each other along both (Wei 2004, as told in Lagae &
    Dutré 2006, section 6.4).
    """
    c_h, c_v = tiles.colors[:2]
    columns, rows = train(np.arange(c_h**2), c_h), train(np.arange(c_v**2), c_v)
    along, down = np.meshgrid(columns, rows)
    return tiles.find(np.stack([along, down, along, down], axis=-1)).astype(np.int32)


def corner_defines(tiles: TileSet) -> dict[str, str]:
    """What the shaders of a corner set are compiled for."""
    colors = tiles.parameters["colors"]
    defines = {"COLORS": f"{colors}u", "SIDE": _real(colors**2)}
    if tiles.family == "classed":
        return defines | {"CLASSES": f"{tiles.parameters['classes']}", "STEP": f"{tiles.parameters['step']}"}
    if colors % 2:
        return defines | {"ODD_COLORS": ""}
    if colors == 2:
        # Two bits for each window NW, NE, SW, SE of the packing.
        ne, se, sw, nw = (tiles.slots[:, slot].astype(np.int64) for slot in range(4))
        shift = 16 * nw + 8 * ne + 4 * sw + 2 * se
        for axis, place in zip("XY", packing(tiles).place(np.arange(16)), strict=True):
            defines[f"PLACES_{axis}"] = f"{int((place << shift).sum())}u"
    return defines


def array_defines(tile_size: int, gutter: int) -> dict[str, str]:
    """Where a tile lies in its layer."""
    side = tile_size + 2 * gutter
    return {"INNER": _real(tile_size / side), "GUTTER": _real(gutter / side)}


def wang_defines(tiles: TileSet, tile_size: int) -> dict[str, str]:
    """What the shader of a Wang set is compiled for."""
    c_h, c_v = tiles.colors[:2]
    return {
        "COUNTS": f"uvec2({c_h}u, {c_v}u)",
        "SIDES": f"vec2({c_v**2}.0, {c_h**2}.0)",
        # Here the content of tiles depends on their edges alone, and out there of the nearest edge alone.
        "NEAR": _real(shared_border(tile_size) / tile_size),
    }


def _real(value: float) -> str:
    return repr(float(value))
