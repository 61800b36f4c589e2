from .bricks.bonds import (
    BondBricks as BondBricks,
)
from .bricks.field import (
    BrickField as BrickField,
)
from .photos.contenders import (
    SideBySide as SideBySide,
    side_by_side as side_by_side,
)
from .photos.methods import (
    HexField as HexField,
    NoiseField as NoiseField,
    RepeatField as RepeatField,
)
from .plane import (
    PixelField as PixelField,
)
from .points.field import (
    PointField as PointField,
)
from .points.window import (
    PointWindow as PointWindow,
)
from .textures import (
    TextureField as TextureField,
)
from .windows import (
    PixelMap as PixelMap,
)
