"""Blender: an atlas for each map, a script node that finds places in it, and the material."""

import json
from pathlib import Path

import numpy as np

from tilewright.export.engines.folder import file_names, finish, tone_names
from tilewright.export.engines.kit import Kit
from tilewright.export.engines.parts import fill
from tilewright.files.images import write_image
from tilewright.files.texts import write_text


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = write_pictures(folder, kit)
    shader = fill("blender/tilewright.osl", lookup=kit.lookup("osl", tone=False), **kit.numbers())
    write_text(folder / "tilewright.osl", shader)
    slots, tones = kit.slots, tone_names(kit, files, ".exr")
    if tones:
        tone = fill("blender/tone.osl", lookup=kit.lookup("osl"))
        write_text(folder / "tone.osl", tone)
    light = [s for s, map in slots.items() if kit.material.kinds[map] == "color"]
    script = fill(
        "blender/material.py.in",
        name="tilewright",
        files=json.dumps({slot: files[map] for slot, map in slots.items()}, indent=4),
        light=json.dumps(light),
        tones=json.dumps({slot: tones[map] for slot, map in kit.toned_slots.items()}),
        means=json.dumps({slot: kit.tone_mean(map) for slot, map in kit.toned_slots.items()}),
        toned=bool(tones),
        cut_out=kit.cut_out,
    )
    write_text(folder / "material.py", script)
    finish(
        kit,
        folder,
        "Blender",
        "rendered here, in Cycles of Blender 5.0",
        [
            "Run material.py in Blender's Scripting tab: it makes the material and switches to Cycles with "
            "Open "
            "Shading Language (CPU, or OptiX). EEVEE has no script nodes.",
            "Give the material to an object with UVs; the Mapping node's scale is tiles across one unit of "
            "UV.",
        ],
        files,
        mipmaps=False,
        cuts=True,
    )


def write_pictures(folder: Path, kit: Kit) -> dict[str, str]:
    """Write level 0 of every map as a picture; file of each map."""
    files = {}
    for map, name in file_names(kit.material, "").items():
        picture = kit.picture(map)
        files[map] = name + (".exr" if picture.dtype == np.float32 else ".png")
        write_image(folder / files[map], picture, color=kit.material.kinds[map] == "color")
    for map, name in tone_names(kit, files, ".exr").items():
        write_image(folder / name, kit.tone(map)[0][0, ..., :3].astype(np.float32))
    return files
