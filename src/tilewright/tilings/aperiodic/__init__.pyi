from .endless import (
    aperiodic_tiling as aperiodic_tiling,
)
from .translated import (
    TranslatedTiling as TranslatedTiling,
    translated_tiling as translated_tiling,
)
