"""What is done to the maps of a photograph before they are cut: one size, whole normals, even light."""

import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter, zoom

from tilewright.errors import TilewrightValueError, TilewrightWarning
from tilewright.pixels import without_alpha
from tilewright.signals.textures.kinds import from_values, is_normal, is_signed, to_values

Maps = dict[str, NDArray[Any]]

LIGHT = 1 / 8
"""Light that varies over more than this share of the shorter side (sigma) is taken out by `flatten_light`."""
MOST_GAIN = 4.0
"""How much darker or brighter than the rest a place may be and still be evened out."""
_TELLING = 0.1
"""Correlation from which slopes tell which way green points."""
_SHORT, _FEW = 0.5, 0.02
"""Vectors shorter than this are none, and what share of them a map of normals may have."""
_INWARD = 0.1
"""How far a vector may point into the surface, as rounding and filters make of some."""


def match_sizes(maps: Maps, kinds: dict[str, str], size: tuple[int, int] | None = None) -> Maps:
    """All maps at the size of the largest, or at ``size``: (height, width).

    A map whose sides are those divided by a power of two is enlarged, bilinearly in what its kind is averaged
    in; with ``size`` larger ones are reduced as well.

    Raises
    ------
    TilewrightValueError
        A map is of another size; the message lists all of them.
    """
    sizes = {name: pixels.shape[:2] for name, pixels in maps.items()}
    wanted = size or max(sizes.values())
    matched = {}
    for name, (h, w) in sizes.items():
        up, down = wanted[0] / h, h / wanted[0]
        if h * wanted[1] != w * wanted[0] or not (_is_power(up) or (size and _is_power(down))):
            listing = ", ".join(f"{n} {x} x {y}" for n, (y, x) in sizes.items())
            target = f" and must fit {wanted[1]} x {wanted[0]}" if size else ""
            raise TilewrightValueError(
                f"the maps differ in size: {listing}{target}; sizes may differ by powers of two, alike in "
                "width and height"
            )
        matched[name] = maps[name] if up == 1 else _resize(maps[name], kinds[name], up)
    return matched


def _is_power(factor: float) -> bool:
    return factor >= 1 and factor == int(factor) and int(factor) & (int(factor) - 1) == 0


