"""Aperiodic sets: they tile the plane, but never with a period. And one that was thought to be such.

Published Wang sets are tables; corner sets are derived from them here by the constructions of Lagae 2007,
chapter 8, and by merging colors. Each says where it is from and how far its claim is proven.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np

from tilewright.checks import check_choice
from tilewright.errors import TilewrightValueError
from tilewright.tiles.blocks import drop_idle
from tilewright.tiles.listed import ListedTileSet
from tilewright.tiles.merging import grouped_subdivision, merge_colors
from tilewright.tiles.shape import CORNER, WANG
from tilewright.tiles.tileset import CUSTOM, Family, TileSet
from tilewright.tiles.translations import as_corner_tiles, as_wang_tiles

Table = tuple[tuple[int, int, int, int], ...]


@dataclass(frozen=True)
class AperiodicSet:
    """A named set of this module.

    Attributes
    ----------
    name : str
    status : str
        How far it is known to be aperiodic: proven, by whom; computer-checked; or not aperiodic at all.
    source : str
        Where its tiles are from.
    make : callable
        The set itself; see `aperiodic_tiles`.
    """

    name: str
    status: str
    source: str
    make: Callable[[], TileSet]


def aperiodic_tiles(name: str = "jeandel-rao-11-5") -> TileSet:
    """Give an aperiodic set by its name; `APERIODIC_SETS` tells sources, and what is proven of each.

    Parameters
    ----------
    name : str, optional
        Wang sets, slots N, E, S, W: ``"culik-13"``, ``"kari-14"``, ``"ammann-16"``, ``"jeandel-rao-11-4"``,
        ``"jeandel-rao-11-5"``, the default. Corner sets, slots NE, SE, SW, NW: ``"jeandel-rao-36"``
        (rotation), ``"jeandel-rao-34"``, ``"jeandel-rao-37"`` (subdivision), ``"jeandel-rao-31"``,
        ``"jeandel-rao-26"``, ``"jeandel-rao-24"``, and ``"lagae-44"``, which was published as aperiodic and
        is not.

    Returns
    -------
    TileSet
        The set; its name says where it is not aperiodic.

    Raises
    ------
    TilewrightValueError
        There is no such set, or only its size was published.

    Notes
    -----
    Lagae 2007, sections 8.2 and 8.3. The sets of Jeandel & Rao 2015 are younger than the thesis, and so are
    the corner sets made from them; `APERIODIC_SETS` says which of these rest on a check by computer that
    nobody has reviewed.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.aperiodic_tiles("jeandel-rao-11-5")
    <TileSet jeandel-rao-11-5: 11 wang tiles, colors (5, 4, 5, 4)>
    >>> tw.APERIODIC_SETS["kari-14"].status
    'aperiodic, proven by Kari 1996'
    """
    if isinstance(name, str) and name in PUBLISHED_ONLY:
        raise TilewrightValueError(
            f"is {name!r}; of this set only its size is known here: nobody's transcription of its tiles "
            f"was found. Allowed are {', '.join(APERIODIC_SETS)}",
            argument="name",
            value=name,
        )
    return _make(check_choice("name", name, tuple(APERIODIC_SETS)))


@cache
def _make(name: str) -> TileSet:
    listed = APERIODIC_SETS[name]
    made = listed.make()
    family = CUSTOM if listed.status.startswith("NOT") else Family("aperiodic", {"name": name})
    return ListedTileSet(made.shape, made.slots, made.colors, made.name, family=family)


PUBLISHED_ONLY = ("ammann-24", "penrose-32")
"""The sets 24/24 and 32/16 of Lagae 2007, figures 8.2 and 8.1: rows of tables, without tiles."""

# Columns N, E, S, W.
_CULIK: Table = (
    (0, 1, 1, 1), (3, 1, 4, 1), (0, 2, 3, 1), (1, 2, 3, 1), (0, 2, 1, 2), (3, 2, 4, 2), (3, 1, 3, 2),
    (4, 3, 3, 0), (3, 4, 3, 0), (4, 4, 3, 3), (3, 0, 0, 3), (4, 0, 0, 4), (3, 3, 0, 4),
)  # fmt: skip
_KARI: Table = (
    (1, 0, 2, 0), (1, 1, 1, 0), (0, 0, 1, 1), (1, 1, 2, 1), (2, 2, 1, 3), (2, 4, 1, 2), (2, 5, 1, 4),
    (2, 3, 2, 4), (2, 2, 2, 5), (1, 3, 1, 2), (1, 2, 1, 4), (1, 4, 1, 5), (1, 4, 0, 3), (1, 5, 0, 2),
)  # fmt: skip
_AMMANN: Table = (
    (3, 4, 1, 5), (1, 4, 0, 4), (3, 5, 2, 5), (5, 5, 4, 4), (2, 4, 0, 5), (1, 2, 3, 2), (2, 2, 3, 3),
    (5, 3, 5, 2), (0, 1, 2, 1), (1, 1, 2, 2), (2, 1, 2, 3), (4, 1, 4, 0), (0, 0, 1, 1), (1, 0, 1, 2),
    (4, 2, 5, 0), (4, 3, 5, 1),
)  # fmt: skip
_JEANDEL_RAO: Table = (
    (4, 2, 1, 2), (2, 2, 0, 2), (1, 1, 1, 3), (2, 1, 2, 3), (1, 3, 3, 3), (1, 0, 1, 3), (0, 0, 1, 0),
    (1, 3, 2, 0), (2, 0, 2, 1), (2, 1, 4, 1), (3, 3, 2, 1),
)  # fmt: skip

# Columns NW, NE, SE, SW.
_LAGAE: Table = (
    (0, 4, 2, 1), (0, 3, 5, 1), (0, 2, 5, 1), (2, 3, 4, 3), (2, 2, 4, 3), (2, 1, 0, 3), (3, 1, 0, 4),
    (3, 0, 0, 4), (5, 2, 3, 2), (5, 3, 3, 2), (5, 5, 3, 2), (5, 1, 1, 2), (3, 1, 0, 3), (3, 0, 0, 3),
    (5, 2, 3, 3), (5, 3, 3, 3), (5, 5, 3, 3), (5, 1, 1, 3), (2, 3, 4, 4), (2, 2, 4, 4), (2, 1, 0, 4),
    (2, 3, 4, 2), (2, 2, 4, 2), (2, 1, 0, 2), (4, 0, 1, 2), (4, 4, 3, 2), (3, 0, 1, 5), (3, 4, 3, 5),
    (4, 0, 1, 3), (4, 4, 3, 3), (2, 4, 2, 5), (2, 3, 5, 5), (2, 2, 5, 5), (1, 5, 2, 0), (1, 2, 2, 0),
    (1, 2, 3, 0), (1, 3, 3, 0), (1, 5, 3, 0), (1, 1, 1, 0), (1, 5, 2, 1), (1, 2, 2, 1), (0, 3, 4, 0),
    (0, 2, 4, 0), (0, 1, 0, 0),
)  # fmt: skip

MERGE_TO_31 = (0, 1, 2, 0, 0, 3, 0, 3, 1)
"""The 4 colors of ``"jeandel-rao-31"`` that the 9 of ``"jeandel-rao-34"`` become."""
MERGE_TO_26 = (0, 1, 0, 2, 1, 0, 0, 3, 3, 2, 3)
"""The 4 colors of ``"jeandel-rao-26"`` that the 11 tiles of ``"jeandel-rao-11-5"`` become."""
MERGE_TO_24 = (
    0, 1, 0, 0, 1, 1, 1, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 3, 3, 3, 3, 3, 2, 2, 2, 2, 2,
    2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 0, 0, 0, 0, 1, 1, 1, 3, 3, 3, 3, 3,
)  # fmt: skip
"""The 4 colors of ``"jeandel-rao-24"`` that the 55 blocks of 2 x 2 tiles of ``"jeandel-rao-11-5"`` become."""


def _wang(name: str, table: Table) -> Callable[[], TileSet]:
    return lambda: ListedTileSet(WANG, table, name=name)


def _four_colors() -> TileSet:
    """Jeandel and Rao's second set: color 4 of the first becomes 0, on N and S edges."""
    n, e, s, w = np.array(_JEANDEL_RAO).T
    return ListedTileSet(WANG, np.stack([n % 4, e, s % 4, w], axis=1), name="jeandel-rao-11-4")


