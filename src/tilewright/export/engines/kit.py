"""A material prepared for a GPU: what the writers of all targets draw on."""

import re
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.pixels import MAP_WORDS, as_rgba, has_alpha, packed_parts, white, without_alpha
from tilewright.shaders.layouts import even_variants, packed_rows
from tilewright.shaders.lookup import ARRAY_TILES, MOST_COLORS, ToneGrid, lookup, numbers, reals
from tilewright.shaders.mipmaps import (
    Mipmaps,
    atlas_mipmaps,
    grid_mipmaps,
    grid_side,
    layer_gutter,
    layer_mipmaps,
    tone_levels,
    tone_mean,
)
from tilewright.signals.textures import TextureTiles
from tilewright.signals.textures.kinds import is_normal, is_signed, to_linear
from tilewright.tiles.classes import are_by_class

_SLOTS = {
    "emission": MAP_WORDS["emissive"].slot,
    "metallic": MAP_WORDS["metalness"].slot,
    "occlusion": MAP_WORDS["ao"].slot,
    "height": MAP_WORDS["height"].slot,
    "opacity": MAP_WORDS["opacity"].slot,
}
Levels = list[NDArray[Any]]
NO_MEAN = (-1.0, -1.0, -1.0)
"""In place of the mean of maps over which tone is an offset alone."""


@dataclass(frozen=True, eq=False)
class Kit:
    """A material on its way to an engine: what the writers of all targets draw on.

    Attributes
    ----------
    material : TextureTiles
        Over a complete corner set of 1 to 8 colors, or one in classes, with as many variants of every tile.
    seed : int
        Seed of the tiling.
    form : str
        ``"array"``: a layer for each tile and variant, with gutters; ``"grid"``: the same in the squares of
        one picture; ``"atlas"``: a packing of each variant.
    green : str
        ``"gl"`` or ``"dx"``: where the target wants the green of normal maps to point.
    """

    material: TextureTiles
    seed: int
    form: str
    green: str
    _mipmaps: dict[str, Mipmaps] = field(default_factory=dict)

    @property
    def colors(self) -> int:
        """Colors of the corner set, or of each of its classes."""
        return int(self.material.tiles.parameters["colors"])

    @property
    def classes(self) -> int:
        """Classes of lattice points; 1 where there are none."""
        return int(self.material.tiles.parameters.get("classes", 1))

    @property
    def variants(self) -> int:
        """Pictures of every tile, all drawn alike."""
        return self.material.variants.even

    @property
    def gutter(self) -> int | None:
        """Pixels around each layer; None in an atlas."""
        return None if self.form == "atlas" else layer_gutter(self.material.tile_size)

    @property
    def columns(self) -> int | None:
        """Squares along a grid; None where there is none."""
        return grid_side(len(self.material.variants)) if self.form == "grid" else None

    @property
    def slots(self) -> dict[str, str]:
        """The map for each slot of a surface: color, normal, roughness, metallic, occlusion, ..."""
        return find_slots(self.material)

    @property
    def cut_out(self) -> bool:
        """Whether alpha of the map of color tells holes, and no map of opacity does."""
        map = self.slots.get("color")
        if map is None or "opacity" in self.slots:
            return False
        pixels = self.material.maps[map]
        return has_alpha(pixels.shape[-1]) and bool((pixels[..., -1] < white(pixels.dtype)).any())

    @property
    def tone_grid(self) -> ToneGrid | None:
        """Where tone lies outside the tiles, if it does."""
        tone = self.material.tone
        return None if tone is None else ToneGrid(tone.span, tone.tile_size / tone.texel)

    @property
    def toned(self) -> tuple[str, ...]:
        """The maps that have tone."""
        return () if self.material.tone is None else tuple(self.material.tone.maps)

    @property
    def toned_slots(self) -> dict[str, str]:
        """The slots whose maps have tone, and these."""
        return {slot: map for slot, map in self.slots.items() if map in self.toned}

    def example_tone(self) -> dict[str, str | bool]:
        """What templates are filled with: whether the map of color has tone, and its `tone_mean`."""
        map = self.toned_slots.get("color")
        mean = self.tone_mean(map) if map else NO_MEAN
        return {"color_toned": map is not None, "mean": reals(mean)}

    def tone_mean(self, map: str) -> tuple[float, ...]:
        """Red, green and blue below which a map's tone is a factor, in sRGB; -1 for maps of numbers."""
        return tone_mean(self.material, map) if self.material.kinds[map] == "color" else NO_MEAN

    def tone(self, map: str) -> Levels:
        """Mip levels of a map's tone, shape (1, rows, columns, 4) each; see `tone_levels`."""
        return [level[np.newaxis] for level in tone_levels(self.material, map)]

    def mipmaps(self, map: str) -> Mipmaps:
        """Mip levels of a map as it is in the material."""
        if map not in self._mipmaps:
            if self.form == "array":
                self._mipmaps[map] = layer_mipmaps(self.material, map)
            elif self.form == "grid":
                self._mipmaps[map] = grid_mipmaps(self.material, map)
            else:
                self._mipmaps[map] = atlas_mipmaps(self.material, packed_rows(self.material), map)
        return self._mipmaps[map]

    def levels(self, map: str) -> tuple[Levels, bool]:
        """Mip levels as a GPU takes them, and whether they are sRGB: (layers, rows, columns, 1, 2 or 4).

        uint8 is kept; 16-bit and float maps become half floats, light among them linear. Three channels and
        light get four. Green points where the target wants it.
        """
        kind, levels = self.material.kinds[map], list(self.mipmaps(map).levels)
        srgb = kind == "color" and levels[0].dtype == np.uint8
        if is_normal(kind):
            signed, turn = is_signed(levels[0]), kind != f"normal-{self.green}"
            levels = [_point_green(level, turn, signed) for level in levels]
        return [_pad(_narrow(level, kind), kind == "color") for level in levels], srgb

    def picture(self, map: str) -> NDArray[Any]:
        """Level 0 of an atlas, of the map's own type; two channels of data get a third of zeros."""
        kind, level = self.material.kinds[map], self.mipmaps(map).levels[0][0]
        if is_normal(kind):
            level = _point_green(level, kind != f"normal-{self.green}", is_signed(level))
        if level.shape[-1] == 2 and kind != "color":  # a picture of two channels is gray with alpha
            level = np.concatenate([level, np.zeros_like(level[..., :1])], axis=-1)
        return level

    def lookup(self, dialect: str, *, tone: bool = True) -> str:
        """The include file of a dialect, with what lays tone where there is any; see `lookup`."""
        return lookup(
            dialect,
            self.colors,
            self.seed,
            self.material.tile_size,
            self.gutter,
            self.variants,
            self.classes,
            self.tone_grid if tone else None,
            self.columns,
        )

    def numbers(self) -> dict[str, str | bool]:
        """What templates are filled with: the numbers of the lookup, and which slots have a map."""
        slots = {f"has_{name}": name in self.slots for name in ("color", "normal", "roughness", *_SLOTS)}
        size, gutter = self.material.tile_size, self.gutter
        how = (self.variants, self.classes, self.tone_grid, self.columns)
        return numbers(self.colors, self.seed, size, gutter, *how) | slots | {"cut_out": self.cut_out}


