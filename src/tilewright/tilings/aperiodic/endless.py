"""The endless tiling that goes with an aperiodic set, told by its tiles."""

import warnings
from collections.abc import Callable
from contextlib import suppress
from functools import cache

from tilewright.errors import TilewrightError, TilewrightValueError, TilewrightWarning
from tilewright.seeds import check_seed
from tilewright.tiles import TileSet
from tilewright.tiles.aperiodic import MERGE_TO_24, MERGE_TO_26, MERGE_TO_31, aperiodic_tiles
from tilewright.tiles.blocks import drop_idle
from tilewright.tiles.merging import grouped_subdivision
from tilewright.tiles.tileset import check_tiles
from tilewright.tiles.translations import CONSTRUCTIONS, as_corner_tiles
from tilewright.tilings.aperiodic.beatty import CulikTiling, KariTiling
from tilewright.tilings.aperiodic.golden import AmmannTiling, JeandelRaoTiling
from tilewright.tilings.aperiodic.translated import TranslatedTiling, translated_tiling
from tilewright.tilings.tiling import Tiling

Make = Callable[[TileSet, int], Tiling]
Signature = tuple[str, frozenset[tuple[int, ...]]]
_WANG: dict[str, Make] = {
    "culik-13": CulikTiling,
    "kari-14": KariTiling,
    "ammann-16": AmmannTiling,
    "jeandel-rao-11-4": JeandelRaoTiling,
    "jeandel-rao-11-5": JeandelRaoTiling,
}
_LAGAE_NAMES = (5, 2, 3, 4, 1, 0)
"""What the colors of the horizontal translation of ``"ammann-16"``, mirrored, are in ``"lagae-44"``."""


def aperiodic_tiling(tiles: TileSet, seed: int = 0) -> Tiling:
    """Make an endless tiling by an aperiodic set, evaluated anywhere: it never repeats.

    Parameters
    ----------
    tiles : TileSet
        A set of `aperiodic_tiles`, or one that `as_corner_tiles` makes of such a Wang set, in any order of
        its tiles. `translated_tiling` leads on to further sets, `filled_tiling` tiles a rectangle
        with any set.
    seed : int, optional
        Where in the endless family of its tilings this one lies, 0 to 2^64 - 1; default 0.

    Returns
    -------
    Tiling
        Of the endless plane. By ``"lagae-44"``, which has periodic tilings too, it is one without a period.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The set is none of these, or the seed is out of range.

    Notes
    -----
    Jeandel and Rao's tiles and Ammann's are laid by rotations of a torus (Labbé 2021, 2025), Kari's and
    Culik's by multiples of real numbers (Kari 1996, Culik 1996), corner tiles by the Wang tiles they are of.

    Examples
    --------
    >>> import tilewright as tw
    >>> tiling = tw.aperiodic_tiling(tw.aperiodic_tiles("ammann-16"), seed=5)
    >>> tiling.indices(10**12, -3, 5, 2).shape
    (2, 5)
    """
    check_tiles("tiles", tiles)
    seed = check_seed(seed)
    wanted = _signature(tiles)
    make = next((m for group in (_wang, _named, _translations) if (m := group().get(wanted))), None)
    if make is None:
        raise TilewrightValueError(
            f"no endless tiling is known for the {tiles.name} set of {len(tiles)} {tiles.shape.name} tiles",
            advice=(
                "direct() tiles the plane with complete and compact sets, filled_tiling() a "
                "rectangle with any that can"
            ),
        )
    return make(tiles, seed)


def _signature(tiles: TileSet) -> Signature:
    return tiles.shape.name, frozenset(map(tuple, tiles.slots.tolist()))


@cache
def _wang() -> dict[Signature, Make]:
    return {_signature(aperiodic_tiles(name)): make for name, make in _WANG.items()}


@cache
def _named() -> dict[Signature, Make]:
    grouping = grouped_subdivision(aperiodic_tiles("jeandel-rao-11-4"))
    class_of = {tile: c for c, members in enumerate(grouping.classes) for tile in members}
    centers = [4 + class_of[tile] for tile in range(len(class_of))]
    shared = (*range(4), *centers, 4 + len(grouping.classes))
    made = {
        "jeandel-rao-36": _translated("jeandel-rao-11-5", "rotation"),
        "jeandel-rao-34": _translated("jeandel-rao-11-5", "rotation"),
        "jeandel-rao-31": _translated("jeandel-rao-11-5", "rotation", MERGE_TO_31),
        "jeandel-rao-26": _translated("jeandel-rao-11-5", "diagonal", MERGE_TO_26),
        "jeandel-rao-24": _twice_diagonal,
        "jeandel-rao-37": _translated("jeandel-rao-11-4", "subdivision", shared),
        "lagae-44": _translated("ammann-16", "horizontal", _LAGAE_NAMES, mirrored=True),
    }
    return {_signature(aperiodic_tiles(name)): make for name, make in made.items()}


@cache
def _translations() -> dict[Signature, Make]:
    made = {}
    for name in _WANG:
        for construction in CONSTRUCTIONS:
            with warnings.catch_warnings(), suppress(TilewrightError):  # some fail for some sets
                warnings.simplefilter("ignore", TilewrightWarning)  # some sets have further tilings
                tiles = as_corner_tiles(aperiodic_tiles(name), construction)
                made[_signature(tiles)] = _translated(name, construction)
    return made


def _translated(
    name: str, construction: str, names: tuple[int, ...] | None = None, *, mirrored: bool = False
) -> Make:
    def make(tiles: TileSet, seed: int) -> Tiling:
        wang = _WANG[name](aperiodic_tiles(name), seed)
        return TranslatedTiling(tiles, wang, construction, names, mirrored=mirrored)

    return make


def _twice_diagonal(tiles: TileSet, seed: int) -> Tiling:
    """Corners colored by what blocks of 2 x 2 tiles become, those that occur numbered in their order."""
    wang = _WANG["jeandel-rao-11-5"](aperiodic_tiles("jeandel-rao-11-5"), seed)
    blocks = TranslatedTiling(_blocks_in_use(), wang, "diagonal")
    return TranslatedTiling(tiles, translated_tiling(blocks, "wang"), "diagonal", MERGE_TO_24)


@cache
def _blocks_in_use() -> TileSet:
    return drop_idle(as_corner_tiles(aperiodic_tiles("jeandel-rao-11-5"), "diagonal"))