def _lagae() -> TileSet:
    slots = np.roll(_LAGAE, -1, axis=1)  # NW, NE, SE, SW -> NE, SE, SW, NW
    return ListedTileSet(CORNER, slots, name="lagae-44 (not aperiodic)")


def _rotated() -> TileSet:
    made = as_corner_tiles(aperiodic_tiles("jeandel-rao-11-5"), "rotation")
    return ListedTileSet(CORNER, made.slots, made.colors, "jeandel-rao-36")


def _rotated_in_use() -> TileSet:
    return drop_idle(_rotated(), name="jeandel-rao-34")


def _grouped() -> TileSet:
    made = grouped_subdivision(aperiodic_tiles("jeandel-rao-11-4")).tiles
    return ListedTileSet(CORNER, made.slots, made.colors, "jeandel-rao-37")


def _merged_rotation() -> TileSet:
    return merge_colors(_rotated_in_use(), MERGE_TO_31, "jeandel-rao-31")


def _diagonal_in_use() -> TileSet:
    return drop_idle(as_corner_tiles(aperiodic_tiles("jeandel-rao-11-5"), "diagonal"))


def _merged_diagonal() -> TileSet:
    return merge_colors(_diagonal_in_use(), MERGE_TO_26, "jeandel-rao-26")


def _merged_twice_diagonal() -> TileSet:
    twice = drop_idle(as_corner_tiles(as_wang_tiles(_diagonal_in_use()), "diagonal"))
    return merge_colors(twice, MERGE_TO_24, "jeandel-rao-24")


