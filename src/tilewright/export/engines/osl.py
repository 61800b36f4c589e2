"""Open Shading Language: one shader with the lookup inside, and atlases with mip levels."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.export.engines.folder import FACTS, file_names, finish, tone_names
from tilewright.export.engines.kit import Kit
from tilewright.export.engines.parts import fill
from tilewright.files.images import NO_DATE, unwritten_error
from tilewright.files.texts import write_text


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = file_names(kit.material, ".tx")
    for map, file in files.items():
        write_tx(folder / file, [level[0] for level in kit.levels(map)[0]])
    for map, file in tone_names(kit, files).items():
        write_tx(folder / file, [level[0] for level in kit.tone(map)], wrap="mirror")
    values = kit.numbers() | kit.example_tone() | {"lookup": kit.lookup("osl")}
    shader = fill("osl/tilewright.osl", **values)
    write_text(folder / "tilewright.osl", shader)
    own = f", Tone and Mean its own (means are in {FACTS})" if kit.toned else ""
    finish(
        kit,
        folder,
        "Open Shading Language",
        "rendered here, in Cycles of Blender 5.0",
        [
            f"Compile tilewright.osl with oslc; give Map a file{own} and "
            "Position tiles, x east and y south (u, -v).",
            "Maps of kind color hold sRGB where they are 8 bit; linearize them as your renderer does for "
            f"textures.{' For light in the others set Linear to 1.' if kit.toned else ''}",
        ],
        files,
    )


def write_tx(path: Path, levels: list[NDArray[Any]], wrap: str = "periodic") -> None:
    """A tiled TIFF whose subimages are mip levels, as OpenImageIO's texture system takes them."""
    import OpenImageIO as oiio

    output = oiio.ImageOutput.create("tiff")
    if output is None:
        raise unwritten_error(path)
    for number, level in enumerate(levels):
        rows, columns, channels = level.shape
        spec = oiio.ImageSpec(columns, rows, channels, "uint8" if level.dtype == np.uint8 else "float")
        spec.tile_width = spec.tile_height = 64
        spec.attribute("compression", "zip")
        spec.attribute("DateTime", NO_DATE)
        spec.attribute("textureformat", "Plain Texture")
        spec.attribute("wrapmodes", f"{wrap},{wrap}")
        mode = "AppendSubimage" if number else "Create"
        pixels = np.ascontiguousarray(level, None if level.dtype == np.uint8 else np.float32)
        if not (output.open(str(path), spec, mode) and output.write_image(pixels)):
            raise unwritten_error(path)
    if not output.close():
        raise unwritten_error(path)
