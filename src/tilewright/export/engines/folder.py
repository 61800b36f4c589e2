"""What the folder of every target has: the material prepared for a GPU, its numbers, its README."""

import json
import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright import __version__
from tilewright.errors import TilewrightValueError
from tilewright.export.ktx2 import gpu_bytes
from tilewright.pixels import MAP_WORDS, as_rgba, without_alpha
from tilewright.shaders.layouts import even_variants, packed_rows
from tilewright.shaders.lookup import ARRAY_TILES, MOST_COLORS, lookup, numbers, start_states
from tilewright.shaders.mipmaps import Mipmaps, atlas_mipmaps, layer_mipmaps
from tilewright.signals.textures import TextureTiles
from tilewright.signals.textures.kinds import is_normal, is_signed, to_linear
from tilewright.tiles.classes import are_by_class
from tilewright.tilings.streams import VARIANTS

FACTS = "tilewright.json"
"""The file that makes a folder one of ours, and lists the others."""
_SLOTS = {
    "emission": MAP_WORDS["emissive"].slot,
    "metallic": MAP_WORDS["metalness"].slot,
    "occlusion": MAP_WORDS["ao"].slot,
    "height": MAP_WORDS["height"].slot,
    "opacity": MAP_WORDS["opacity"].slot,
}
_TAKEN = ("material", "example", "tilewright", "project", "index", "package", "places", "readme")
"""Files of the targets themselves."""
_WITH_LEVELS = "Mip levels are in the files, to the last: keep them, and filter trilinear or anisotropic."
_ODD_SIZE = " This tile size does not halve far: lines may show from afar."
_WITHOUT_LEVELS = (
    "The files hold no mip levels: renderers that take many samples a pixel need none. Made by the engine, "
    "they "
    "show no line while a texel is smaller than a sixteenth of a tile."
)
Levels = list[NDArray[Any]]


