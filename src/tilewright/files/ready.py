"""Point tiles that come with the package, so that points need no construction."""

from importlib.resources import as_file, files

from tilewright.checks import check_int
from tilewright.errors import TilewrightValueError
from tilewright.files.tileset_folder import load_points
from tilewright.signals.points import PointTiles

READY = ((4, 32, 0.75), (4, 32, 0.70), (3, 32, 0.75), (4, 64, 0.75), (6, 32, 0.70))
"""Colors, points per tile and rho of the sets that come with the package."""


def ready_tiles(colors: int = 4, points: int = 32, rho: float = 0.75) -> PointTiles:
    """Balanced corner-based point tiles that are stored with the package.

    They were made by `poisson_tiles`; of eight seeds the one with the lowest spikes, which ``recipe`` tells.

    Parameters
    ----------
    colors, points, rho
        One of `READY`: (4, 32, 0.75), (4, 32, 0.70), (3, 32, 0.75), (4, 64, 0.75), (6, 32, 0.70).

    Raises
    ------
    TilewrightValueError
        There is no such set; the message names those there are.
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
