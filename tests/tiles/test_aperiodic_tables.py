"""Tables 8.1 to 8.7 of Lagae 2007, and the same rows for the sets of Jeandel and Rao, entry by entry."""

import warnings

import numpy as np
import pytest

from tilewright.errors import TilewrightError, TilewrightWarning
from tilewright.tiles import as_wang_tiles
from tilewright.tiles.aperiodic import aperiodic_tiles
from tilewright.tiles.translations import as_corner_tiles, blocks

# "tiles/colors" of corner and Wang sets in turn. The first two entries are tables 8.1 and 8.2, the rows
# tables 8.3 to 8.7. Those of Jeandel and Rao's sets, which are younger than the thesis, were computed by a
# second program.
TABLES = {
    "culik-13": {
        "diagonal": "125/13 125/50 1240/125 1240/418 14810/1240 14810/4523 160168/14810",
        "horizontal": "failed",
        "vertical": "failed",
        "rotation": "60/9 60/21 126/42 126/84 336/149 336/228 702/456",
        "subdivision": "52/19 52/36 208/89 208/176 832/385 832/768 3328/1601",
    },
    "kari-14": {
        "diagonal": "214/14 214/86 3052/214 3052/1208 58910/3052 58910/19274 1213029/58910",
        "horizontal": "failed",
        "vertical": "86/6 86/36 504/36 504/216 2968/216 2968/1272 17464/1272",
        "rotation": "94/9 94/23 210/46 210/136 596/204 596/372 1306/744",
        "subdivision": "56/21 56/40 224/97 224/192 896/417 896/832 3584/1729",
    },
    "ammann-16": {
        "diagonal": "87/16 87/44 286/87 286/160 777/286 777/464 1642/777",
        "horizontal": "44/6 44/24 138/24 138/82 438/82 438/271 1406/271",
        "vertical": "44/6 44/24 138/24 138/82 438/82 438/271 1406/271",
        "rotation": "49/12 49/32 113/52 113/80 257/160 257/226 545/416",
        "subdivision": "64/23 64/44 256/109 256/216 1024/473 1024/944 4096/1969",
    },
    "jeandel-rao-11-4": {
        "diagonal": "89/11 89/37 526/89 526/240 2651/526 2651/1258 14774/2651",
        "horizontal": "failed",
        "vertical": "failed",
        "rotation": "40/8 40/18 102/35 102/63 249/121 249/181 559/356",
        "subdivision": "44/16 44/30 176/75 176/148 704/325 704/648 2816/1353",
    },
    "jeandel-rao-11-5": {
        "diagonal": "85/11 85/35 444/85 444/208 1723/444 1723/866 9172/1723",
        "horizontal": "failed",
        "vertical": "failed",
        "rotation": "36/9 36/18 92/35 92/57 218/113 218/162 488/320",
        "subdivision": "44/17 44/32 176/77 176/152 704/329 704/656 2816/1361",
    },
}
CASES = [(name, construction) for name, row in TABLES.items() for construction in row]
MOST_COLORS = 2**15

FAILED = {
    ("culik-13", "horizontal"): "36 different pairs of tiles give only 30",
    ("culik-13", "vertical"): "53 different pairs of tiles give only 47",
    ("kari-14", "horizontal"): "34 different pairs of tiles give only 21",
    ("jeandel-rao-11-4", "horizontal"): "31 different pairs of tiles give only 26",
    ("jeandel-rao-11-4", "vertical"): "37 different pairs of tiles give only 36",
    ("jeandel-rao-11-5", "horizontal"): "31 different pairs of tiles give only 28",
    ("jeandel-rao-11-5", "vertical"): "35 different pairs of tiles give only 34",
}


@pytest.mark.parametrize(("name", "construction"), CASES)
def test_every_entry_of_the_tables(name, construction):
    wang = aperiodic_tiles(name)
    wanted = TABLES[name][construction].split()
    if wanted == ["failed"]:
        with pytest.raises(TilewrightError, match=FAILED[name, construction]):
            as_corner_tiles(wang, construction)
        return
    found = []
    for entry in wanted:
        if int(entry.split("/")[1]) > MOST_COLORS:  # the one too large for a TileSet: count its blocks
            found.append(f"{len(blocks(wang.slots.astype(np.int64)))}/{len(wang)}")
            break
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", TilewrightWarning)
            made = as_wang_tiles(wang) if wang.shape.name == "corner" else as_corner_tiles(wang, construction)
        found.append(f"{len(made)}/{max(made.colors)}")
        wang = made
    assert found == wanted


def test_the_columns_of_table_8_1_for_rotation_split_into_white_and_black():
    # 60(13+47), 94(14+80), 49(16+33)
    for name, white, black in (("culik-13", 13, 47), ("kari-14", 14, 80), ("ammann-16", 16, 33)):
        wang = aperiodic_tiles(name)
        corners = as_corner_tiles(wang, "rotation")
        level = len(np.unique(wang.slots[:, [0, 2]]))
        is_white = corners.slots[:, 0] < level  # colors of N and S edges come first
        assert (is_white.sum(), (~is_white).sum()) == (white, black)