def _resize(pixels: NDArray[Any], kind: str, factor: float) -> NDArray[Any]:
    values = to_values(pixels, kind)
    if factor > 1:
        bigger = zoom(values, (factor, factor, 1), order=1, mode="nearest", grid_mode=True)
        return from_values(bigger, kind, pixels)
    step = round(1 / factor)
    h, w = (s // step for s in values.shape[:2])
    blocks = values.reshape(h, step, w, step, -1)
    return from_values(blocks.mean(axis=(1, 3), dtype=np.float32), kind, pixels)


def mend_normals(pixels: NDArray[Any], kind: str, name: str) -> NDArray[Any]:
    """Normals of length 1; those that have it, as far as their type can say, stay as they are.

    Raises
    ------
    TilewrightValueError
        Too many vectors are too short to be normals, or point into the surface.
    """
    if pixels.shape[-1] < 3:
        return pixels
    vectors = pixels[..., :3].astype(np.float32)
    if pixels.dtype.kind == "u":
        vectors /= np.float32(np.iinfo(pixels.dtype).max)
    if not is_signed(pixels):
        vectors = 2 * vectors - 1
    length = np.sqrt((vectors * vectors).sum(axis=-1))
    short = float((length < _SHORT).mean())
    if short > _FEW:
        raise TilewrightValueError(
            f"holds no normals: {short:.0%} of its vectors are shorter than {_SHORT}; is it another "
            "map? Name its kind, for example 'data'",
            argument=f"map {name!r}",
        )
    inward = float((vectors[..., 2] < -_INWARD).mean())
    if inward > _FEW:
        raise TilewrightValueError(
            f"holds no normals of a surface: {inward:.0%} of its vectors point into it; is blue another "
            "thing than their third component? Name its kind, for example 'data'",
            argument=f"map {name!r}",
        )
    # Half a step of each component can change the length of an 8-bit vector by 0.007.
    tolerance = 0.008 if pixels.dtype == np.uint8 else 1e-3
    off = np.abs(length - 1) > tolerance
    mended = pixels.copy()
    signed = is_signed(pixels)
    bad = pixels[off][:, np.newaxis]
    mended[off] = from_values(to_values(bad, kind, signed), kind, pixels, signed)[:, 0]
    return mended


def find_green(normals: NDArray[Any], height: NDArray[Any] | None = None) -> tuple[str | None, str]:
    """Which way the green of a map of normals points, and what told it.

    Parameters
    ----------
    normals : array, shape (h, w, 2 to 4)
    height : array, shape (h, w, channels), optional
        Heights, or depths, of the same surface.

    Returns
    -------
    kind : ``"normal-gl"``, ``"normal-dx"``, or None where neither source tells
    told_by : str

    Notes
    -----
    Slopes along x and y are those of one surface: with heights at hand, green goes with the slope towards the
    south or against it (and red tells heights from depths); without, the change of either slope along the
    other axis must be the same, and with green the wrong way it is the opposite.
    """
    vectors = to_values(normals, "normal-gl")[..., :3]
    across = -np.divide(vectors[..., 0], np.maximum(vectors[..., 2], 0.1) if vectors.shape[-1] > 2 else 1)
    down = np.divide(vectors[..., 1], np.maximum(vectors[..., 2], 0.1) if vectors.shape[-1] > 2 else 1)
    evidence = []
    if height is not None:
        south, east = np.gradient(height.astype(np.float32).mean(axis=2))
        told = _correlation(down, south) * np.sign(_correlation(across, east))
        evidence.append((told, "the height map tells"))
    told = _correlation(np.gradient(across, axis=0), np.gradient(down, axis=1))
    evidence.append((told, "its own slopes tell"))
    for agree, teller in evidence:
        if abs(agree) >= _TELLING:
            return ("normal-gl" if agree > 0 else "normal-dx"), teller
    return None, " and ".join(teller for _, teller in evidence).replace(" tells", "").replace(" tell", "")


def _correlation(a: NDArray[Any], b: NDArray[Any]) -> float:
    a, b = a - a.mean(dtype=np.float64), b - b.mean(dtype=np.float64)
    scale = float(np.sqrt((a * a).sum(dtype=np.float64) * (b * b).sum(dtype=np.float64)))
    return float((a * b).sum(dtype=np.float64)) / scale if scale > 0 else 0.0


def settle_normals(maps: Maps, kinds: dict[str, str], known: set[str], of: str = "") -> dict[str, str]:
    """Kinds in which the green of every map of normals is settled, and said aloud where it was found.

    ``known`` names the maps whose kind was given; ``of`` which photograph they belong to.
    """
    settled = dict(kinds)
    heights = [maps[name] for name, kind in kinds.items() if kind == "height"]
    for name, kind in kinds.items():
        if not is_normal(kind) or name in known:
            continue
        found, told_by = find_green(maps[name], heights[0] if heights else None)
        settled[name] = found or kind
        shown = "OpenGL (green up)" if settled[name] == "normal-gl" else "DirectX (green down)"
        reason = f"as {told_by}" if found else f"for want of better: {told_by} did not tell"
        warnings.warn(
            f"map {name!r}{of} is read as {shown}, {reason}; say so with "
            f"normal={settled[name].removeprefix('normal-')!r}, or the other",
            TilewrightWarning,
            stacklevel=4,
        )
    return settled


def turn_green(pixels: NDArray[Any]) -> NDArray[Any]:
    """Normals of the other convention."""
    turned = pixels.copy()
    white = np.iinfo(pixels.dtype).max if pixels.dtype.kind == "u" else 0 if is_signed(pixels) else 1
    turned[..., 1] = white - pixels[..., 1]
    return turned


def flatten_light(pixels: NDArray[Any]) -> NDArray[Any]:
    """A map of color without what varies slowly over it, shadow as well as tint.

    Every channel is multiplied, in linear light, by its mean over its low-passed self.
    """
    values = to_values(pixels, "color")
    colors = without_alpha(values)
    sigma = LIGHT * min(colors.shape[:2])
    slow = gaussian_filter(np.maximum(colors, 0), (sigma, sigma, 0), mode="reflect")
    mean = np.maximum(colors, 0).mean(axis=(0, 1), dtype=np.float64)
    gain = np.clip(mean / np.maximum(slow, mean / MOST_GAIN + 1e-12), 1 / MOST_GAIN, MOST_GAIN)
    colors *= gain.astype(np.float32)
    return from_values(values, "color", pixels)
