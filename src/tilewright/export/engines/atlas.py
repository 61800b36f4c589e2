"""Plain pictures: an atlas for each map, and where each tile lies in it."""

import json
from pathlib import Path

from tilewright.export.engines.blender import write_pictures
from tilewright.export.engines.folder import Kit
from tilewright.tilings import packing


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = write_pictures(folder, kit)
    columns, rows = packing(kit.material.tiles).place(range(len(kit.material.tiles)))
    places = [[int(x), int(y)] for x, y in zip(columns, rows, strict=True)]
    text = json.dumps({"columns_and_rows": places, "corners_ne_se_sw_nw": kit.material.tiles.slots.tolist()})
    (folder / "places.json").write_text(text + "\n", encoding="utf-8")
    kit.finish(
        folder,
        "Atlas",
        "read back here, and rendered as in the targets that use it",
        [
            "places.json: column and row of each tile, in order of tile index, and the colors of its "
            "corners.",
            "Neighbors in the atlas match, around its border too: filter it with repeated coordinates.",
        ],
        files,
        mipmaps=False,
    )
