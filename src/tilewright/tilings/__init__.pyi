from .density import (
    DensityTiling as DensityTiling,
)
from .density import (
    density_tiling as density_tiling,
)
from .direct_tiling import (
    DirectTiling as DirectTiling,
)
from .direct_tiling import (
    direct as direct,
)
from .domain import (
    Domain as Domain,
)
from .filling import (
    filled_tiling as filled_tiling,
)
from .hashes import (
    LatticeHash as LatticeHash,
)
from .hashes import (
    MixerHash as MixerHash,
)
from .packings.closed_form import (
    Packing as Packing,
)
from .packings.closed_form import (
    packing as packing,
)
from .packings.recursion import (
    extend_packing as extend_packing,
)
from .packings.recursion import (
    recursive_packing as recursive_packing,
)
from .packings.search import (
    PackingSearch as PackingSearch,
)
from .packings.search import (
    count_packings as count_packings,
)
from .packings.search import (
    random_packing as random_packing,
)
from .packings.symmetries import (
    classify_packings as classify_packings,
)
from .periods import (
    periodic_tiling as periodic_tiling,
)
from .placements import (
    Placements as Placements,
)
from .scanline_tiling import (
    scanline as scanline,
)
from .stochastic_tiling import (
    stochastic as stochastic,
)
from .table_hashes import (
    LongPeriodHash as LongPeriodHash,
)
from .table_hashes import (
    PermutationHash as PermutationHash,
)
from .tiling import (
    ArrayTiling as ArrayTiling,
)
from .tiling import (
    Tiling as Tiling,
)
from .tiling import (
    array_tiling as array_tiling,
)
from .tiling import (
    first_mismatch as first_mismatch,
)
