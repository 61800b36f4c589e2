"""Point tiles that come with the package, so that points need no construction."""

from importlib.resources import as_file, files

from tilewright.checks import check_int
from tilewright.errors import TilewrightValueError
from tilewright.files.tileset_folder import load_points
from tilewright.signals.points import PointTiles

READY = ((4, 32, 0.75), (4, 32, 0.70), (3, 32, 0.75), (4, 64, 0.75), (6, 32, 0.70))
"""Colors, points per tile and rho of the sets that come with the package."""


def ready_tiles(colors: int = 4, points: int = 32, rho: float = 0.75) -> PointTiles:
    """Give balanced point tiles with colored corners that are stored with the package.

    They were made by `poisson_tiles`; of eight seeds the one with the lowest spikes was kept, and ``recipe``
    names it. There are sets of (colors, points, rho) (4, 32, 0.75), (4, 32, 0.70), (3, 32, 0.75), (4, 64,
    0.75) and (6, 32, 0.70).

    Parameters
    ----------
    colors : int, optional
        Corner colors: 3, 4 or 6; default 4.
    points : int, optional
        Points per tile: 32 or 64; default 32.
    rho : float, optional
        Relative radius: 0.70 or 0.75; default 0.75.

    Returns
    -------
    PointTiles
        colors^4 tiles with ranks, ``figures`` and ``recipe``.

    Raises
    ------
    TilewrightTypeError
        A number of colors or points that is not an integer.
    TilewrightValueError
        There is no such set; the message names those there are.

    Examples
    --------
    >>> import tilewright as tw
    >>> blue = tw.ready_tiles()
    >>> len(blue.tiles), blue.density, round(blue.distance, 3)
    (256, 32.0, 0.142)
    """
    wanted = (check_int("colors", colors, 1, 16), check_int("points", points, 1, 10**6), float(rho))
    if wanted not in READY:
        known = "; ".join(f"{c}, {n}, {r:.2f}" for c, n, r in READY)
        raise TilewrightValueError(
            f"no set of {colors} colors, {points} points and rho {rho} comes with the package",
            allowed=known,
            advice=f"there are {known}, and poisson_tiles() makes any other",
        )
    with as_file(files("tilewright.files") / "stored_tiles" / folder_name(*wanted)) as folder:
        return load_points(folder)


def folder_name(colors: int, points: int, rho: float) -> str:
    """Where a set lies below the package's folder of sets."""
    return f"corner-{colors}-{points}-{round(100 * rho)}"
