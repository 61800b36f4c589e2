"""From a photograph's character to how its texture is made: tile set, tile size, tone, manner of search."""

import warnings
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import minimum_filter

from tilewright.errors import TilewrightValueError, TilewrightWarning
from tilewright.signals.textures.bond import ALL_ALIKE, Bond
from tilewright.signals.textures.character import Character
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.manner import NESTED, Manner
from tilewright.signals.textures.regularity import Regularity
from tilewright.signals.textures.rhythm import Rhythm
from tilewright.signals.textures.tone import TONED
from tilewright.tiles import TileSet, classed_corner_tiles, corner_tiles

SMALLEST_TILE, USUAL_TILE, LARGEST_TILE = 16, 128, 1024
LARGER = 1.5
"""Tiles of things and of courses over those of other photographs: large things stay whole."""
WIDER = 1.25
"""Tiles of even photographs over the usual ones, up to `USUAL_TILE`. Two blind looks at six photographs gave
7.0 near and 7.1 from afar, in place of 6.2 and 6.8 at the usual size: less is cut, and twins lie farther
apart. At 1.5 they gave 6.9 and 6.9, as what is in rows shows from afar. Larger tiles would take too long."""
FITTING = 0.004
"""The same below which no size fits better than another, so that the nearest to the usual one is taken."""
CANDIDATES = 8
"""Places that are cut in before the cheapest is kept; of twice as many tiles none is seen as often."""
EXCLUSION = 0.42
"""Places nearer than this to one that shows in the same tile are not taken, in tiles: nothing shows twice."""
RECURRENCE, RECURRENCE_OF_THINGS = 0.17, 0.05
"""What every older pixel costs that a patch leaves, and the same where things or courses shall stay whole."""
BREADTH, EASE = 8.0, 1.0
"""How much more the color of things counts than their grain, and how much less a seam along their outlines,
where there are things or courses."""
CORE, CORE_OF_BONDS = 0.18, 0.12
"""Half-width of what a center patch must fill, in tiles, where there are things or courses, and where there
are courses along both axes. Of a parquet of long planks, 8 in 100 pixels along cuts change color in a plank
at 0.30, as planks across a border are longer than what is left to them there, and 1 at 0.12. The smaller it
is, the oftener the same is seen: of a wall, 1.9 times on the photograph's area at 0.18, and 2.4 at 0.12."""
FEWEST_CORNERS = 8
"""Colors of corners from which on edges have no patches of their own where there are things or courses."""
ROOM = 2
"""Side of a square of usable pixels, in tiles, from which on that is so: corner patches then take more."""
MOST_PIXELS = 2**25
"""Sets of more get two classes of lattice points in place of five, as large tiles come less often."""
OFF_STEP = 0.04
"""Share of a course by which a tile may miss a whole number of courses and still keep step with them."""


@dataclass(frozen=True, eq=False)
class Treatment:
    """How a texture is made.

    Attributes
    ----------
    name : str
        ``"courses"``: patches keep step with the courses of the photograph; ``"things"``: tiles large enough
        for things; ``"even"``: neither.
    tiles : TileSet
        What may meet.
    tile_size : int
        Pixels along a tile.
    tone : bool
        Whether tone is laid outside the tiles.
    manner : Manner
        How patches are chosen.
    """

    name: str
    tiles: TileSet
    tile_size: int
    tone: bool
    manner: Manner

    @property
    def bars_lone_things(self) -> bool:
        """Whether patches that come often must not show what is seldom."""
        return self.manner.jointly and not all(self.manner.rhythm)

    def period(self, regularity: Regularity) -> float | None:
        """The period below which like places must not be barred, in pixels."""
        if not self.manner.jointly:
            return regularity.shortest_period
        rows, columns = self.manner.rhythm
        return min(rows.period, columns.period) if rows and columns else None


def usual_size(exemplar: Exemplar) -> int:
    """Pixels along a tile that go with a photograph's size: 128 for 512 to 1,448 pixels, 512 for 4,096."""
    side = min(min(m.shape) for m in exemplar.masks)
    if side < 4 * USUAL_TILE:
        return max(SMALLEST_TILE, 2 ** int(np.log2(side / 4)))
    return min(LARGEST_TILE, max(USUAL_TILE, 2 ** round(np.log2(side / 8))))


