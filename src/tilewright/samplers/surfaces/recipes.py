"""What is done to points of a surface, and how far."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Recipe:
    """Steps that even out points, in their order, and their settings.

    Attributes
    ----------
    rho : float
        The relative radius that pairs are pushed apart to.
    lloyd : int
        Steps towards the middles of cells (Lloyd 1982).
    omega : float
        How much farther than to the middle they go; the last one goes just there.
    hole : float
        A place so far from all points, in radii of the densest packing, is a hole.
    fill : int
        Most rounds of moving the most crowded points into holes.
    sweeps : int
        Most rounds of pushing.
    """

    rho: float = 0.765
    lloyd: int = 4
    omega: float = 1.5
    hole: float = 1.75
    fill: int = 3
    sweeps: int = 400


RECIPES = {"even": Recipe(), "poisson": Recipe(lloyd=0, fill=4)}
"""``even``: Lloyd's method first, for an even cover. ``poisson``: without it, for more chance."""
