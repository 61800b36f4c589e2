"""Unreal Engine 5: an atlas for each map, a Custom node, and a script that builds the material."""

import json
from pathlib import Path

import numpy as np

from tilewright.export.engines.dds import write_dds
from tilewright.export.engines.folder import file_names, finish, tone_names
from tilewright.export.engines.kit import Kit, pad_levels
from tilewright.export.engines.parts import fill
from tilewright.files.texts import write_text


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = {map: f"T_{name}" for map, name in file_names(kit.material, ".dds").items()}
    floats = []
    for map, file in files.items():
        levels = pad_levels(kit.levels(map)[0])
        write_dds(folder / file, levels, old=levels[0].dtype == np.uint8)
        floats += [file] if levels[0].dtype != np.uint8 else []
    tones = tone_names(kit, files)
    for map, file in tones.items():
        write_dds(folder / file, kit.tone(map))
    if tones:
        write_text(folder / "custom_tone.hlsl", kit.lookup("unreal tone"))
    slots = kit.slots
    script = fill(
        "unreal/make_material.py.in",
        files=json.dumps({slot: files[map] for slot, map in slots.items()}, indent=4),
        light=json.dumps([s for s, map in slots.items() if kit.levels(map)[1]]),
        floats=json.dumps(floats),
        tones=json.dumps({slot: tones[map] for slot, map in kit.toned_slots.items()}),
        means=json.dumps({slot: kit.tone_mean(map) for slot, map in kit.toned_slots.items()}),
        toned=bool(tones),
        cut_out=kit.cut_out,
    )
    write_text(folder / "make_material.py", script)
    write_text(folder / "custom_node.hlsl", kit.lookup("unreal", tone=False))
    finish(
        kit,
        folder,
        "Unreal Engine 5",
        "compiled only: the node's code as HLSL by glslang, and run; the script against a stand-in",
        [
            "In the editor: Tools, Execute Python Script, make_material.py. It imports the maps into "
            "/Game/Tilewright with their mip levels and makes M_Tilewright, with a parameter TilesPerUV. "
            "Height and opacity are not wired.",
            "By hand: paste custom_node.hlsl into a Custom node (its head names the pins), and feed UVs, "
            "DDX and DDY "
            "of Texture Sample nodes whose mip value mode is Derivative.",
            "Sides of the atlas should be powers of two (1, 2, 4 or 8 colors), else Unreal drops mip levels.",
        ],
        files,
        cuts=True,
    )
