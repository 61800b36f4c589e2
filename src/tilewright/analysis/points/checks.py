"""The point sets an analysis is given, checked."""

from collections.abc import Sequence
from dataclasses import replace

from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.samplers.point_set import PointSet

FEWEST = 3
"""Fewer points have no spacing and no spectrum worth the name."""


def check_set(given: PointSet, name: str = "points", dimensions: tuple[int, ...] = (2,)) -> PointSet:
    """``given`` if it is a PointSet of enough points, all of them inside its box."""
    if not isinstance(given, PointSet):
        raise TilewrightTypeError(
            f"{name} must be a PointSet, not {type(given).__name__}; PointSet(array, Box((w, h))) makes one"
        )
    if given.box.dimension not in dimensions:
        raise TilewrightValueError(
            f"{name} has {given.box.dimension} dimensions; this can be measured in "
            f"{' or '.join(map(str, dimensions))}"
        )
    points = given.box.check_points(given.points)
    if len(points) < FEWEST:
        raise TilewrightValueError(f"{name} has {len(points)} points; at least {FEWEST} are needed")
    return given if points is given.points else replace(given, points=points)


def check_sets(
    given: PointSet | Sequence[PointSet], name: str = "sets", dimensions: tuple[int, ...] = (2,)
) -> tuple[PointSet, ...]:
    """One or several PointSets of one box."""
    if isinstance(given, PointSet):
        return (check_set(given, name, dimensions),)
    if not isinstance(given, (list, tuple)):
        raise TilewrightTypeError(
            f"{name} must be a PointSet or a list of PointSets, not {type(given).__name__}"
        )
    if not given:
        raise TilewrightValueError(f"{name} is empty; at least one PointSet is needed")
    sets = tuple(check_set(one, f"{name}[{k}]", dimensions) for k, one in enumerate(given))
    for k, one in enumerate(sets):
        if one.box != sets[0].box:
            raise TilewrightValueError(
                f"{name}[{k}] lies in {one.box} and {name}[0] in {sets[0].box}; sets of one box are needed"
            )
    return sets