@dataclass(frozen=True, eq=False)
class Kit:
    """A material on its way to an engine: what the writers of all targets draw on.

    Attributes
    ----------
    material : TextureTiles
        Over a complete corner set of 1 to 8 colors, with as many variants of every tile.
    seed : int
        Seed of the tiling.
    form : str
        ``"array"``: a layer for each tile and variant, with gutters; ``"atlas"``: a packing of each variant.
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
        return self.mipmaps(self.material.main).gutter if self.form == "array" else None

    @property
    def slots(self) -> dict[str, str]:
        """The map for each slot of a surface: color, normal, roughness, metallic, occlusion, ..."""
        return find_slots(self.material)

    def mipmaps(self, map: str) -> Mipmaps:
        """Mip levels of a map as it is in the material."""
        if map not in self._mipmaps:
            if self.form == "array":
                self._mipmaps[map] = layer_mipmaps(self.material, map)
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

    def lookup(self, dialect: str) -> str:
        """The include file of a dialect; see `lookup`."""
        return lookup(
            dialect,
            self.colors,
            self.seed,
            self.material.tile_size,
            self.gutter,
            self.variants,
            self.classes,
        )

    def numbers(self) -> dict[str, str | bool]:
        """What templates are filled with: the numbers of the lookup, and which slots have a map."""
        slots = {f"has_{name}": name in self.slots for name in ("color", "normal", "roughness", *_SLOTS)}
        size, gutter = self.material.tile_size, self.gutter
        return numbers(self.colors, self.seed, size, gutter, self.variants, self.classes) | slots

    def finish(
        self,
        folder: Path,
        name: str,
        checked: str,
        steps: Sequence[str],
        files: dict[str, str],
        *,
        mipmaps: bool = True,
    ) -> None:
        """Write the README and the list of what the folder holds.

        Parameters
        ----------
        name : str
            What the folder is for, as a heading.
        checked : str
            ``"rendered here"`` or ``"compiled only"``, and by what: how far the project's tests went.
        steps : sequence of str
            What to do with the folder, a line each, three at most.
        files : dict of str to str
            File of each map.
        mipmaps : bool
            Whether the files hold mip levels.
        """
        text = _readme(self, name, checked, steps, files, mipmaps)
        (folder / "README.md").write_text(text, encoding="utf-8")
        _write_facts(self, folder, files)


def prepare(material: TextureTiles, seed: int, *, atlas: bool = False, green: str = "gl") -> Kit:
    """A kit; ``atlas`` for targets that take no texture arrays.

    Raises
    ------
    TilewrightValueError
        The tiles are not a complete corner set of 1 to 8 colors, or have not as many variants each, drawn
        alike.
    """
    tiles = material.tiles
    if material.tone is not None:
        raise TilewrightValueError(
            "has tone outside its tiles, which engine shaders do not lay",
            argument="material",
            advice="make the texture with tone=False",
        )
    pictures = len(tiles) * even_variants(material)
    atlas = atlas or pictures > ARRAY_TILES
    if tiles.family == "classed" and atlas:
        raise TilewrightValueError(
            f"has {pictures} pictures over tiles in classes, which go into a texture array of up to "
            f"{ARRAY_TILES} layers; this target takes an atlas",
            argument="material",
            advice="make the texture over corner_tiles()",
        )
    known = tiles.family == "corner" or (tiles.family == "classed" and are_by_class(tiles))
    if not known or tiles.parameters["colors"] not in range(1, MOST_COLORS + 1):
        raise TilewrightValueError(
            f"is over the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles; engine shaders "
            "find tiles of complete corner sets: make the texture over corner_tiles(C), C 1 to "
            f"{MOST_COLORS}",
            argument="material",
        )
    return Kit(material, seed, "atlas" if atlas else "array", green)


def find_slots(material: TextureTiles) -> dict[str, str]:
    """The map for each slot of a surface, by kind and name; the first where several would do."""
    found: dict[str, str] = {}
    for name, kind in material.kinds.items():
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


def file_names(material: TextureTiles, suffix: str) -> dict[str, str]:
    """A file for each map, all different, of letters that every system and engine takes."""
    names: dict[str, str] = {}
    for map in material.maps:
        stem = re.sub(r"[^A-Za-z0-9]+", "_", map).strip("_").lower() or "map"
        stem += "_map" if stem in _TAKEN else ""
        while f"{stem}{suffix}" in names.values():
            stem += "_"
        names[map] = f"{stem}{suffix}"
    return names


def find_objection(folder: Path) -> str:
    """Why a folder must not be replaced by an export; nothing where it may."""
    try:
        facts = json.loads((folder / FACTS).read_text(encoding="utf-8"))
        ours = {FACTS, *map(str, facts["files"])}
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        return f"holds other things and no {FACTS} of an export"
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if name not in ours and (path.is_symlink() or not path.is_dir()):
            return f"holds {name}, which the export did not write"
    return ""


def memory(kit: Kit) -> dict[str, dict[str, int]]:
    """Bytes of GPU memory of each map with its mip levels, by format: map -> format -> bytes."""
    table = {}
    for map in kit.material.maps:
        levels = list(kit.mipmaps(map).levels)
        block = {1: "BC4", 2: "BC5"}.get(levels[0].shape[-1], "BC7")
        if is_normal(kit.material.kinds[map]):
            block = "BC5"
        formats = ("RGBA8", block, "ASTC 4x4", "ASTC 6x6", "RGBA16F")
        table[map] = {format: gpu_bytes(levels, format) for format in formats}
    return table


def _readme(
    kit: Kit, name: str, checked: str, steps: Sequence[str], files: dict[str, str], mipmaps: bool
) -> str:
    material, table = kit.material, memory(kit)
    size = material.tile_size
    even = size % kit.gutter == 0 if kit.gutter else size & (size - 1) == 0
    deep = any(pixels.dtype != np.uint8 for pixels in material.maps.values())
    several = f" in {kit.variants} variants" if kit.variants > 1 else ""
    classes = f" of each of {kit.classes} classes" if kit.classes > 1 else ""
    photograph = next(iter(material.sources[0].values())).shape[1]

    def total(*formats: str) -> str:
        return f"{sum(row[f] for row in table.values() for f in formats if f in row) / 2**20:.1f} MiB"

    maps = ", ".join(
        f"{map} ({files[map]}, {material.kinds[map].partition('-')[0]})" for map in material.maps
    )
    lines = [
        f"{name}, made by tilewright {__version__}: {len(material.tiles)} corner tiles{several}, "
        f"{kit.colors} colors{classes}, {size} px, seed {kit.seed}, as {kit.form}.",
        f"Checked: {checked}.",
        *steps,
        f"Maps: {maps}; green of normals points {'up (OpenGL)' if kit.green == 'gl' else 'down (DirectX)'}"
        f"{'; 16-bit and float maps are half floats' if mipmaps and deep else ''}.",
        f"Scale: positions are in tiles, x east and y south. A tile is {size} of the photograph's "
        f"{photograph} pixels: where that is M meters wide, divide meters by {size / photograph:.4g} M.",
        (_WITH_LEVELS if mipmaps else _WITHOUT_LEVELS) + ("" if even else _ODD_SIZE),
        f"GPU memory of all maps with mips: RGBA8 {total('RGBA8')}, "
        f"BC7/BC5/BC4 {total('BC7', 'BC5', 'BC4')}, "
        f"ASTC 4x4 {total('ASTC 4x4')}, ASTC 6x6 {total('ASTC 6x6')}, half {total('RGBA16F')}.",
        "Another seed: export again. Another part of the plane, for another object: move the origin cell.",
    ]
    return "\n".join(f"{n}. {line}" if n else f"# {line}\n" for n, line in enumerate(lines)) + "\n"


def _write_facts(kit: Kit, folder: Path, files: dict[str, str]) -> None:
    """The numbers of the export, for programs, and the files of the folder."""
    table = memory(kit)
    maps = {
        map: {
            "file": files[map],
            "kind": kit.material.kinds[map],
            "levels": len(kit.mipmaps(map).levels),
            "plain_levels": kit.mipmaps(map).clean,
            "gpu_bytes": table[map],
        }
        for map in kit.material.maps
    }
    facts: dict[str, Any] = {
        "program": f"tilewright {__version__}",
        "form": kit.form,
        "tiles": len(kit.material.tiles),
        "colors": kit.colors,
        **({"classes": kit.classes} if kit.classes > 1 else {}),
        "tile_size": kit.material.tile_size,
        "gutter": kit.gutter or 0,
        "seed": kit.seed,
        "start_states": start_states(kit.seed),
        "green": kit.green,
        "maps": maps,
        "slots": kit.slots,
        "files": sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()),
    }
    if kit.variants > 1:
        facts |= {"variants": kit.variants, "variant_start_states": start_states(kit.seed, VARIANTS)}
    (folder / FACTS).write_text(json.dumps(facts, indent=1) + os.linesep, encoding="utf-8")


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
