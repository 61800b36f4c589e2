"""An order of places in space that keeps neighbors together: along the curve of Morton 1966."""

import numpy as np
from numpy.typing import NDArray

_BITS = 20
_SPREADS = (
    (32, 0x1F00000000FFFF),
    (16, 0x1F0000FF0000FF),
    (8, 0x100F00F00F00F00F),
    (4, 0x10C30C30C30C30C3),
    (2, 0x1249249249249249),
)
"""How far bits move, and where they may then be, so that two zeros come between each two."""


def morton_numbers(places: NDArray[np.float64]) -> NDArray[np.uint64]:
    """The number of each place (n, 3) along the curve through their box, uint64, shape (n,)."""
    low = places.min(axis=0)
    reach = float((places.max(axis=0) - low).max()) or 1.0
    steps = np.minimum((places - low) / reach * 2**_BITS, 2**_BITS - 1).astype(np.uint64)
    for shift, mask in _SPREADS:
        steps = (steps | steps << np.uint64(shift)) & np.uint64(mask)
    numbers: NDArray[np.uint64] = steps[:, 0] | steps[:, 1] << np.uint64(1) | steps[:, 2] << np.uint64(2)
    return numbers
