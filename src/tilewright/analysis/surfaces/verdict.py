"""Whether points on a surface are evenly spread, in words: what to object to, and what to change.

Li et al. 2010, section V.B, ask for a relative radius between 0.65 and 0.90. Holes are judged by what dart
throwing leaves, counts by what chance makes of them.
"""

from math import isnan
from typing import NamedTuple

LEAST_RHO, MOST_RHO = 0.65, 0.90
HOLE = 2.3
"""Most coverage in r_max: dart throwing leaves 1.8 to 2.2, a relaxed set about 1.6."""
UNEVEN = 0.7
"""Most chi2 of points kept apart: 0.1 to 0.5 where their density is even."""
UNEVEN_BY_CHANCE = 2.0
"""Most chi2 of points that clump: random ones have about 1, of 64 cells seldom more than 1.5."""


class Objection(NamedTuple):
    """What a picky user would object to, and what to change."""

    says: str
    advice: str


def judge_surface(figures: dict[str, float]) -> list[str]:
    """Say in one to three sentences whether points are evenly spread; see `SurfaceReport.figures`."""
    found = [*_faults(figures), *_spacing(figures), *_spread(figures)]
    said = [_summary(figures, found)]
    if found:
        advice = dict.fromkeys(objection.advice for objection in found)
        said.append(f"To object to: {'; '.join(objection.says for objection in found)}.")
        said.append(f"To change: {'; '.join(advice)}.")
    return said


def _faults(figures: dict[str, float]) -> list[Objection]:
    """What no set should have."""
    found = []
    if off := figures["off_surface"]:
        says = f"{off:,.0f} with weights below 0, or that do not add up to 1, lie beside their triangles"
        found.append(Objection(says, "weights of 0 to 1 that add up to 1"))
    if twice := figures["duplicates"]:
        says = f"{twice:,.0f} lie where another does"
        found.append(Objection(says, "each place once"))
    return found


def _spacing(figures: dict[str, float]) -> list[Objection]:
    """What distances show."""
    rho, space = figures["rho_surface"], figures["rho_space"]
    found = []
    if rho < LEAST_RHO and not figures["duplicates"]:
        some = figures["mean"] >= LEAST_RHO
        how = "some points lie closer than the rest" if some else "points clump"
        says = f"{how}: the closest {rho:.2f} of the densest packing's distance, {LEAST_RHO} is good"
        found.append(Objection(says, "refinement, which pushes apart what is too near, or more of it"))
    elif rho > MOST_RHO:
        says = f"points lie as on a lattice: least distance {rho:.2f}, up to {MOST_RHO:.2f} is irregular"
        found.append(Objection(says, "a smaller distance, 0.75 to 0.80, or fewer steps of Lloyd's method"))
    if space < LEAST_RHO <= rho:
        says = f"points on both sides of thin parts come as close as {space:.2f} in space"
        found.append(Objection(says, "distances kept in space, where that matters"))
    return found


def _spread(figures: dict[str, float]) -> list[Objection]:
    """What holes and counts show."""
    found = []
    if figures["coverage"] > HOLE:
        says = f"holes: a place {figures['coverage']:.1f} r_max from any point, where darts leave 2.2"
        found.append(Objection(says, "refinement that moves crowded points into holes"))
    limit = UNEVEN if figures["rho_surface"] >= LEAST_RHO else UNEVEN_BY_CHANCE
    if figures["chi2"] > limit:
        says = f"points are not in proportion to area: counts vary {figures['chi2']:.2g} times as chance does"
        found.append(Objection(says, "numbers that follow the area of triangles, not their count"))
    return found


def _summary(figures: dict[str, float], found: list[Objection]) -> str:
    rho, mean = figures["rho_surface"], figures["mean"]
    if found:
        good = rho >= LEAST_RHO and not figures["off_surface"]
        return "Evenly spread, with faults." if good else "Not evenly spread."
    said = f"Evenly spread: least distance {rho:.2f}, where {LEAST_RHO} to {MOST_RHO:.2f} is good"
    said += f", {mean:.2f} in the mean; no place farther than {figures['coverage']:.1f} r_max from a point"
    six = figures["six_neighbors"]
    return f"{said}." if isnan(six) else f"{said}; {six:.0%} have six neighbors."
