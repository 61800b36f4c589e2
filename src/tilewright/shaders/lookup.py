"""The tile lookup of all shader dialects: its constants and its text.

The hash is the mixer of ``docs/hashes.md``. Everything that it takes in before the low word of y depends on
the seed and on the signs of x and y alone, and is worked out here; a shader is left with two rounds for the
rows of lattice points around a cell and half a round for each of its four corners.
"""

from collections.abc import Iterable
from typing import NamedTuple

from tilewright import __version__
from tilewright.checks import check_choice, check_int
from tilewright.seeds import check_seed
from tilewright.shaders.templates import fill, read_text
from tilewright.tiles import corner_tiles
from tilewright.tiles.recognition import class_step
from tilewright.tiles.variants import MOST_SHADED
from tilewright.tilings import MixerHash
from tilewright.tilings.hashes import MULTIPLIERS
from tilewright.tilings.packings.closed_form import packing
from tilewright.tilings.streams import TONES, VARIANTS

DIALECTS = {
    "glsl": "tilewright.glsl",
    "wgsl": "tilewright.wgsl",
    "hlsl": "tilewright.hlsl",
    "unreal": "unreal_node.hlsl",
    "unreal tone": "unreal_tone.hlsl",
    "godot": "tilewright.gdshaderinc",
    "osl": "lookup.osl",
}
"""The shader dialects, and the template of each one's lookup."""
_TONED = {
    "glsl": "tone.glsl",
    "wgsl": "tone.wgsl",
    "hlsl": "tone.hlsl",
    "unreal": "tone.hlsl",
    "unreal tone": "tone.hlsl",
    "godot": "tone.gdshaderinc",
    "osl": "tone.osl",
}
"""The template of what lays tone in each dialect."""
ARRAY_TILES = 256
"""Sets of more tiles than this are laid out as an atlas, not as an array: all devices have 256 layers."""
MOST_COLORS = 8
_PAIRS = {
    "glsl": "vec2",
    "wgsl": "vec2f",
    "hlsl": "float2",
    "unreal": "float2",
    "unreal tone": "float2",
    "godot": "vec2",
    "osl": "vector",
}
"""What each dialect calls two numbers."""


class ToneGrid(NamedTuple):
    """Where tone lies outside the tiles.

    Attributes
    ----------
    span : int
        Tiles from point to point of its grid.
    texels : float
        Texels of its picture along a tile.
    """

    span: int
    texels: float


def start_states(seed: int, stream: int = 0) -> tuple[tuple[int, int], ...]:
    """Hash states (a, b) of a seed, as 32-bit words, for the four combinations of signs.

    In the order x, y >= 0; x < 0 <= y; y < 0 <= x; x, y < 0. They are the states of the corner colors of
    ``direct(tiles, seed)`` after all but the low words of y and x, for coordinates within 32 bits; for
    another stream, those of what it draws.
    """
    seed = check_seed(seed)
    hash = MixerHash(seed)
    return tuple(hash.start(x_high, y_high, stream) for y_high in (0, -1) for x_high in (0, -1))


def lookup(
    dialect: str,
    colors: int,
    seed: int,
    tile_size: int,
    gutter: int | None,
    variants: int = 1,
    classes: int = 1,
    tone: ToneGrid | None = None,
    columns: int | None = None,
) -> str:
    """The lookup in a shader dialect, as the text of an include file.

    Parameters
    ----------
    dialect : str
        One of `DIALECTS`.
    colors : int
        Colors of the complete corner set, 1 to 8, or of each class.
    seed : int
        Seed of the tiling.
    tile_size : int
        Pixels along the side of a tile.
    gutter : int or None
        Pixels around each layer of a texture array; None for the packed atlas.
    variants : int
        Pictures of every tile, all drawn alike, 1 to 256: layers one after another, or packings from west to
        east in the atlas.
    classes : int
        Classes of `tilewright.classed_corner_tiles`, with ``gutter``; 1 for complete sets.
    tone : ToneGrid, optional
        Where tone lies outside the tiles.
    columns : int, optional
        Of the grid that layers with gutters lie in, where they are no texture array.
    """
    part = DIALECTS[check_choice("dialect", dialect, tuple(DIALECTS))]
    check_int("colors", colors, 1, MOST_COLORS)
    check_int("variants", variants, 1, MOST_SHADED)
    values = numbers(colors, seed, tile_size, gutter, variants, classes, tone, columns)
    if variants > 1 and gutter is None:
        kind = _PAIRS[dialect]
        values |= {"scale": f"{kind}({values['scale_x']}, {values['scale_y']})", "scale_type": kind}
    functions = _fill("functions.hlsl", **values)
    laid = _fill(_TONED[dialect], **values) if tone else ""
    return _fill(part, **values, functions=functions, tone=laid)


