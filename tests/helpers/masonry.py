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


def planks(bond, side=512, seed=0):
    """Bricks and planks of random brightness with darker joints: uint8 (side, side, 1)."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[:side, :side]
    plank, joint = {"running": _running, "stack": _stack, "basket": _basket, "herringbone": _herringbone}[
        bond
    ](y, x)
    picture = rng.normal(150, 14, plank.max() + 1)[plank]
    picture[joint] = 60
    return np.clip(np.rint(picture + rng.normal(0, 5, plank.shape)), 0, 255).astype(np.uint8)[..., np.newaxis]


def _running(y, x):
    """48 x 24, every second row half a brick on."""
    row = y // 24
    along = x + row % 2 * 24
    return row * 100 + along // 48, (y % 24 < 3) | (along % 48 < 3)


def _stack(y, x):
    """48 x 24, one above the other."""
    return y // 24 * 100 + x // 48, (y % 24 < 3) | (x % 48 < 3)


def _basket(y, x):
    """Squares of three planks of 60 x 20, lying and standing in turn."""
    row, column = y // 60, x // 60
    across = np.where((row + column) % 2, x, y)
    joint = (across % 20 < 3) | (y % 60 < 3) | (x % 60 < 3)
    return (row * 100 + column) * 3 + across % 60 // 20, joint


def _herringbone(y, x):
    """96 x 24, every plank a step of 24 pixels south-east of the last."""
    i, j = y // 24, x // 24
    step = (j - i) % 8
    lies = step < 4
    top, left = np.where(lies, i, i - (7 - step)), np.where(lies, j - step, j)
    down, right = y - 24 * top, x - 24 * left
    height, width = np.where(lies, 24, 96), np.where(lies, 96, 24)
    return (top + 8) * 100 + left + 8 + 5000 * lies, (down < 3) | (right < 3) | (down >= height) | (
        right >= width
    )
