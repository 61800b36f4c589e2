"""Godot 4: texture arrays as resources with the mip levels inside, a spatial shader, a scene."""

import base64
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.export.engines.folder import file_names, finish, tone_names
from tilewright.export.engines.kit import Kit, Levels
from tilewright.export.engines.parts import fill
from tilewright.files.texts import write_text
from tilewright.shaders.lookup import reals

_FORMATS = {
    ("u1", 1): "Red8",
    ("u1", 2): "RedGreen",
    ("u1", 4): "RGBA8",
    ("f2", 1): "RHalf",
    ("f2", 2): "RGHalf",
    ("f2", 4): "RGBAHalf",
}
"""Names of image formats by type and channels (Godot's Image)."""
_HINTS = {"color": "source_color", "emission": "source_color", "normal": "hint_normal"}


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder that is a Godot project of its own, or part of another one."""
    files, array = file_names(kit.material, ".tres"), kit.form == "array"
    for map, file in files.items():
        _write_texture(folder / file, kit.levels(map)[0], array)
    tones = tone_names(kit, files)
    for map, file in tones.items():
        _write_texture(folder / file, kit.tone(map), False)
    uniforms = [
        f"uniform {'sampler2DArray' if array else 'sampler2D'} {slot}_map : "
        f"{_HINTS.get(slot, 'hint_default_white')}, filter_linear_mipmap_anisotropic, "
        f"repeat_{'disable' if array else 'enable'};"
        for slot in kit.slots
        if slot != "height"
    ]
    toned = {slot: map for slot, map in kit.toned_slots.items() if slot != "height"}
    uniforms += [f"uniform sampler2D {slot}_tone : filter_linear_mipmap, repeat_disable;" for slot in toned]
    values = kit.numbers() | {"uniforms": "\n".join(uniforms), "place": "vec3" if array else "vec2"}
    values |= {f"{slot}_toned": slot in toned for slot in ("color", "roughness", "emission")}
    values |= {f"{slot}_mean": reals(kit.tone_mean(map)) for slot, map in toned.items()}
    for name in ("tilewright.gdshader", "project.godot", "example.tscn"):
        write_text(folder / name, fill(f"godot/{name}", **values))
    write_text(folder / "tilewright.gdshaderinc", kit.lookup("godot"))
    laid = {slot: tones[map] for slot, map in toned.items()}
    write_text(folder / "material.tres", _material(kit, files, laid))
    finish(
        kit,
        folder,
        "Godot 4",
        "rendered here, in Godot 4.6 built for the web (Compatibility)",
        [
            "Open the folder as a project (Godot 4.3 or later) and run it, or copy it into the root of "
            "yours.",
            "Put material.tres on a mesh with UVs: `tiles` is the number of tiles across one unit of UV.",
            "Textures are resources, not imported pictures: there are no import settings. Height is not "
            "wired.",
        ],
        files,
        cuts=True,
    )


def _write_texture(path: Path, levels: Levels, array: bool) -> None:
    """A Texture2DArray or an ImageTexture with all mip levels."""
    layers = len(levels[0])
    images = "".join(_image(n, [level[n] for level in levels]) for n in range(layers))
    named = ", ".join(f'SubResource("{n}")' for n in range(layers))
    kind, content = (
        ("Texture2DArray", f"_images = [{named}]") if array else ("ImageTexture", f"image = {named}")
    )
    head = f'[gd_resource type="{kind}" load_steps={layers + 1} format=4]'
    write_text(path, f"{head}\n\n{images}[resource]\n{content}\n")


def _image(number: int, levels: list[NDArray[Any]]) -> str:
    """A picture with its mip levels, one after the other."""
    rows, columns, channels = levels[0].shape
    kind = _FORMATS[levels[0].dtype.str[1:], channels]
    pixels = b"".join(np.ascontiguousarray(level).tobytes() for level in levels)
    return (
        f'[sub_resource type="Image" id="{number}"]\n'
        f'data = {{\n"data": PackedByteArray("{base64.b64encode(pixels).decode()}"),\n'
        f'"format": "{kind}",\n"height": {rows},\n"mipmaps": true,\n"width": {columns}\n}}\n\n'
    )


def _material(kit: Kit, files: dict[str, str], laid: dict[str, str]) -> str:
    """The ShaderMaterial; ``laid`` has the file of each slot's tone."""
    kind = "Texture2DArray" if kit.form == "array" else "Texture2D"
    used = [(slot, f"{slot}_map", kind, files[map]) for slot, map in kit.slots.items() if slot != "height"]
    used += [(f"{slot}_tone", f"{slot}_tone", "Texture2D", file) for slot, file in laid.items()]
    lines = [
        f'[gd_resource type="ShaderMaterial" load_steps={len(used) + 2} format=3]\n',
        '[ext_resource type="Shader" path="res://tilewright.gdshader" id="shader"]',
        *(f'[ext_resource type="{kind}" path="res://{file}" id="{id}"]' for id, _, kind, file in used),
        '\n[resource]\nshader = ExtResource("shader")',
        *(f'shader_parameter/{name} = ExtResource("{id}")' for id, name, _, _ in used),
        "shader_parameter/tiles = Vector2(50, 50)",
        "shader_parameter/origin = Vector2i(0, 0)",
        "shader_parameter/normal_depth = 1.0",
    ]
    return "\n".join(lines) + "\n"
