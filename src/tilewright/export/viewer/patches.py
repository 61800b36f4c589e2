"""Which patch a tile shows where, as the page holds it: at every fourth pixel, in runs."""

import base64
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.signals.textures import TextureTiles
from tilewright.signals.textures.patch_names import PatchNames

STEP = 4
"""Pixels from one that is told to the next, along either side."""
_UNKNOWN, _LONGEST = 255, 255


def describe_patches(material: TextureTiles) -> dict[str, Any]:
    """Describe the patches of all pictures: ``step``, all ``names``, and for each picture its names and runs.

    A picture is told at the middles of squares of ``step`` pixels, by rows: pairs of bytes, which of the
    picture's names (255 where unknown) and how many squares in turn. Empty where no name is known.
    """
    patches = PatchNames(material)
    if not patches:
        return {}
    names: dict[str, int] = {}
    pictures = []
    for row in range(len(material.variants)):
        index, found = patches.of_picture(row)
        told = index[STEP // 2 :: STEP, STEP // 2 :: STEP]
        told = np.where((told < 0) | (told >= _UNKNOWN), _UNKNOWN, told)
        own = [names.setdefault(name, len(names)) for name in found[:_UNKNOWN]]
        pictures.append({"names": own, "runs": base64.b64encode(_runs(told.ravel())).decode()})
    return {"step": STEP, "names": list(names), "pictures": pictures}


def _runs(values: NDArray[np.int64]) -> bytes:
    """Pairs of a value and how often it comes in turn."""
    starts = np.concatenate([[0], np.flatnonzero(np.diff(values)) + 1, [len(values)]])
    pairs = bytearray()
    for start, end in pairwise(starts):
        for first in range(start, end, _LONGEST):
            pairs += bytes([int(values[start]), min(_LONGEST, end - first)])
    return bytes(pairs)
