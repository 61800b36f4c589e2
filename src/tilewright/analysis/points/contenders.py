"""Who takes part in a comparison of methods: samplers, point tiles and peers (Lagae 2007, chapter 6)."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from importlib.util import find_spec
from math import sqrt
from typing import Any

import numpy as np

from tilewright.analysis.points.laid_tiles import lay_square
from tilewright.errors import Progress
from tilewright.fields import PointField
from tilewright.samplers import METHODS, Box, PointSet, sample_points
from tilewright.signals.points import PointTiles, make_point_tiles
from tilewright.tilings import scanline

Make = Callable[[int, int], PointSet]
"""Makes a set of about a number of points, from that number and a seed."""


@dataclass(frozen=True)
class Contender:
    """A method with its settings.

    Attributes
    ----------
    name : str
        What tables and the command line call it.
    source : str
        Who published it.
    seconds : float
        What 16,384 points are expected to cost, in seconds, so that hopeless cases are not begun.
    prepare : callable
        ``prepare(seed, progress)`` does what is done once, such as building tiles, and gives ``make``.
    standard : bool
        Whether it takes part where nothing else is said; default True.
    repeats : bool
        Whether every seed gives another set, else one periodogram is all there is; default True.
    builds : bool
        Whether something is built first, the time of which is told apart; default False.
    """

    name: str
    source: str
    seconds: float
    prepare: Callable[[int, Progress | None], Make]
    standard: bool = True
    repeats: bool = True
    builds: bool = False


def list_contenders() -> dict[str, Contender]:
    """List every method by name, in the order of the thesis; peers where they are installed.

    Returns
    -------
    dict of str to Contender
        The methods that `compare` can run.
    """
    everyone = [*_yardsticks(), *_samplers(), *_tiles(), *_peers()]
    return {c.name: c for c in everyone}


def _sampler(name: str, seconds: float, method: str, *, standard: bool = True, **settings: Any) -> Contender:
    known = METHODS[method]
    box = Box(torus=known.tori)

    def make(count: int, seed: int) -> PointSet:
        return sample_points(method, count, seed=seed, box=box, **settings)

    return Contender(
        name,
        known.source,
        seconds,
        lambda seed, progress: make,
        standard,
        repeats=method not in ("regular", "hexagonal", "penrose"),
    )


def _yardsticks() -> list[Contender]:
    names = ("uniform", "regular", "jittered", "sobol", "hexagonal")
    return [_sampler(name, 0.01, name, standard=name != "hexagonal") for name in names]


def _samplers() -> list[Contender]:
    lloyd = [
        Contender(
            f"lloyd {k}",
            METHODS["lloyd"].source,
            0.02 * k + 0.05,
            partial(_prepare_lloyd, k),
            standard=k in (1, 16),
        )
        for k in (1, 2, 4, 8, 16, 32)
    ]
    relaxation = [
        _sampler(
            f"relaxation {factor:g}",
            cost,
            "relaxation",
            factor=factor,
            failures=failures,
            standard=factor == 0.99,
        )
        for factor, failures, cost in ((0.9, 100, 0.02), (0.99, 1000, 0.3), (0.999, 10000, 6.0))
    ]
    return [
        _sampler("dart 0.70", 0.02, "dart", rho=0.70),
        _sampler("dart 0.75", 0.1, "dart", rho=0.75),
        *relaxation,
        *lloyd,
        _sampler("penrose", 0.05, "penrose"),
        _sampler("jones 0.70", 0.2, "jones", rho=0.70, standard=False),
        _sampler("jones 0.75", 0.2, "jones", rho=0.75),
        _sampler("scallop-log", 0.5, "scallop-log"),
        _sampler("scallop-linear", 0.5, "scallop-linear", standard=False),
        _sampler("scallop-boundary", 0.05, "scallop-boundary"),
        _sampler("maximal", 0.1, "maximal"),
        _sampler("best-candidate", 3.0, "best-candidate"),
        _sampler("bridson", 0.1, "bridson"),
        _sampler("elimination", 0.3, "elimination"),
    ]


def _prepare_lloyd(iterations: int, seed: int, progress: Progress | None) -> Make:
    """Iterations that begin with dart throwing, as in figure 6.10."""

    def make(count: int, seed: int) -> PointSet:
        start = sample_points("dart", count, 0.70, seed=seed)
        return sample_points("lloyd", count, start=start, iterations=iterations)

    return make


def _tiled(name: str, source: str, standard: bool, **settings: Any) -> Contender:
    def prepare(seed: int, progress: Progress | None) -> Make:
        tiles = make_point_tiles(seed=seed, progress=progress, **settings)
        return partial(lay_square, tiles)

    return Contender(name, source, 0.01, prepare, standard=standard, builds=True)


def _tiles() -> list[Contender]:
    hiller = "Hiller et al. 2001; Lagae 2007, section 6.7"
    edge = "Lagae & Dutré 2005a; Lagae 2007, section 6.9"
    template = "Lagae & Dutré 2005b; Lagae 2007, section 6.10"
    corner = "Lagae & Dutré 2006; Lagae 2007, section 6.11"
    ours = "tilewright"
    return [
        _tiled("shade", "Shade et al. 2000; Lagae 2007, section 6.6", True, method="shade"),
        *(
            _tiled(f"hiller {n}", hiller, n == 32, method="hiller", points=n)
            for n in (16, 19, 32, 41, 53, 63)
        ),
        *(_tiled(f"edge {n}", edge, n == 32, method="edge", points=n, rho=0.75) for n in (32, 48, 64)),
        *(
            _tiled(f"template {t} {n}", template, t == 128, method="template", variants=t, points=n)
            for t, n in ((8, 24), (32, 48), (128, 96))
        ),
        *(
            _tiled(
                f"corner-relaxed {c} {n}",
                corner,
                (c, n) in ((4, 32), (8, 64)),
                method="corner-relaxed",
                colors=c,
                points=n,
            )
            for c in (3, 4, 6, 8)
            for n in (32, 48, 64)
        ),
        *(
            _tiled(f"corner {c} {n}", ours, (c, n) != (6, 64), method="corner", colors=c, points=n)
            for c, n in ((4, 32), (4, 64), (6, 32), (6, 64))
        ),
        Contender(
            "kopf",
            "Kopf et al. 2006; Lagae 2007, section 6.14",
            0.05,
            _prepare_kopf,
            builds=True,
        ),
    ]


def _prepare_kopf(seed: int, progress: Progress | None) -> Make:
    return partial(_lay_kopf, make_point_tiles("kopf", seed=seed, progress=progress))


def _lay_kopf(tiles: PointTiles, count: int, seed: int) -> PointSet:
    """So many points on the smallest square of tiles that holds them; these tiles are meant to be thinned."""
    field = PointField(tiles, scanline(tiles.tiles, 64, 64, seed))
    side = field.side_for(count)
    box = Box((float(side), float(side)), torus=False)
    return PointSet(field.sample(count, 0, 0, side, side), box, "kopf tiles")


def _peers() -> list[Contender]:
    peers = [
        Contender(
            "scipy",
            "scipy.stats.qmc.PoissonDisk; Bridson 2007",
            15.0,
            lambda seed, progress: _scipy,
            standard=True,
        )
    ]
    if find_spec("bridson") is not None:
        source = "pip install bridson; Bridson 2007"
        peers.append(Contender("bridson package", source, 1.6, lambda seed, progress: _bridson))
    return peers


def _distance_for(count: int) -> float:
    """Bridson's method leaves about ``count`` points of the unit square at this distance."""
    return sqrt(0.70 * 0.87 / count)


def _scipy(count: int, seed: int) -> PointSet:
    from scipy.stats import qmc

    radius = _distance_for(count)
    points = qmc.PoissonDisk(2, radius=radius, rng=np.random.default_rng(seed)).fill_space()
    return PointSet(np.clip(points, 0, np.nextafter(1, 0)), Box(torus=False), "scipy", radius)


def _bridson(count: int, seed: int) -> PointSet:
    import random

    import bridson

    random.seed(seed)
    np.random.seed(seed)  # noqa: NPY002
    radius = _distance_for(count)
    points = np.array(bridson.poisson_disc_samples(1.0, 1.0, radius))
    return PointSet(np.clip(points, 0, np.nextafter(1, 0)), Box(torus=False), "bridson", radius)
