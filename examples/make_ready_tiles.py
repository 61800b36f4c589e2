"""Make the point tiles that come with the package again."""

from pathlib import Path

import tilewright as tw
from tilewright.files.ready import READY, folder_name

target = Path(__file__).parents[1] / "src" / "tilewright" / "files" / "ready_tiles"
target.mkdir(exist_ok=True)
for colors, points, rho in READY:
    tiles = tw.poisson_tiles(tw.corner_tiles(colors), points, rho, seed=0)
    tw.save(tiles, target / folder_name(colors, points, rho))
    print(folder_name(colors, points, rho), tiles.figures)