def find_treatment(
    exemplar: Exemplar, character: Character, tiles: TileSet | None, tile_size: int | None, tone: bool | None
) -> Treatment:
    """Decide what was not given.

    Parameters
    ----------
    tiles : TileSet or None
        The set that was asked for.
    tile_size : int or None
        Pixels along a tile, as asked for.
    tone : bool or None
        Whether tone lies outside the tiles, as asked for.
    """
    usual = usual_size(exemplar)
    _check_tone(tone, exemplar)
    alone = len(exemplar.sources) == 1
    if tone is None:
        tone = alone and character.has_tone and _can_have_tone(exemplar)
    if not alone:
        # Two plain colors and two marked ones: of fewer, a region of one photograph has too few tiles.
        tiles = tiles or corner_tiles(4)
    rhythm = _kept(character.rhythm, tile_size) if alone else (None, None)
    if any(rhythm):
        both = all(rhythm)
        bond = character.bond if both else ALL_ALIKE
        size = tile_size or _size_of_courses(rhythm, bond, usual if both else round(LARGER * usual))
        tiles = tiles or _classed(size)
        bond = _kept_bond(bond, rhythm, size, most=min(min(m.shape) for m in exemplar.masks) // 2)
        plainness = (0.0, 0.0, 0.0) if both else (1.0, 0.7, 0.3)
        manner = replace(
            _keep_whole(tiles, size, exemplar, CORE_OF_BONDS if both else CORE),
            plainness=plainness,
            popping=0.0 if both else 1.0,
            rhythm=rhythm,
            bond=bond,
        )
        return Treatment("courses", tiles, size, tone, manner)
    if character.has_things and not tone:
        size = tile_size or 2 * round(LARGER * usual / 2)
        tiles = tiles or _classed(size)
        whole = _keep_whole(tiles, size, exemplar, CORE)
        manner = replace(whole, plainness=(0.5, 0.3, 0.15), popping=1.0)
        return Treatment("things", tiles, size, tone, manner)
    wider = round(WIDER * usual) if tiles is None and SMALLEST_TILE < usual <= USUAL_TILE else usual
    size = tile_size or wider
    manner = Manner(CANDIDATES, EXCLUSION, (1.0, 0.7, 0.3), 1.0, RECURRENCE, True)
    return Treatment("even", tiles or _classed(size), size, tone, manner)


def _classed(size: int) -> TileSet:
    """Tiles in five classes, or in two where these would be too many pixels."""
    tiles = classed_corner_tiles(2, 5)
    return tiles if len(tiles) * size**2 <= MOST_PIXELS else classed_corner_tiles(2, 2)


def _keep_whole(tiles: TileSet, size: int, exemplar: Exemplar, core: float) -> Manner:
    """What keeps things and courses whole: cuts along outlines, and as few of them as the set allows."""
    plain = _has_plain_edges(tiles, size, exemplar)
    return Manner(
        CANDIDATES,
        EXCLUSION,
        recurrence=RECURRENCE_OF_THINGS,
        jointly=True,
        breadth=BREADTH,
        ease=EASE,
        core=core if plain else NESTED.core,
        plain_edges=plain,
    )


def _has_plain_edges(tiles: TileSet, size: int, exemplar: Exemplar) -> bool:
    """Whether corner patches come so seldom that edges need none of their own to hide that they come back.

    These cost a second cut across every border, and cut what is whole in a corner patch. Edges that differ in
    color, or lie between two photographs, have patches of their own.
    """
    many = "N" not in tiles.shape.slots and max(tiles.colors) >= FEWEST_CORNERS
    if not many or len(exemplar.sources) > 1:
        return False
    return bool(minimum_filter(exemplar.masks[0], ROOM * size, mode="constant", cval=0).any())


def _can_have_tone(exemplar: Exemplar) -> bool:
    return any(kind in TONED for kind in exemplar.kinds.values())


def _check_tone(tone: bool | None, exemplar: Exemplar) -> None:
    """Refuse tone where there can be none."""
    if not tone:
        return
    if len(exemplar.sources) > 1:
        raise TilewrightValueError(
            f"is True, and tone is that of one photograph; {len(exemplar.sources)} were given",
            argument="tone",
            value=tone,
        )
    if not _can_have_tone(exemplar):
        kinds = ", ".join(f"{name} ({kind})" for name, kind in exemplar.kinds.items())
        raise TilewrightValueError(
            f"is True, and none of the maps holds color, roughness or heights: {kinds}",
            argument="tone",
            value=tone,
        )


def _kept(
    rhythm: tuple[Rhythm | None, Rhythm | None], size: int | None
) -> tuple[Rhythm | None, Rhythm | None]:
    """Rhythms that tiles of a size keep step with; said where one does not."""
    rows, columns = (_in_step(r, size, what) for r, what in zip(rhythm, ("rows", "columns"), strict=True))
    return rows, columns


def _in_step(rhythm: Rhythm | None, size: int | None, what: str) -> Rhythm | None:
    if rhythm is None or size is None:
        return rhythm
    courses = max(1, round(size / rhythm.period))
    if abs(size / courses - rhythm.period) <= max(OFF_STEP * rhythm.period, 1):
        return rhythm
    below = max(1, int(size / rhythm.period))
    fits = [2 * round(n * rhythm.period / 2) for n in (below, below + 1)]
    warnings.warn(
        f"the {what} of the photograph repeat every {rhythm.period:.0f} pixels, and tile_size {size} is no "
        f"whole number of them: they are cut where they come; {' or '.join(map(str, fits))} keeps them whole",
        TilewrightWarning,
        stacklevel=5,
    )
    return None


def _kept_bond(bond: Bond, rhythm: tuple[Rhythm | None, Rhythm | None], size: int, most: int) -> Bond:
    """The bond if tiles of a size keep it; where they do not, it is said which sizes up to ``most`` do."""
    if _fits(bond, rhythm, np.array([size])).all():
        return bond
    sizes = np.arange(SMALLEST_TILE, min(most, LARGEST_TILE) + 1, 2)
    off = sum(np.abs(sizes / r.period - np.rint(sizes / r.period)) for r in rhythm if r)
    fits = sizes[_fits(bond, rhythm, sizes) & (off <= OFF_STEP)]
    nearest = sorted(fits[np.argsort(np.abs(fits - size))][:2])
    advice = f"; tile_size {' or '.join(map(str, nearest))} keeps it" if nearest else ""
    warnings.warn(
        f"one of {bond.size} crossings of the photograph's rows and columns is like another, and tiles of "
        f"{size} pixels do not keep to these: its pattern breaks between them{advice}",
        TilewrightWarning,
        stacklevel=4,
    )
    return ALL_ALIKE


def _fits(
    bond: Bond, rhythm: tuple[Rhythm | None, Rhythm | None], sizes: NDArray[np.int64]
) -> NDArray[np.bool_]:
    """Whether tiles of these sizes hold as many courses as keep a bond."""
    if bond.size == 1:
        return np.ones(len(sizes), bool)
    i, j = (np.maximum(1, np.rint(sizes / r.period)).astype(np.int64) for r in rhythm if r)
    return bond.fits(i, j)


def _size_of_courses(rhythm: tuple[Rhythm | None, Rhythm | None], bond: Bond, about: int) -> int:
    """The even size near ``about`` that is nearest to a whole number of courses along each axis.

    Of sizes that keep the bond, where there are any.
    """
    sizes = np.arange(max(SMALLEST_TILE, about * 5 // 8 // 2 * 2), min(LARGEST_TILE, about * 2) + 1, 2)
    kept = _fits(bond, rhythm, sizes)
    sizes = sizes[kept] if kept.any() else sizes
    cost = 0.1 * np.abs(np.log2(sizes / about))
    for course in filter(None, rhythm):
        count = np.maximum(1, np.round(sizes / course.period))
        cost = cost + np.maximum(np.abs(sizes / count / course.period - 1), FITTING)
    return int(sizes[np.argmin(cost)])


def plain_treatment(tiles: TileSet, size: int | None, tone: bool | None) -> Treatment:
    """What the older methods do with any photograph."""
    if tone:
        raise TilewrightValueError(
            "is True, and only method 'faithful' lays tone outside the tiles", argument="tone", value=tone
        )
    return Treatment("", tiles, size or USUAL_TILE, False, NESTED)
