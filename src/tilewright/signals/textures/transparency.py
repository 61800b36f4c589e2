"""Places of a photograph that are not there: erased, or beyond its edges where it was turned."""

import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import minimum_filter

from tilewright.errors import TilewrightWarning
from tilewright.pixels import has_alpha, white

_BLOCKS = 3
"""A pattern of holes, such as a fence's, shows in each block of a grid of so many along each side."""
_ROOM = 24
"""Pixels along a square that is all there, without which the smallest tiles could not be copied."""
_FULL = 0.99
"""Alpha from which a pixel is there, as a share of white."""


def find_there(
    maps: Mapping[str, NDArray[Any]], kinds: Mapping[str, str], of: str
) -> NDArray[np.bool_] | None:
    """Which pixels of a photograph are there, where part of it is not; None where nothing is to be left out.

    Alpha that is part of the pattern, as of a fence or of leaves, varies all over the photograph. Where some
    part of it, a third of its width and height, is wholly there or wholly not, alpha tells what there is to
    copy, and copied holes would be holes in the tiles.

    Parameters
    ----------
    maps : dict of str to array, shape (h, w, channels)
        Maps of one photograph; alpha of the first map of color counts.
    kinds : dict of str to str
        What they hold.
    of : str
        Which photograph, for the notes.

    Returns
    -------
    bool array, shape (h, w), or None

    Warns
    -----
    TilewrightWarning
        Pixels are left out, or nothing is there.
    """
    colors = [maps[name] for name, kind in kinds.items() if kind == "color"]
    if not colors or not has_alpha(colors[0].shape[-1]):
        return None
    there = colors[0][..., -1] >= _FULL * white(colors[0].dtype)
    if not colors[0][..., -1].any():
        warnings.warn(
            f"{of} is wholly transparent, as its tiles will be; save it without alpha to change that",
            TilewrightWarning,
            stacklevel=4,
        )
        return None
    if there.all() or not _is_partial(there):
        return None
    warnings.warn(
        f"{1 - there.mean():.0%} of {of} is transparent and not copied; give a mask, white where pixels may "
        "be copied, to choose yourself",
        TilewrightWarning,
        stacklevel=4,
    )
    return there


def _is_partial(there: NDArray[np.bool_]) -> bool:
    """Whether some block is all there or all missing, and enough is there in one piece to be copied."""
    blocks = [block for rows in np.array_split(there, _BLOCKS) for block in np.array_split(rows, _BLOCKS, 1)]
    if not any(block.all() or not block.any() for block in blocks):
        return False
    return bool(minimum_filter(there, _ROOM, mode="constant", cval=0).any())
