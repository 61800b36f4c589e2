"""KTX 2.0: a texture array, or an atlas, for each map, with its mip levels."""

from pathlib import Path

from tilewright.export.engines.folder import file_names, finish, tone_names
from tilewright.export.engines.kit import Kit
from tilewright.export.ktx2 import write_ktx2
from tilewright.files.texts import write_text


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = write_textures(folder, kit)
    for dialect, file in (
        ("glsl", "tilewright.glsl"),
        ("wgsl", "tilewright.wgsl"),
        ("hlsl", "tilewright.hlsl"),
    ):
        write_text(folder / file, kit.lookup(dialect))
    finish(
        kit,
        folder,
        "KTX 2.0 textures",
        "rendered here, read by an independent reader; the includes as in the targets glsl, wgsl and hlsl",
        [
            "Load the files with any KTX 2.0 loader; there is no supercompression, and no transcoder is "
            "needed.",
            "Sample them as the include files say. Encode them with toktx or basisu where memory counts.",
        ],
        files,
    )


def write_textures(folder: Path, kit: Kit) -> dict[str, str]:
    """Write every map; the file of each."""
    files = file_names(kit.material, ".ktx2")
    for map, file in files.items():
        levels, srgb = kit.levels(map)
        write_ktx2(
            folder / file, levels if kit.form == "array" else [level[0] for level in levels], srgb=srgb
        )
    for map, file in tone_names(kit, files).items():
        write_ktx2(folder / file, [level[0] for level in kit.tone(map)], srgb=False)
    return files
