"""Plain pictures: an atlas for each map, and where each tile lies in it."""

import json
from pathlib import Path
from typing import Any

from tilewright.export.engines.blender import write_pictures
from tilewright.export.engines.folder import Kit
from tilewright.tilings import packing


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = write_pictures(folder, kit)
    tiles, packed = kit.material.tiles, packing(kit.material.tiles)
    places = [
        [int(x) + packed.size[0] * variant, int(y)]
        for x, y in zip(*packed.place(range(len(tiles))), strict=True)
        for variant in range(kit.variants)
    ]
    found: dict[str, Any] = {"columns_and_rows": places, "corners_ne_se_sw_nw": tiles.slots.tolist()}
    if kit.variants > 1:
        found["variants"] = kit.variants
    text = json.dumps(found)
    (folder / "places.json").write_text(text + "\n", encoding="utf-8")
    kit.finish(
        folder,
        "Atlas",
        "read back here, and rendered as in the targets that use it",
        [
            f"places.json: column and row of each tile{' and its variants' if kit.variants > 1 else ''}, in "
            "order of tile index, and the colors of its corners.",
            "Neighbors in the atlas match, around its border too: filter it with repeated coordinates.",
        ],
        files,
        mipmaps=False,
    )
