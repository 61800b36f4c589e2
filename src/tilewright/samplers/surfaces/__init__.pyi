from .recipes import (
    RECIPES as RECIPES,
    Recipe as Recipe,
)
from .refining import (
    Refined as Refined,
    refine_spots as refine_spots,
)
