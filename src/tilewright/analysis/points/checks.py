"""The point sets an analysis is given, checked."""

from collections.abc import Sequence
from dataclasses import replace

from tilewright.checks import check_type
from tilewright.errors import TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet

FEWEST = 3
"""Fewer points have no spacing and no spectrum worth the name."""
LONGEST = 10_000
"""How many times as long as the other a side of a box may be where a plane is measured."""


def check_set(given: PointSet, name: str = "points", dimensions: tuple[int, ...] = (2,)) -> PointSet:
    """``given`` if it is a PointSet of enough points, all of them inside its box."""
    check_type(name, given, PointSet, "a PointSet", "PointSet(array, Box((w, h))) makes one")
    if given.box.dimension not in dimensions:
        raise TilewrightValueError(
            f"has {given.box.dimension} dimensions; this can be measured in "
            f"{' or '.join(map(str, dimensions))}",
            argument=name,
            value=given.box.dimension,
        )
    points = given.box.check_points(given.points)
    if len(points) < FEWEST:
        raise TilewrightValueError(
            f"has {len(points)} points; at least {FEWEST} are needed", argument=name, value=len(points)
        )
    return given if points is given.points else replace(given, points=points)


def check_shape(box: Box) -> None:
    """Refuse boxes so thin that their points lie in a line rather than in a plane."""
    width, height = box.extent
    if max(width, height) > LONGEST * min(width, height):
        raise TilewrightValueError(
            f"is {width:g} x {height:g}, too thin for figures of a plane; allowed are sides up to {LONGEST} "
            "times as long as the other",
            argument="box",
            value=box.extent,
            allowed=f"sides up to {LONGEST} times as long as the other",
        )


def check_sets(
    given: PointSet | Sequence[PointSet], name: str = "sets", dimensions: tuple[int, ...] = (2,)
) -> tuple[PointSet, ...]:
    """One or several PointSets of one box."""
    if isinstance(given, PointSet):
        return (check_set(given, name, dimensions),)
    check_type(name, given, (list, tuple), "a PointSet or a list of PointSets")
    if not given:
        raise TilewrightValueError("is empty; at least one PointSet is needed", argument=name)
    sets = tuple(check_set(one, f"{name}[{k}]", dimensions) for k, one in enumerate(given))
    for k, one in enumerate(sets):
        if one.box != sets[0].box:
            raise TilewrightValueError(
                f"lies in {one.box} and {name}[0] in {sets[0].box}; sets of one box are needed",
                argument=f"{name}[{k}]",
                value=one.box,
            )
    return sets
