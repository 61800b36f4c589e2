"""Every sampler by name: one way to call them all, and what each promises."""

from dataclasses import dataclass
from importlib import import_module
from inspect import signature
from typing import Any

from tilewright.checks import check_choice, check_progress
from tilewright.errors import Progress, TilewrightTypeError
from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed


@dataclass(frozen=True)
class Method:
    """A sampler of `METHODS`, and what it promises.

    Attributes
    ----------
    home : str
        "module.function" below the package of samplers; it is called as ``function(count, rho, seed=, box=,
        progress=)`` or, where ``takes_rho`` is False, without rho.
    exact : bool
        Whether there are always exactly ``count`` points; otherwise about as many. Where ``fills`` is True
        too, the number is exact only if a relative radius is asked for.
    takes_rho : bool
        Whether a relative radius can be asked for.
    promise : str
        What is certain of its points.
    source : str
        Who published it.
    fills : bool
        Whether it goes on until there is no room for another point, unless it is exact and rho is given.
    dimensions : tuple of int
        Dimensions of the boxes it works in.
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
"""Every sampler that `sample_points` knows, by name, as `Method`."""


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
    """Make points of a box by a method without tiles.

    Parameters
    ----------
    method : str
        A name of `METHODS`, such as ``"dart"``, ``"lloyd"``, ``"maximal"``, ``"best-candidate"`` or
        ``"sobol"``.
    count : int
        Number of points, 1 to 2^31 - 1: exactly as many where the method can, else about as many.
    rho : float, optional
        Relative radius, 0 to 1, where the method takes one; by default the method's own.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default the unit torus, or the plain unit square where a method knows no tori.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.
    **settings
        What else the method's function takes, such as ``iterations`` of ``"lloyd"``.

    Returns
    -------
    PointSet
        The points, the distance they keep, and the method's figures.

    Raises
    ------
    TilewrightTypeError
        A setting that the method does not take, or an argument of a wrong type.
    TilewrightValueError
        There is no such method, it does not work in such a box, it found no room for ``count`` points at
        ``rho``, or a number is out of range.

    Notes
    -----
    Lagae 2007, chapters 4 and 6; `METHODS` names the source of each method.

    Examples
    --------
    >>> import tilewright as tw
    >>> made = tw.sample_points("dart", 200, rho=0.7, seed=3)
    >>> len(made.points), bool(made.rho >= 0.7)
    (200, True)
    >>> sorted(tw.samplers.METHODS)[:4]
    ['best-candidate', 'bridson', 'dart', 'elimination']
    """
    known = METHODS[check_choice("method", method, tuple(METHODS))]
    check_progress(progress)
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
