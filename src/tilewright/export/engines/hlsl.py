"""HLSL: the include file, an example of its use, and DDS textures."""

from pathlib import Path

from tilewright.export.engines.dds import write_dds
from tilewright.export.engines.folder import file_names, finish, tone_names
from tilewright.export.engines.kit import Kit
from tilewright.export.engines.parts import fill
from tilewright.files.texts import write_text


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = file_names(kit.material, ".dds")
    for map, file in files.items():
        levels, srgb = kit.levels(map)
        write_dds(folder / file, levels, srgb=srgb)
    for map, file in tone_names(kit, files).items():
        write_dds(folder / file, kit.tone(map))
    array = kit.form == "array"
    texture, edge = ("Texture2DArray", "CLAMP") if array else ("Texture2D", "WRAP")
    write_text(folder / "tilewright.hlsl", kit.lookup("hlsl"))
    texts = {"texture": texture, "edge": edge}
    example = fill("hlsl/example.hlsl", **texts, **kit.example_tone())
    write_text(folder / "example.hlsl", example)
    finish(
        kit,
        folder,
        "HLSL",
        "rendered here, compiled by glslang and run through wgpu, equal to Python's picture at one texel "
        "per pixel",
        [
            "Include tilewright.hlsl, shader model 4 or later; example.hlsl shows the use.",
            "The DDS files have the header of Direct3D 10: arrays, sRGB where the map is light.",
        ],
        files,
    )
