"""What a photograph is like, as far as it decides how a texture of it is best made."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter, median_filter, zoom

from tilewright.signals.textures.bond import ALL_ALIKE, Bond, find_bond
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.kinds import to_lab
from tilewright.signals.textures.regularity import Regularity
from tilewright.signals.textures.rhythm import Rhythm, find_rhythm
from tilewright.signals.textures.sheet import reduce_blocks, reduce_pixels

THINGS = 0.57
"""Edge share from which tone belongs to things. It was 0.37 to 0.53 on eleven photographs without things of
their own color, and 0.61 to 0.70 on four with them."""
FAINT = 0.01
"""Share of the variance below which there is no tone to speak of."""
SEEN_AT = 128
"""Pixels along a tile at which a photograph is looked at, whatever its tiles will have."""
_LARGEST_SIDE = 1024


@dataclass(frozen=True, eq=False)
class Character:
    """What a photograph is like.

    Attributes
    ----------
    rhythm : (Rhythm or None, Rhythm or None)
        Of its rows and of its columns.
    bond : Bond
        How these go together.
    edge_share : float
        How much of the outlines at the size of things is sharp: the share of the squared gradient that its
        steepest tenth holds once all that is finer is gone, 0.1 to 1.
    tone_share : float
        Share of the variance that varies over more than a fifth of a tile, 0 to 1.
    """

    rhythm: tuple[Rhythm | None, Rhythm | None]
    bond: Bond
    edge_share: float
    tone_share: float

    @property
    def has_rhythm(self) -> bool:
        """Whether there are courses along either axis."""
        return any(self.rhythm)

    @property
    def has_things(self) -> bool:
        """Whether tone belongs to things with outlines."""
        return self.edge_share >= THINGS

    @property
    def has_tone(self) -> bool:
        """Whether there is tone that belongs to no things."""
        return not self.has_rhythm and not self.has_things and self.tone_share >= FAINT


def find_character(exemplar: Exemplar, regularity: Regularity, tile_size: int) -> Character:
    """Look at the main map of a photograph.

    Parameters
    ----------
    exemplar : Exemplar
        The first source is looked at.
    regularity : Regularity
        That of its main map.
    tile_size : int
        Pixels along a tile of usual size for it.
    """
    name, pixels = next(iter(exemplar.sources[0].items()))
    step = max(1, tile_size // SEEN_AT)
    small = to_lab(reduce_pixels(pixels, step), exemplar.kinds[name])
    usable = reduce_blocks(exemplar.masks[0][..., np.newaxis].astype(np.float32), step)[..., 0] > 0.5
    rhythms, bond = _find_courses(small[..., 0], step, pixels.shape[:2], regularity)
    return Character(rhythms, bond, _edge_share(small[..., 0], usable), _tone_share(small, usable))


def _find_courses(
    gray: NDArray[np.float32], seen_step: int, shape: tuple[int, int], regularity: Regularity
) -> tuple[tuple[Rhythm | None, Rhythm | None], Bond]:
    """Rhythms and bond of a photograph of a shape, of which ``seen_step`` pixels are one in ``gray``."""
    further = -(-max(gray.shape) // _LARGEST_SIDE)
    small, step = reduce_blocks(gray[..., np.newaxis], further)[..., 0], seen_step * further
    rows, columns = (
        find_rhythm(seen, period and period / step)
        for seen, period in zip((small, small.T), regularity.period, strict=True)
    )
    bond = find_bond(small, rows, columns) if rows and columns else ALL_ALIKE
    return (rows and rows.enlarged(step, shape[0]), columns and columns.enlarged(step, shape[1])), bond


def _edge_share(lightness: NDArray[np.float32], usable: NDArray[np.bool_]) -> float:
    """Things keep their outlines under a median, fine structure does not."""
    half = reduce_blocks(lightness[..., np.newaxis], 2)[..., 0]
    flat = zoom(median_filter(half, 15, mode="nearest"), 2, order=1)
    smooth = gaussian_filter(flat, 1.0)
    dy, dx = np.gradient(smooth)
    inside = usable[: smooth.shape[0], : smooth.shape[1]]
    steep = np.sort((dx * dx + dy * dy)[inside])[::-1]
    return float(steep[: max(1, len(steep) // 10)].sum() / max(float(steep.sum()), 1e-12))


def _tone_share(lab: NDArray[np.float32], usable: NDArray[np.bool_]) -> float:
    sigma = SEEN_AT / 5
    low = gaussian_filter(lab, (sigma, sigma, 0), mode="nearest")
    return float(low[usable].var(axis=0).sum() / max(float(lab[usable].var(axis=0).sum()), 1e-12))
