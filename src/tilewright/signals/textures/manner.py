"""How patches are chosen: what the photograph's character asks of the search."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tilewright.signals.textures.bond import ALL_ALIKE, Bond
from tilewright.signals.textures.rhythm import Rhythm


@dataclass(frozen=True, eq=False)
class Manner:
    """Settings of the search, and what it must not do; as they stand, those of method ``"nested"``.

    Attributes
    ----------
    candidates : int
        Places that are cut in before the cheapest is kept.
    exclusion : float
        Places nearer than this to one that shows in the same tile are not taken, in tiles.
    plainness : (float, float, float)
        How much a conspicuous place is marked down, for corner, edge and center patches.
    popping : float
        How much a corner patch is marked down for the thing in it that pops out most, over what is usual.
    recurrence : float
        What every older pixel costs that a patch leaves, in steps between neighboring pixels.
    jointly : bool
        Whether corner patches are chosen for the pairs that can meet, each again and again, or one after
        another for all pairs. Candidates are then drafted, too: see ``search.py``.
    rhythm : (Rhythm or None, Rhythm or None)
        Courses of rows and of columns that patches keep in step with.
    bond : Bond
        Which crossings of these are alike: patches keep in step with them, too.
    breadth : float
        How much more the color of a thing counts than its grain: see `make_sheet`.
    ease : float
        How much less a seam counts along outlines: see `Patchwork.overlay`.
    core : float
        Half-width of the part a center patch must fill, in tiles. At 0.15 steps across the cuts of smooth
        noise are as at 0.30 (see ``nested.py``), but 0.24 is shared by two cells and not 0.18; at 0.40 steps
        are 1.49 times those elsewhere and not 1.36, and 0.14 is shared.
    plain_edges : bool
        Whether corner patches are cut against each other along edges, and no patches of the edges' own lie
        over these cuts.
    lone : bool array, shape of the sheet, or None
        Pixels that corner and edge patches must not show.
    shows : int
        How many center patches may show one of these things.
    """

    candidates: int = 16
    exclusion: float = 0.22
    plainness: tuple[float, float, float] = (3.0, 0.7, 0.3)
    popping: float = 0.0
    recurrence: float = 0.17
    jointly: bool = False
    rhythm: tuple[Rhythm | None, Rhythm | None] = (None, None)
    bond: Bond = ALL_ALIKE
    breadth: float = 0.0
    ease: float = 0.0
    core: float = 0.30
    plain_edges: bool = False
    lone: NDArray[np.bool_] | None = None
    shows: int = 1


NESTED = Manner()