_LISTED = (
    AperiodicSet(
        "culik-13",
        "aperiodic, proven by Culik 1996",
        "Culik 1996, Discrete Math. 160:245-251; two transcriptions of Jeandel & Rao 2015, fig. 1, agree; "
        "every tile obeys q S + W = N + E with q = 1/2 or 3",
        _wang("culik-13", _CULIK),
    ),
    AperiodicSet(
        "kari-14",
        "aperiodic, proven by Kari 1996",
        "Kari 1996, Discrete Math. 160:259-264, fig. 1, from a public transcription; every tile obeys "
        "q N + W = S + E with q = 2 or 2/3",
        _wang("kari-14", _KARI),
    ),
    AperiodicSet(
        "ammann-16",
        "aperiodic, proven by Grünbaum & Shephard 1986 (chapter 11), again by Labbé 2023",
        "Grünbaum & Shephard 1986, page 595; values as Labbé 2023 (arXiv:2312.03652), T_1; a second "
        "transcription is the same up to the names of colors",
        _wang("ammann-16", _AMMANN),
    ),
    AperiodicSet(
        "jeandel-rao-11-4",
        "aperiodic, proven by Jeandel & Rao 2015 (with a computer); no smaller Wang set is",
        "Jeandel & Rao 2015 (arXiv:1506.06492), fig. 4; the set of fig. 3 with color 4 replaced by 0",
        _four_colors,
    ),
    AperiodicSet(
        "jeandel-rao-11-5",
        "aperiodic, proven by Jeandel & Rao 2015 (with a computer); no smaller Wang set is",
        "Jeandel & Rao 2015 (arXiv:1506.06492), fig. 3; two transcriptions agree",
        _wang("jeandel-rao-11-5", _JEANDEL_RAO),
    ),
    AperiodicSet(
        "jeandel-rao-36",
        "aperiodic: Lagae 2007, section 8.3.3, applied to a proven set",
        "rotation of jeandel-rao-11-5",
        _rotated,
    ),
    AperiodicSet(
        "jeandel-rao-34",
        "aperiodic: jeandel-rao-36 without two tiles that none of its tilings has; that is computer-checked, "
        "unreviewed, see drop_idle",
        "jeandel-rao-36 with the 23 vertices that Labbé's tilings have (2019, arXiv:1903.06137)",
        _rotated_in_use,
    ),
    AperiodicSet(
        "jeandel-rao-37",
        "aperiodic: Lagae 2007, section 8.3.4, applied to a proven set; the grouping is computer-checked, "
        "unreviewed",
        "subdivision of jeandel-rao-11-4 with tiles that share center colors",
        _grouped,
    ),
    AperiodicSet(
        "jeandel-rao-31",
        "computer-checked, unreviewed: every tiling lifts to one of jeandel-rao-34, see check_lifting",
        "jeandel-rao-34 with 9 colors merged to 4",
        _merged_rotation,
    ),
    AperiodicSet(
        "jeandel-rao-26",
        "computer-checked, unreviewed: every tiling lifts to one of jeandel-rao-11-5, see check_lifting",
        "diagonal translation of jeandel-rao-11-5 without tiles that none of its tilings has, its 11 colors "
        "merged to 4",
        _merged_diagonal,
    ),
    AperiodicSet(
        "jeandel-rao-24",
        "computer-checked, unreviewed: every tiling lifts to one of jeandel-rao-11-5, see check_lifting; the "
        "smallest set in the literature has 30 tiles (Nurmi 2016)",
        "diagonal translation of jeandel-rao-11-5, applied twice, without tiles that no tiling has; its 55 "
        "colors, which are blocks of 2 x 2 tiles, merged to 4 by the two tiles on their west side",
        _merged_twice_diagonal,
    ),
    AperiodicSet(
        "lagae-44",
        "NOT aperiodic: it tiles with period 2 x 3, see docs/aperiodic.md; published as aperiodic",
        "Lagae 2007, fig. 8.6 (first in Lagae, Kari & Dutré 2006), from a public transcription",
        _lagae,
    ),
)
APERIODIC_SETS = {listed.name: listed for listed in _LISTED}
"""The sets by name, as `AperiodicSet`."""