def prepare(material: TextureTiles, seed: int, *, atlas: bool = False, green: str = "gl") -> Kit:
    """A kit; ``atlas`` for targets that take no texture arrays.

    Raises
    ------
    TilewrightValueError
        The tiles are neither a complete corner set of 1 to 8 colors nor one in classes, or have not as many
        variants each, drawn alike.
    """
    tiles = material.tiles
    classed, pictures = tiles.family == "classed", len(tiles) * even_variants(material)
    form = "grid" if classed else "atlas"
    if not atlas and pictures <= ARRAY_TILES:
        form = "array"
    known = tiles.family == "corner" or (classed and are_by_class(tiles))
    if not known or tiles.parameters["colors"] not in range(1, MOST_COLORS + 1):
        raise TilewrightValueError(
            f"is over the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles; engine shaders "
            f"find tiles of complete corner sets, corner_tiles(C) with C 1 to {MOST_COLORS}, and of those in "
            "classes",
            argument="material",
            advice="make the texture without naming a set",
        )
    return Kit(material, seed, form, green)


def find_slots(material: TextureTiles) -> dict[str, str]:
    """The map for each slot of a surface, by kind and name; the first where several would do."""
    found: dict[str, str] = {}
    for name, kind in material.kinds.items():
        if len(packed_parts(name)) > 1 and kind == "data":  # several maps in one: no slot takes it
            continue
        slot = next((s for s, names in _SLOTS.items() if re.search(names, name, re.IGNORECASE)), "")
        if is_normal(kind):
            slot = "normal"
        elif kind in ("roughness", "height"):
            slot = kind
        elif kind == "color" and slot != "emission":
            slot = "color"
        if slot:
            found.setdefault(slot, name)
    return found


def _point_green(level: NDArray[Any], turn: bool, signed: bool) -> NDArray[Any]:
    """Normals from 0 to 1 (or the whole range of integers), green turned over where asked."""
    level = level * np.float32(0.5) + np.float32(0.5) if signed else level.copy()
    if turn:
        level[..., 1] = (1 if level.dtype.kind == "f" else np.iinfo(level.dtype).max) - level[..., 1]
    return level


def _narrow(level: NDArray[Any], kind: str) -> NDArray[Any]:
    """uint8 as it is, all else as half floats; light linear."""
    if level.dtype == np.uint8:
        return level
    if level.dtype == np.uint16:
        values = level.astype(np.float32) / np.float32(65535)
        if kind == "color":
            light = without_alpha(values)
            light[...] = to_linear(light)
        level = values
    most, largest = float(np.finfo(np.float16).max), float(np.abs(level).max())
    if largest > most:
        raise TilewrightValueError(
            f"a map reaches {largest:.6g}, and the half floats it is exported as {most:.0f}",
            advice="scale it down",
        )
    return level.astype(np.float16)


def pad_levels(levels: Levels) -> Levels:
    """Levels with four channels, whatever they had: gray is repeated, a second channel stays green."""
    padded = []
    for level in levels:
        if level.shape[-1] == 2:
            level = np.concatenate([level, np.zeros_like(level[..., :1])], axis=-1)
        padded.append(_pad(level, True))
    return padded


def _pad(level: NDArray[Any], light: bool) -> NDArray[Any]:
    """Three channels, and light of any number, as four."""
    channels = level.shape[-1]
    if channels == 4 or (channels < 3 and not light):
        return np.ascontiguousarray(level)
    return as_rgba(level)
