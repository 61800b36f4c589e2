"""Pictures of walls."""

import numpy as np


def courses(heights, width=400, joint=3, seed=0):
    """Stones of random brightness in rows of the given heights, with lighter joints between them."""
    rng = np.random.default_rng(seed)
    picture = np.zeros((sum(heights), width))
    top = 0
    for height in heights:
        left = -int(rng.integers(40))
        while left < width:
            step = int(rng.integers(40, 90))
            picture[top : top + height, max(0, left) : left + step] = rng.normal(90, 15)
            picture[top : top + height, max(0, left) : max(0, left + joint)] = 130
            left += step
        picture[top : top + joint] = 130
        top += height
    return (picture + rng.normal(0, 6, picture.shape)).astype(np.float32)
