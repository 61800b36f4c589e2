from .cameras import (
    OrthographicCamera as OrthographicCamera,
    PerspectiveCamera as PerspectiveCamera,
)
from .field import (
    GpuField as GpuField,
)
from .picture import (
    GpuPicture as GpuPicture,
)
