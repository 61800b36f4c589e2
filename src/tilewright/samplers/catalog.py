"""Every sampler by name: one way to call them all, and what each promises."""

from dataclasses import dataclass
from importlib import import_module
from inspect import signature
from typing import Any

from tilewright.checks import check_choice
from tilewright.errors import Progress, TilewrightTypeError
from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed


@dataclass(frozen=True)
class Method:
    """A sampler.

    Attributes
    ----------
    home : str
        "module.function" below this package; called as ``function(count, rho, seed=, box=, progress=)``
        or, where ``takes_rho`` is False, without rho.
    exact : bool
        Whether there are always exactly ``count`` points; else about so many. Where ``fills`` is True too,
        exactly so many with rho only.
    takes_rho : bool
        Whether a relative radius can be asked for.
    promise : str
        What is certain of its points.
    source : str
        Who published it.
    fills : bool
        Whether it goes on until there is no room for another point, unless it is exact and rho is given.
    dimensions : tuple of int
        Of the boxes it works in.
    tori : bool
        Whether these may be tori.
    """

    home: str
    exact: bool
    takes_rho: bool
    promise: str
    source: str
    fills: bool = False
    dimensions: tuple[int, ...] = (2, 3)
    tori: bool = True


_APART = "no two points closer than 2 rho r_max"
_NO_ROOM = "no place farther than that from all points"
_FULL = f"{_APART}, {_NO_ROOM}"
_PLANE = (2,)

METHODS: dict[str, Method] = {
    "dart": Method("darts.dart_throwing", True, True, _APART, "Cook 1986; Lagae 2007, section 6.3"),
    "relaxation": Method(
        "relaxation.relaxation_darts", True, False,
        "the first n points well spread for every n; the distance reached is told",
        "McCool & Fiume 1992; Lagae 2007, section 6.4",
    ),
    "lloyd": Method(
        "lloyd.lloyd_relaxation", True, True, f"with rho {_APART}",
        "Lloyd 1982; McCool & Fiume 1992; Lagae 2007, section 6.5", dimensions=_PLANE,
    ),
    "best-candidate": Method(
        "candidates.best_candidate", True, False,
        "the first n points well spread for every n", "Mitchell 1991",
    ),
    "bridson": Method("bridson.bridson_darts", False, True, _APART, "Bridson 2007"),
    "jones": Method(
        "jones.jones_darts", True, True, f"{_APART}; without rho {_NO_ROOM}",
        "Jones 2006; Lagae 2007, section 6.12", fills=True, dimensions=_PLANE,
    ),
    "maximal": Method(
        "maximal.maximal_darts", True, True, f"{_APART}; without rho {_NO_ROOM}",
        "Ebeida et al. 2012", fills=True,
    ),
    "scallop-log": Method(
        "scallops.scallop_log", False, True, _FULL,
        "Dunbar & Humphreys 2006; Lagae 2007, section 6.13", fills=True, dimensions=_PLANE,
    ),
    "scallop-linear": Method(
        "scallops.scallop_linear", False, True, _FULL,
        "Dunbar & Humphreys 2006; Lagae 2007, section 6.13", fills=True, dimensions=_PLANE,
    ),
    "scallop-boundary": Method(
        "scallops.scallop_boundary", False, True, f"{_FULL}; every disk touches another",
        "Dunbar & Humphreys 2006; Lagae 2007, section 6.13", fills=True, dimensions=_PLANE,
    ),
    "penrose": Method(
        "penrose.penrose_points", False, False, "vertices of a Penrose tiling, moved by tabulated vectors",
        "Ostromoukhov, Donohue & Jodoin 2004; Lagae 2007, section 6.8", dimensions=_PLANE, tori=False,
    ),
    "elimination": Method(
        "elimination.sample_elimination", True, False,
        "of the points begun with, the least crowded", "Yuksel 2015",
    ),
    "uniform": Method(
        "yardsticks.uniform", True, False, "every place equally likely", "Lagae 2007, section 4.2.1"
    ),
    "jittered": Method(
        "yardsticks.jittered", True, False, "one point in each of as many parts of equal area",
        "Cook 1986; Lagae 2007, section 6.2",
    ),
    "sobol": Method(
        "yardsticks.sobol", True, False,
        "for a power of two, one point in each part of every binary division into as many parts",
        "Sobol 1967; Owen 1995",
    ),
    "regular": Method(
        "yardsticks.regular", False, False, "a grid of nearly square cells", "Lagae 2007, section 6.2"
    ),
    "hexagonal": Method(
        "yardsticks.hexagonal", False, False, "a lattice of nearly equilateral triangles, rho nearly 1",
        "Lagae 2007, section 4.2.3", dimensions=_PLANE,
    ),
}  # fmt: skip


def sample_points(
    method: str,
    count: int,
    rho: float | None = None,
    *,
    seed: Seed = 0,
    box: Box | None = None,
    progress: Progress | None = None,
    **settings: Any,
) -> PointSet:
    """Points of a box by a method without tiles.

    Parameters
    ----------
    method : str
        A name of `METHODS`.
    count : int
        How many points; exactly where the method can, else about.
    rho : float, optional
        Relative radius, where the method takes one; its usual one by default.
    seed : int or numpy Generator
    box : Box, optional
        The domain; the unit torus by default, the plain unit square where a method knows no tori.
    progress : callable, optional
    **settings
        What else the method's function takes.

    Returns
    -------
    PointSet
    """
    known = METHODS[check_choice("method", method, tuple(METHODS))]
    module, function = known.home.split(".")
    run = getattr(import_module(f"tilewright.samplers.{module}"), function)
    usual = {"count", "rho", "seed", "box", "progress"}
    taken = [name for name in signature(run).parameters if name not in usual]
    for name in settings:
        if name not in taken:
            raise TilewrightTypeError(
                f"the method {method!r} does not take {name}; it takes {', '.join(taken) or 'no settings'}"
            )
    if rho is not None:
        if not known.takes_rho:
            raise TilewrightTypeError(f"the method {method!r} does not take rho; its points have their own")
        settings["rho"] = rho
    made: PointSet = run(count, seed=seed, box=box, progress=progress, **settings)
    return made
