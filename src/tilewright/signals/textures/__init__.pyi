from .exemplar import (
    Exemplar as Exemplar,
)
from .methods import (
    METHODS as METHODS,
)
from .regularity import (
    Regularity as Regularity,
    find_regularity as find_regularity,
)
from .synthesis import (
    resynthesize as resynthesize,
    synthesize as synthesize,
)
from .texture_tiles import (
    TextureTiles as TextureTiles,
    copy_from_sources as copy_from_sources,
)
