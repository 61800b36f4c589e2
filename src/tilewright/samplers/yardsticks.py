"""What Poisson disks are compared with: chance alone, jittered and regular grids, Sobol's sequence.

Lagae 2007, section 6.2.
"""

from math import hypot, prod

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress
from tilewright.samplers.box import Box
from tilewright.samplers.feasibility import check_box, check_count
from tilewright.samplers.point_set import PointSet
from tilewright.seeds import Seed, make_key


def uniform(
    count: int, *, seed: Seed = 0, box: Box | None = None, progress: Progress | None = None
) -> PointSet:
    """Take exactly ``count`` points anywhere, each place equally likely: a Poisson distribution.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default the unit torus.
    progress : callable, optional
        Taken so that all samplers are called alike; the work is too short to report.

    Returns
    -------
    PointSet
        Nothing is promised about distances.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    Lagae 2007, section 4.2.1.
    """
    domain = check_box(box)
    n = check_count(count, 16 * domain.dimension)
    return PointSet(_scale(_draw(n, domain, seed), domain), domain, "uniform")


def jittered(
    count: int, *, seed: Seed = 0, box: Box | None = None, progress: Progress | None = None
) -> PointSet:
    """Take exactly ``count`` points, one anywhere in each of as many parts of equal area.

    Where ``count`` makes no grid of nearly square cells, some rows have one cell more than others; their
    heights are such that all cells have the same area.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default the unit torus.
    progress : callable, optional
        Taken so that all samplers are called alike; the work is too short to report.

    Returns
    -------
    PointSet
        Row by row; nothing is promised about distances.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    Cook 1986; Lagae 2007, section 6.2.
    """
    domain = check_box(box)
    n = check_count(count, 64 * domain.dimension)
    low, size = _strata(n, domain.extent)
    points = low + size * _draw(n, domain, seed)
    return PointSet(np.minimum(points, np.nextafter(domain.extent, 0)), domain, "jittered")


def sobol(
    count: int, *, seed: Seed = 0, box: Box | None = None, progress: Progress | None = None
) -> PointSet:
    """Take the first ``count`` points of Sobol's sequence, scrambled.

    In planes, where ``count`` is a power of two every binary division of the box into as many equal parts
    has one point in each part.

    Parameters
    ----------
    count : int
        Number of points, 1 to 2^31 - 1.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default the unit torus.
    progress : callable, optional
        Taken so that all samplers are called alike; the work is too short to report.

    Returns
    -------
    PointSet
        In the order of the sequence; nothing is promised about distances.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    Sobol 1967, with the scrambling of Owen 1995.
    """
    from scipy.stats.qmc import Sobol

    from tilewright.kernels.scatter import scramble_words

    domain = check_box(box)
    n = check_count(count, 64 * domain.dimension)
    key = make_key(seed)
    plain = Sobol(domain.dimension, scramble=False, bits=32).random_base2((n - 1).bit_length())[:n]
    words = (plain * 2.0**32).astype(np.uint32)
    scramble_words(key, words)
    return PointSet(_scale(words * 2.0**-32, domain), domain, "sobol")


def regular(
    count: int, *, seed: Seed = 0, box: Box | None = None, progress: Progress | None = None
) -> PointSet:
    """Take about ``count`` points of a grid with nearly square cells, shifted by chance.

    Parameters
    ----------
    count : int
        About how many points, 1 to 2^31 - 1.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain; by default the unit torus.
    progress : callable, optional
        Taken so that all samplers are called alike; the work is too short to report.

    Returns
    -------
    PointSet
        Row by row; its ``distance`` is the shorter side of a cell.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range.

    Notes
    -----
    Lagae 2007, section 6.2.
    """
    domain = check_box(box)
    n = check_count(count, 64 * domain.dimension)
    counts = _divide(n, domain.extent)
    spacing = np.array(domain.extent) / counts
    cells = np.stack(np.unravel_index(np.arange(prod(counts)), counts), axis=1)
    points = (cells + _draw(1, domain, seed)) * spacing
    points = np.minimum(points, np.nextafter(domain.extent, 0))
    return PointSet(points, domain, "regular", float(spacing.min()))


def hexagonal(
    count: int, *, seed: Seed = 0, box: Box | None = None, progress: Progress | None = None
) -> PointSet:
    """Take about ``count`` points of a lattice of nearly equilateral triangles, shifted by chance.

    The rows are even in number, so that the lattice goes on around a torus.

    Parameters
    ----------
    count : int
        About how many points, 1 to 2^31 - 1.
    seed : int or numpy.random.Generator, optional
        Where chance begins: 0 to 2^64 - 1, or a generator, which is drawn from; default 0.
    box : Box, optional
        The domain, a plane one; by default the unit torus.
    progress : callable, optional
        Taken so that all samplers are called alike; the work is too short to report.

    Returns
    -------
    PointSet
        Row by row; its ``distance`` is that of nearest points.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The box is not a plane, or a number is out of range.

    Notes
    -----
    Lagae 2007, section 4.2.3.
    """
    domain = check_box(box, plane="the hexagonal lattice")
    n = check_count(count, 64 * domain.dimension)
    width, height = domain.extent
    rows = 2 * max(1, min(n // 2, round((n * height / width / np.sqrt(3) * 2) ** 0.5 / 2)))
    columns = max(1, round(n / rows))
    rows = 2 * max(1, round(n / columns / 2))
    x, y = width / columns, height / rows
    row, column = np.divmod(np.arange(rows * columns), columns)
    shift = _draw(1, domain, seed)[0]
    along = (column + row % 2 / 2 + shift[0]) / columns % 1
    points = _scale(np.stack([along, (row + shift[1]) / rows], axis=1), domain)
    return PointSet(points, domain, "hexagonal", min(x, 2 * y, hypot(x / 2, y)))


def _draw(count: int, box: Box, seed: Seed) -> NDArray[np.float64]:
    """Numbers of [0, 1), one row for each point."""
    from tilewright.kernels.scatter import fill_units

    units = np.empty((count, box.dimension))
    fill_units(make_key(seed), 0, units)
    return units


def _scale(units: NDArray[np.float64], box: Box) -> NDArray[np.float64]:
    """Points of the unit square or cube, stretched to a box; rounding never leaves it."""
    return np.minimum(units * box.extent, np.nextafter(box.extent, 0))


def _divide(count: int, extent: tuple[float, ...]) -> list[int]:
    """Cells along each axis of a grid with about ``count`` nearly square cells."""
    side = (prod(extent) / count) ** (1 / len(extent))
    counts: list[int] = []
    for e in extent[:-1]:
        counts.append(max(1, min(round(e / side), count // prod(counts))))
    return [*counts, max(1, round(count / prod(counts)))]


def _strata(count: int, extent: tuple[float, ...]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Low corners and sizes of ``count`` boxes of equal volume that fill a box, shapes (count, d)."""
    *rest, last = extent
    if not rest:
        size = np.full((count, 1), last / count)
        return np.arange(count)[:, np.newaxis] * size, size
    side = (prod(extent) / count) ** (1 / len(extent))
    slabs = max(1, min(count, round(last / side)))
    shares = np.diff(np.arange(slabs + 1) * count // slabs)
    parts = {share: _strata(share, tuple(rest)) for share in set(shares.tolist())}
    lows, sizes = [], []
    for before, share in zip(np.cumsum(shares) - shares, shares.tolist(), strict=True):
        low, size = parts[share]
        lows.append(np.column_stack([low, np.full(share, last * before / count)]))
        sizes.append(np.column_stack([size, np.full(share, last * share / count)]))
    return np.concatenate(lows), np.concatenate(sizes)
