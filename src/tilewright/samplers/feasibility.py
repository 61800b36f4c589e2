"""What a sampler is asked for, checked before anything is made."""

import os
from math import sqrt
from typing import Any

from tilewright.checks import check_int, check_real, type_error
from tilewright.errors import TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.radius import LARGEST_COUNT, cell_volume, max_radius


def check_box(box: Any, *, plane: str = "") -> Box:
    """The domain, the unit torus where ``box`` is None; a plane one where ``plane`` names a method."""
    if box is None:
        return Box()
    if not isinstance(box, Box):
        raise type_error("box", box, "a Box", "Box((width, height)) makes one")
    if plane and box.dimension != 2:
        raise TilewrightValueError(
            f"has {box.dimension} dimensions; {plane} works in planes only",
            argument="box",
            value=box.dimension,
        )
    return box


def check_count(count: Any, bytes_each: int) -> int:
    """``count`` as an int, if that number of points at ``bytes_each`` fits into this machine's memory."""
    n = check_int("count", count, 1, LARGEST_COUNT, "tiles give larger sets a window at a time")
    check_memory(f"count is {n}", n * bytes_each)
    return n


def check_memory(what: str, needed: float) -> None:
    """Refuse what takes more bytes than this machine has."""
    present = _physical_memory()
    if needed > present:
        raise TilewrightValueError(
            f"{what}; that takes about {needed / 2**30:.3g} GiB and this machine has {present / 2**30:.3g}",
            advice="tiles give such sets a window at a time",
        )


def check_distance(rho: Any, count: int, box: Box, low: float = 0.0) -> float:
    """The least distance 2 rho r_max of ``count`` points in ``box``, for a rho of ``low`` up to 1.

    On a torus every point has images of itself around; no distance can be longer than theirs.
    """
    fraction = check_real("rho", rho, low, 1.0)
    distance = 2 * fraction * max_radius(count, box)
    if box.torus and distance > min(box.extent):
        reached = fraction * min(box.extent) / distance
        raise TilewrightValueError(
            f"is {fraction}; for a count of {count} the torus is so narrow that points meet their own "
            f"images, so {_round_down(reached)} can be reached",
            argument="rho",
            value=fraction,
        )
    return distance


def full_distance(count: int, box: Box, full_rho: float, margin: float) -> float:
    """The distance at which a set that has no more room comes to about ``count`` points.

    full_rho : relative radius of such sets on a torus. margin : how far, in distances, they count over the
    border of a plain box, where disks are cut off and take less room.
    """
    distance = 2 * full_rho * max_radius(count, box)
    if box.torus:
        return min(distance, *box.extent)
    low, high = distance, max(distance, 4 * sum(box.extent))
    share = cell_volume(box.dimension) * full_rho**-box.dimension
    for _ in range(100):  # bisection: the number of points falls with the distance
        middle = sqrt(low * high)
        room = 1.0
        for extent in box.extent:
            room *= (extent + margin * middle) / (middle / 2)
        low, high = (middle, high) if room / share > count else (low, middle)
    return low


def most_points(distance: float, box: Box, bytes_each: int) -> int:
    """No set of points ``distance`` apart has more: their spheres would be packed closer than can be.

    Refuses a distance at which that number of points, at ``bytes_each``, may not fit into memory.
    """
    border = 0.0 if box.torus else distance
    room = 1.0
    for extent in box.extent:
        room *= (extent + border) / (distance / 2)
    most = room / cell_volume(box.dimension) * (1 + 1e-9) + 1
    what = f"points {distance:.3g} apart may be up to {most:.3g} in the box"
    if most > LARGEST_COUNT:
        raise TilewrightValueError(
            f"{what}, the limit is {LARGEST_COUNT}", advice="ask for more rho, fewer points or a wider box"
        )
    check_memory(what, most * bytes_each)
    return int(most)


def too_full(rho: float, placed: int, count: int, dimension: int, advice: str) -> TilewrightValueError:
    """What to say when there is room for ``placed`` of ``count`` points only."""
    reached = _round_down(rho * (placed / count) ** (1 / dimension))
    return TilewrightValueError(
        f"is {rho}; there was room for {placed} of {count} points, so about {reached} can be reached",
        argument="rho",
        value=rho,
        advice=advice,
    )


def _round_down(rho: float) -> str:
    return f"{max(rho - 0.005, 0.0):.2f}"


def _physical_memory() -> float:
    """Bytes of memory, or infinity where the system does not tell."""
    try:
        return float(os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"))
    except (AttributeError, ValueError, OSError):
        return float("inf")
