"""Which patch shows where on a piece of the plane, by the names that `pick` and `reject` take."""

from typing import NamedTuple

import numpy as np
from scipy.ndimage import distance_transform_edt, label

from tilewright.analysis.textures.sample import Sample
from tilewright.signals.textures.patch_names import PatchNames

SMALLEST = 0.015
"""Share of a tile below which a piece of a patch has no room for a name."""
SHARPEST = 512
"""Pixels along the side of what is searched for pieces: enough to place a name."""


class NamedPiece(NamedTuple):
    """A piece of the plane that shows one patch.

    Attributes
    ----------
    name : str
        The patch, as in the material's recipe.
    y, x : float
        A pixel well inside.
    """

    name: str
    y: float
    x: float


def named_pieces(sample: Sample, cells: int) -> list[NamedPiece]:
    """The patches that the first cells of a sample show, all but the smallest pieces.

    Empty where the recipe does not tell the places of patches.
    """
    rows = sample.cells[:cells, :cells]
    patches = PatchNames(sample.material)
    known = {row: patches.of_picture(int(row)) for row in np.unique(rows)}
    names = sorted({name for _, found in known.values() for name in found})
    numbers = {
        row: np.array([names.index(n) + 1 for n in found] + [0])[patch]
        for row, (patch, found) in known.items()
    }
    step = max(1, cells * sample.size // SHARPEST)
    shown = np.block([[numbers[row] for row in line] for line in rows])[::step, ::step]
    pieces = []
    for number, name in enumerate(names, start=1):
        parts, count = label(shown == number)
        for part in range(1, count + 1):
            inside = parts == part
            if inside.sum() < SMALLEST * (sample.size / step) ** 2:
                continue
            depth = distance_transform_edt(np.pad(inside, 1))[1:-1, 1:-1]
            y, x = np.unravel_index(depth.argmax(), depth.shape)
            pieces.append(NamedPiece(name, float(y * step), float(x * step)))
    return pieces
