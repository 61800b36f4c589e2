from .array import (
    save_array as save_array,
)
from .atlas import (
    TileGrid as TileGrid,
    make_atlas as make_atlas,
    save_atlas as save_atlas,
)
from .engines import (
    TARGETS as TARGETS,
    save_for_engine as save_for_engine,
)
from .flow_arrays import (
    save_flow as save_flow,
)
from .ktx2 import (
    write_ktx2 as write_ktx2,
)
from .viewer import (
    save_viewer as save_viewer,
)
