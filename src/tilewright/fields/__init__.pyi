from .bricks.bonds import (
    BondBricks as BondBricks,
)
from .bricks.field import (
    BrickField as BrickField,
)
from .photos.contenders import (
    SideBySide as SideBySide,
)
from .photos.contenders import (
    side_by_side as side_by_side,
)
from .photos.methods import (
    HexField as HexField,
)
from .photos.methods import (
    NoiseField as NoiseField,
)
from .photos.methods import (
    RepeatField as RepeatField,
)
from .plane import (
    PixelField as PixelField,
)
from .plane import (
    PixelMap as PixelMap,
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
