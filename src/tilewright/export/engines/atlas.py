"""Plain pictures: an atlas for each map, and where each tile lies in it."""

import json
from pathlib import Path
from typing import Any

from tilewright.export.engines.blender import write_pictures
from tilewright.export.engines.folder import finish
from tilewright.export.engines.kit import Kit
from tilewright.files.texts import write_text
from tilewright.tilings import packing


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = write_pictures(folder, kit)
    tiles = kit.material.tiles
    places = _packed(kit) if kit.columns is None else _squares(kit, kit.columns)
    found: dict[str, Any] = {"columns_and_rows": places, "corners_ne_se_sw_nw": tiles.slots.tolist()}
    between = (
        "Neighbors in the atlas match, around its border too: filter it with repeated coordinates."
        if kit.columns is None
        else f"Around each tile lie {kit.gutter} pixels that continue it: a square is "
        f"{kit.material.tile_size + 2 * (kit.gutter or 0)} pixels wide. Filter within it."
    )
    if kit.variants > 1:
        found["variants"] = kit.variants
    text = json.dumps(found)
    write_text(folder / "places.json", text + "\n")
    finish(
        kit,
        folder,
        "Atlas",
        "read back here, and rendered as in the targets that use it",
        [
            f"places.json: column and row of each tile{' and its variants' if kit.variants > 1 else ''}, in "
            "order of tile index, and the colors of its corners.",
            between,
        ],
        files,
        mipmaps=False,
    )


def _packed(kit: Kit) -> list[list[int]]:
    """Column and row of every picture in the packings of its variants."""
    packed = packing(kit.material.tiles)
    return [
        [int(x) + packed.size[0] * variant, int(y)]
        for x, y in zip(*packed.place(range(len(kit.material.tiles))), strict=True)
        for variant in range(kit.variants)
    ]


def _squares(kit: Kit, columns: int) -> list[list[int]]:
    """Column and row of every picture in its grid."""
    return [[n % columns, n // columns] for n in range(len(kit.material.variants))]
