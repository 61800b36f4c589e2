"""Tilings to begin with: chance, or the light and dark of a picture."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike

from tilewright.checks import check_int, check_real, type_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.pixels import LUMINANCE, as_pixels, on_paper, white
from tilewright.tilings.dappled.conditions import Cells, Conditions, Most
from tilewright.tilings.hashes import MixerHash
from tilewright.tilings.streams import DAPPLE_START

_MOST_SIDE = 65536
_AT_ONCE = 2**20
"""Cells that are drawn at once."""


def random_start(width: int, height: int, shares: Sequence[float] = (0.5, 0.5), seed: int = 0) -> Cells:
    """Make a tiling in which every cell draws its tile by itself.

    Parameters
    ----------
    width : int
        Cells along x, 1 to 65,536. A larger tiling continues a smaller one of the same seed.
    height : int
        Cells along y, 1 to 65,536.
    shares : sequence of float, optional
        How often each tile comes, such as ``(0.3, 0.7)``; only their ratios count. Default (0.5, 0.5).
    seed : int, optional
        Where chance begins, 0 to 2^64 - 1; default 0.

    Returns
    -------
    uint8 array, shape (height, width)
        The tile of each cell.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range, or there are fewer than two shares.

    Notes
    -----
    Kaji et al. 2016, section 6, begins with such tilings.

    Examples
    --------
    >>> import tilewright as tw
    >>> start = tw.random_start(1000, 1000, (0.3, 0.7), seed=1)
    >>> round(float(start.mean()), 2)
    0.7
    """
    check_int("width", width, 1, _MOST_SIDE)
    check_int("height", height, 1, _MOST_SIDE)
    if isinstance(shares, str) or not hasattr(shares, "__iter__"):
        raise type_error("shares", shares, "numbers such as (0.5, 0.5)")
    weights = np.array([check_real("a share", share, 0, 1e9) for share in shares])
    if len(weights) < 2 or weights.sum() <= 0:
        raise TilewrightValueError(
            f"is {tuple(shares)}; expected a number for each tile, at least two",
            argument="shares",
            value=shares,
            allowed="a number for each tile, at least two",
        )
    most = np.cumsum(weights) / weights.sum() * 2.0**32
    out = np.empty((height, width), np.uint8)
    hash, x, rows = MixerHash(seed), np.arange(width), -(-_AT_ONCE // width)
    for top in range(0, height, rows):
        y = np.arange(top, min(top + rows, height))[:, np.newaxis]
        out[top : top + rows] = np.searchsorted(most[:-1], hash.words(DAPPLE_START, x, y), side="right")
    return out


def start_from_image(
    pixels: ArrayLike,
    width: int,
    height: int,
    tiles: int = 2,
    *,
    dither: bool = False,
    limits: Mapping[str, Most] | Conditions | None = None,
) -> Cells:
    """Make a tiling that follows a picture: dark parts get tile 0, light parts the last tile.

    Parameters
    ----------
    pixels : array-like, shape (h, w) or (h, w, channels), or Pillow image
        Grays or sRGB colors; integers over their type's range, floats from 0 to 1. Alpha counts where
        nothing is drawn, which is white, and in drawings of one color: see `tilewright.pixels.on_paper`.
    width : int
        Cells along x, 1 to 65,536; the picture is averaged over each cell, stretched where the sides have
        another ratio.
    height : int
        Cells along y, 1 to 65,536.
    tiles : int, optional
        Number of tiles, 2 to 256; default 2.
    dither : bool, optional
        Whether the error of each cell is passed on to its neighbors (Floyd and Steinberg), so that grays
        become mixtures; default False: every cell takes the nearest tile.
    limits : mapping or Conditions, optional
        Constant limits that the tiling is to be dappled by: tones are brought between the darkest and the
        lightest mixture that they allow. Flat black, dithered and then dappled, would be a grid. By default
        tones stay.

    Returns
    -------
    uint8 array, shape (height, width)
        The tile of each cell.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range, or the picture has another shape.

    Notes
    -----
    Our own, not from the papers.

    Examples
    --------
    >>> import tilewright as tw
    >>> tw.start_from_image([[0.1, 0.9]], 4, 1).tolist()
    [[0, 0, 1, 1]]
    """
    check_int("width", width, 1, _MOST_SIDE)
    check_int("height", height, 1, _MOST_SIDE)
    levels = check_int("tiles", tiles, 2, 256) - 1
    from PIL import Image

    brightness = _gray(pixels)
    if limits is not None:
        brightness = _squeeze(brightness, Conditions(limits, tiles))
    gray = Image.fromarray(brightness).resize((width, height), Image.Resampling.BOX)
    if not dither:
        return np.rint(np.asarray(gray) * levels).astype(np.uint8)
    shades = Image.new("P", (1, 1))
    shades.putpalette(np.repeat(np.rint(np.linspace(0, 255, levels + 1)), 3).astype(np.uint8).tobytes())
    eight_bits = Image.fromarray(np.rint(np.asarray(gray) * 255).astype(np.uint8)).convert("RGB")
    return np.array(eight_bits.quantize(palette=shades, dither=Image.Dither.FLOYDSTEINBERG))


def _squeeze(brightness: np.ndarray, conditions: Conditions) -> np.ndarray:
    """Tones between the darkest and the lightest mixture of tiles that the limits allow."""
    if not conditions.is_single or any(callable(x.most) or x.most.size > 1 for x in conditions.limits):
        raise TilewrightValueError(
            "must be constant and of single tiles, to dither by them",
            argument="limits",
            allowed="constant and of single tiles, to dither by them",
        )
    longest = np.minimum(*(conditions.table(axis, (1, 1))[:, 0, 0] for axis in (0, 1)))
    # At least so much of a line is of other tiles, the next one at best.
    others = 1 / (longest + 1.0) / (conditions.tiles - 1)
    darkest, lightest = others[0], 1 - others[-1]
    return (darkest + (lightest - darkest) * brightness).astype(np.float32)


def _gray(pixels: ArrayLike) -> np.ndarray:
    """Brightness from 0 to 1 as float32."""
    try:
        given = np.asarray(as_pixels("pixels", pixels))
    except ValueError:
        raise TilewrightValueError("are not equally long rows", argument="pixels") from None
    if given.dtype.kind not in "uif" or given.ndim not in (2, 3) or given.size == 0:
        raise TilewrightTypeError(
            f"must be numbers (h, w) or (h, w, channels), not {given.dtype} {given.shape}",
            argument="pixels",
            value=given.dtype,
            allowed="numbers (h, w) or (h, w, channels)",
        )
    values = given.astype(np.float64) * (1.0 / white(given.dtype))
    if not np.isfinite(values).all():
        raise TilewrightValueError("holds NaN or infinity", argument="pixels")
    if values.ndim == 3:
        colors = on_paper(values)
        values = colors @ np.array(LUMINANCE if colors.shape[2] == 3 else (1.0,))
    return np.clip(values, 0, 1).astype(np.float32)
