from .exemplar import (
    Exemplar as Exemplar,
)
from .regularity import (
    Regularity as Regularity,
)
from .regularity import (
    find_regularity as find_regularity,
)
from .synthesis import (
    METHODS as METHODS,
)
from .synthesis import (
    resynthesize as resynthesize,
)
from .synthesis import (
    synthesize as synthesize,
)
from .texture_tiles import (
    TextureTiles as TextureTiles,
)
from .texture_tiles import (
    copy_from_sources as copy_from_sources,
)
