from .density import (
    DensityTiling as DensityTiling,
    density_tiling as density_tiling,
)
from .direct_tiling import (
    DirectTiling as DirectTiling,
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
    MixerHash as MixerHash,
)
from .packings.closed_form import (
    Packing as Packing,
    packing as packing,
)
from .packings.recursion import (
    extend_packing as extend_packing,
    recursive_packing as recursive_packing,
)
from .packings.search import (
    PackingSearch as PackingSearch,
    count_packings as count_packings,
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
    PermutationHash as PermutationHash,
)
from .tiling import (
    ArrayTiling as ArrayTiling,
    Tiling as Tiling,
    array_tiling as array_tiling,
    first_mismatch as first_mismatch,
)
