"""What tools see of the library: read by mypy and pyright, and never run.

The last two lines are errors that both must find: an ignored error that is none is reported as well.
"""
# mypy: warn-unused-ignores
# pyright: reportUnnecessaryTypeIgnoreComment=true

from typing import Any, assert_type

import numpy as np
from numpy.typing import NDArray

import tilewright as tw
from tilewright.gpu import GpuField

assert_type(tw.wang_tiles(2), tw.TileSet)
assert_type(tw.corner_tiles(colors=2), tw.TileSet)
assert_type(tw.wang_tiles(2).find([0, 0, 0, 0]), NDArray[np.int64])
assert_type(tw.find_period(tw.wang_tiles(2), rows=3), NDArray[np.int32] | None)

tiling: tw.Tiling = tw.direct(tw.corner_tiles(2), seed=7)
assert_type(tiling.indices(0, 0, 8, 8), NDArray[np.int32])

material = tw.texture_tiles("moss.jpg", tw.corner_tiles(2), tile_size=64, seed=1)
assert_type(material, tw.TextureTiles)
assert_type(tw.TextureField(material, tiling).render(0, 0, 80, 60), NDArray[Any])
assert_type(GpuField(material, tiling), GpuField)

blue = tw.ready_tiles()
assert_type(blue, tw.PointTiles)
assert_type(tw.PointField(blue, tiling).count(width=10, height=10), int)
assert_type(tw.sample_points("dart", 100), tw.PointSet)

tw.wang_tiles("two")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]
unknown = tw.no_such_name  # type: ignore[attr-defined]  # pyright: ignore[reportAttributeAccessIssue]
