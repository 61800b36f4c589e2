"""WGSL: the include file, an example of its use, and KTX 2.0 textures."""

from pathlib import Path

from tilewright.export.engines.folder import finish
from tilewright.export.engines.kit import Kit
from tilewright.export.engines.ktx2 import write_textures
from tilewright.export.engines.parts import fill
from tilewright.files.texts import write_text


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = write_textures(folder, kit)
    array = kit.form == "array"
    texture, edge = ("texture_2d_array", "clamp-to-edge") if array else ("texture_2d", "repeat")
    write_text(folder / "tilewright.wgsl", kit.lookup("wgsl"))
    texts = {"texture": texture, "edge": edge}
    example = fill("wgsl/example.wgsl", **texts, **kit.example_tone())
    write_text(folder / "example.wgsl", example)
    finish(
        kit,
        folder,
        "WGSL",
        "rendered here, through wgpu, equal to Python's picture at one texel per pixel",
        [
            "Put tilewright.wgsl before your own shader; example.wgsl shows the use.",
            "Load the KTX 2.0 files.",
        ],
        files,
    )