def _fill(part: str, **values: str | bool) -> str:
    return fill(read_text(__package__, f"dialects/{part}"), **values)


def numbers(
    colors: int,
    seed: int,
    tile_size: int,
    gutter: int | None,
    variants: int = 1,
    classes: int = 1,
    tone: ToneGrid | None = None,
    columns: int | None = None,
) -> dict[str, str | bool]:
    """What the templates of the dialects are filled with."""
    layers, even = gutter is not None, colors % 2 == 0
    layer = tile_size + 2 * (gutter or 0)
    texels = layer * (columns or 1) if layers else colors**2 * tile_size
    wide = real(tile_size / (texels if layers else texels * variants))
    scale = real(tile_size / texels)
    named: dict[str, str | bool] = {
        "version": __version__,
        "colors": str(colors),
        "half": str(colors // 2),
        "side": str(colors**2),
        "seed": str(seed),
        "layers": layers,
        "array": layers and columns is None,
        "grid": columns is not None,
        "atlas": not layers,
        "odd": not layers and not even,
        "two": not layers and colors == 2,
        "even": not layers and even and colors > 2,
        "columns": str(columns),
        # A square's share of the side of its grid.
        "square": real(1 / (columns or 1)),
        # A tile's share of a layer's (or the atlas's) side, and where in a layer it begins.
        "scale": scale,
        "scale_x": wide,
        "scale_y": scale,
        "scale_type": "float",
        # Of an atlas that is wider than high, texture systems take its height for the level.
        "gradient": scale,
        "gutter": real((gutter or 0) / texels),
        "variants": str(variants),
        "several": variants > 1,
        "classed": classes > 1,
        "classes": str(classes),
        "step": str(class_step(classes) if classes > 1 else 0),
        # Of negative numbers, whose words are 2^32 higher: what makes their remainder right.
        "below": str(-(2**32) % classes),
        "tiles": str(colors**4),
        "toned": tone is not None,
        "span": str(tone.span if tone else 0),
        "tone_texels": real(tone.texels if tone else 0),
    }
    for n, multiplier in enumerate(MULTIPLIERS):
        named[f"m{n}"], named[f"m{n}s"] = f"0x{multiplier:08x}", str(signed(multiplier))
    for prefix, stream in (("", 0), ("v", VARIANTS), ("t", TONES)):
        for n, state in enumerate(start_states(seed, stream)):
            for letter, word in zip("ab", state, strict=True):
                name = f"{prefix}{letter}{n}"
                named[name], named[f"{name}s"] = f"0x{word:08x}", str(signed(word))
    if even:
        for axis, word in zip("xy", _base_places(), strict=True):
            named[f"base_{axis}"], named[f"base_{axis}s"] = f"0x{word:08x}", str(signed(word))
    return named


def _base_places() -> tuple[int, int]:
    """Column and row of the 16 tiles over 2 colors in their packing: two bits each, tile 0 lowest.

    Tiles are numbered NW, NE, SW, SE here, as `torus_place` has them.
    """
    packed = packing(corner_tiles(2))
    words = [0, 0]
    for code in range(16):
        nw, ne, sw, se = (code >> shift & 1 for shift in (3, 2, 1, 0))
        place = packed.place(((ne * 2 + se) * 2 + sw) * 2 + nw)
        for axis in range(2):
            words[axis] |= int(place[axis]) << 2 * code
    return words[0], words[1]


def signed(word: int) -> int:
    """A 32-bit word as the signed integer of the same bits, for dialects that know no others."""
    return word - 2**32 if word >= 2**31 else word


def reals(values: Iterable[float]) -> str:
    """`real` literals with commas between them."""
    return ", ".join(map(real, values))


def real(value: float) -> str:
    """A float literal that all dialects read back as the nearest 32-bit number."""
    text = f"{value:.9g}"
    return text if "." in text or "e" in text else f"{text}.0"
