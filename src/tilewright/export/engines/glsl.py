"""GLSL: the include file, an example of its use, KTX 2.0 textures, and a WebGL 2 page."""

from pathlib import Path

from tilewright.export.engines import webgl
from tilewright.export.engines.folder import finish
from tilewright.export.engines.kit import Kit
from tilewright.export.engines.ktx2 import write_textures
from tilewright.export.engines.parts import fill
from tilewright.files.texts import write_text


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = write_textures(folder, kit)
    array = kit.form == "array"
    texture, edge = ("sampler2DArray", "clamp to edge") if array else ("sampler2D", "repeat")
    include = kit.lookup("glsl")
    write_text(folder / "tilewright.glsl", include)
    texts = {"texture": texture, "edge": edge, "include": include}
    example = fill("glsl/example.frag", **texts, **kit.example_tone())
    write_text(folder / "example.frag", example)
    webgl.write(folder, kit)
    finish(
        kit,
        folder,
        "GLSL",
        "rendered here, in WebGL 2 and through wgpu, equal to Python's picture at one texel per pixel",
        [
            "See it: open index.html in a browser; it needs no server.",
            "Use it: put tilewright.glsl before your own shader (3.30, ES 3.00); example.frag shows the use.",
            "Load the KTX 2.0 files.",
        ],
        files,
    )
