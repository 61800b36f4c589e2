"""The page of the GLSL target: plain WebGL 2 around the include file, textures and all, opened from disk."""

import base64
import json
from collections.abc import Iterator
from pathlib import Path

from tilewright.export.engines.kit import Kit, Levels
from tilewright.export.engines.parts import fill
from tilewright.files.texts import write_text

_CHANNELS = {1: ("R", "RED"), 2: ("RG", "RG"), 4: ("RGBA", "RGBA")}


def write(folder: Path, kit: Kit) -> None:
    """Add ``index.html`` and ``textures.js`` to a folder."""
    array = kit.form == "array"
    values = {
        "lookup": kit.lookup("glsl"),
        "size": str(kit.material.tile_size),
        "sampler": "sampler2DArray" if array else "sampler2D",
        "target": "TEXTURE_2D_ARRAY" if array else "TEXTURE_2D",
        "edge": "CLAMP_TO_EDGE" if array else "REPEAT",
    }
    page = fill("webgl/index.html", **kit.numbers() | values)
    write_text(folder / "index.html", page)
    with open(folder / "textures.js", "w", encoding="utf-8", newline="\n") as file:
        file.writelines(_script(kit))


def _script(kit: Kit) -> Iterator[str]:
    """The maps with all their levels as a script: pages opened from disk may load no other files."""
    yield "// The maps with their mip levels, the largest first, as base64.\nconst TEXTURES = {\n"
    for map in kit.material.maps:
        levels, srgb = kit.levels(map)
        layers, rows, columns, channels = levels[0].shape
        half = levels[0].dtype.kind == "f"
        letters, format = _CHANNELS[channels]
        described = {
            "width": columns,
            "height": rows,
            "layers": layers,
            "internal": "SRGB8_ALPHA8" if srgb else f"{letters}{'16F' if half else '8'}",
            "format": format,
            "type": "HALF_FLOAT" if half else "UNSIGNED_BYTE",
            "light": kit.material.kinds[map] == "color",
        }
        yield f"  {json.dumps(map)}: {{ ...{json.dumps(described)}, levels: [\n"
        yield from _texts(levels)
        if map in kit.toned:
            tone = kit.tone(map)
            rows, columns = tone[0].shape[1:3]
            described = {"width": columns, "height": rows, "mean": kit.tone_mean(map)}
            yield f"  ], tone: {{ ...{json.dumps(described)}, levels: [\n"
            yield from _texts(tone)
            yield "  ] } },\n"
        else:
            yield "  ] },\n"
    yield "};\n"


def _texts(levels: Levels) -> Iterator[str]:
    for level in levels:
        little = level.astype(level.dtype.newbyteorder("<"))
        yield f'    "{base64.b64encode(little.tobytes()).decode()}",\n'
