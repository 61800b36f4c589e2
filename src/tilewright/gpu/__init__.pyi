from .cameras import (
    OrthographicCamera as OrthographicCamera,
)
from .cameras import (
    PerspectiveCamera as PerspectiveCamera,
)
from .field import (
    GpuField as GpuField,
)
from .picture import (
    GpuPicture as GpuPicture,
)
