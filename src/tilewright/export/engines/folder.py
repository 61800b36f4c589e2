"""What the folder of every target has: its files' names, its README, its numbers."""

import json
import re
from collections.abc import Sequence
from pathlib import Path, PurePath
from typing import Any

import numpy as np

from tilewright import __version__
from tilewright.export.engines.kit import Kit
from tilewright.export.ktx2 import gpu_bytes
from tilewright.files.texts import write_text
from tilewright.shaders.lookup import start_states
from tilewright.signals.textures import TextureTiles
from tilewright.signals.textures.kinds import is_normal
from tilewright.tilings.streams import TONES, VARIANTS

FACTS = "tilewright.json"
"""The file that makes a folder one of ours, and lists the others."""
_TAKEN = ("material", "example", "tilewright", "project", "index", "package", "places", "readme")
"""Files of the targets themselves."""
_WITH_LEVELS = "Mip levels are in the files, to the last: keep them, and filter trilinear or anisotropic."
_ODD_SIZE = " This tile size does not halve far: lines may show from afar."
_WITHOUT_LEVELS = (
    "The files hold no mip levels: renderers that take many samples a pixel need none. Made by the engine, "
    "they "
    "show no line while a texel is smaller than a sixteenth of a tile."
)


def finish(
    kit: Kit,
    folder: Path,
    name: str,
    checked: str,
    steps: Sequence[str],
    files: dict[str, str],
    *,
    mipmaps: bool = True,
    cuts: bool = False,
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
    cuts : bool
        Whether the target's material shows the holes that alpha of the map of color tells.
    """
    tones = tone_names(kit, files, None if mipmaps else ".exr")
    text = _readme(kit, name, checked, [*steps, *_describe_tone(kit, tones)], files, mipmaps, cuts)
    write_text(folder / "README.md", text)
    _write_facts(kit, folder, files, tones)


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


def tone_names(kit: Kit, files: dict[str, str], suffix: str | None = None) -> dict[str, str]:
    """A file for the tone of each map that has any, beside the maps' own, with their suffix or another."""
    names: dict[str, str] = {}
    for map in kit.toned:
        own = PurePath(files[map])
        stem, end = f"{own.stem}_tone", suffix or own.suffix
        while stem + end in (*files.values(), *names.values()):
            stem += "_"
        names[map] = stem + end
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
    kit: Kit,
    name: str,
    checked: str,
    steps: Sequence[str],
    files: dict[str, str],
    mipmaps: bool,
    cuts: bool,
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
        f"{'; 16-bit and float maps are half floats' if mipmaps and deep else ''}."
        + _describe_holes(kit, files, cuts),
        f"Scale: positions are in tiles, x east and y south. A tile is {size} of the photograph's "
        f"{photograph} pixels: where that is M meters wide, divide meters by {size / photograph:.4g} M.",
        (_WITH_LEVELS if mipmaps else _WITHOUT_LEVELS) + ("" if even else _ODD_SIZE),
        f"GPU memory of all maps with mips: RGBA8 {total('RGBA8')}, "
        f"BC7/BC5/BC4 {total('BC7', 'BC5', 'BC4')}, "
        f"ASTC 4x4 {total('ASTC 4x4')}, ASTC 6x6 {total('ASTC 6x6')}, half {total('RGBA16F')}.",
        "Another seed: export again. Another part of the plane, for another object: move the origin cell.",
    ]
    return "\n".join(f"{n}. {line}" if n else f"# {line}\n" for n, line in enumerate(lines)) + "\n"


def _describe_holes(kit: Kit, files: dict[str, str], cuts: bool) -> str:
    """What becomes of alpha of the map of color, where it tells holes."""
    if not kit.cut_out:
        return ""
    how = "which the material shows" if cuts else "which nothing here cuts: discard such pixels yourself"
    return f" There are holes where alpha of {files[kit.slots['color']]} is below 0.5, {how}."


def _describe_tone(kit: Kit, tones: dict[str, str]) -> list[str]:
    """A line on what is laid over the tiles."""
    if not kit.toned:
        return []
    return [
        f"Tone, what varies over more than a tile, lies in {', '.join(tones.values())}, around 0 (colors in "
        "sRGB), and belongs over the tiles: three fetches more, by the shader where there is one; each map's "
        f"mean, which its darker colors are measured by, is in {FACTS}."
    ]


def _write_facts(kit: Kit, folder: Path, files: dict[str, str], tones: dict[str, str]) -> None:
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
        **({"columns": kit.columns} if kit.columns else {}),
        "seed": kit.seed,
        "start_states": start_states(kit.seed),
        "green": kit.green,
        "maps": maps,
        "slots": kit.slots,
        "files": sorted(p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()),
    }
    if kit.variants > 1:
        facts |= {"variants": kit.variants, "variant_start_states": start_states(kit.seed, VARIANTS)}
    if kit.tone_grid:
        facts["tone"] = {
            "files": tones,
            "means": {map: kit.tone_mean(map) for map in tones},
            "span": kit.tone_grid.span,
            "texels": kit.tone_grid.texels,
            "start_states": start_states(kit.seed, TONES),
        }
    write_text(folder / FACTS, json.dumps(facts, indent=1) + "\n")
