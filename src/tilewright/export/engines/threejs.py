"""The three.js target: KTX 2.0 textures, an ES module that patches three's own materials, and a scene."""

import json
from pathlib import Path

from tilewright.export.engines.folder import finish, tone_names
from tilewright.export.engines.kit import Kit
from tilewright.export.engines.ktx2 import write_textures
from tilewright.export.engines.parts import fill
from tilewright.files.texts import write_text
from tilewright.shaders.lookup import real

_PARTS = ("tilewright.js", "index.html", "package.json")


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder for three.js."""
    files = write_textures(folder, kit)
    described = {"form": kit.form, "files": files, "slots": kit.slots}
    if kit.toned:
        means = {map: kit.tone_mean(map) for map in kit.toned}
        described |= {"tones": tone_names(kit, files), "means": means}
    values = {
        "count": str(len(kit.material.tiles)),
        "set": json.dumps(described, indent=2),
        "lookup": kit.lookup("glsl"),
        "texel": real(1 / kit.material.tile_size),
    }
    for part in _PARTS:
        text = fill(f"threejs/{part}", **kit.numbers() | values)
        write_text(folder / part, text)
    finish(
        kit,
        folder,
        "An endless material for three.js",
        "rendered here, by three.js 0.170 and 0.187 in Chromium, equal to Python's picture at one texel per "
        "pixel",
        [
            "See it: `npm install`, then `npm start` (any server of static files will do).",
            "Use it: `const tiles = await loadTilewright(url, renderer); mesh.material = tiles.material()`; "
            "url is this folder's, `material.userData.tilewright.repeat` the tiles across one unit of uv.",
            "It changes three's own materials by onBeforeCompile, for WebGLRenderer and not for "
            "WebGPURenderer; 16-bit and float maps are half floats there.",
        ],
        files,
        cuts=True,
    )
