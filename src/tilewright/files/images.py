"""Photographs and pictures: read and written with their type kept, 8-bit, 16-bit and float."""

import os
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_flag, check_type, shape_error
from tilewright.errors import (
    TilewrightFileError,
    TilewrightTypeError,
    TilewrightValueError,
    TilewrightWarning,
)
from tilewright.files.atomic import AnyPath, as_path, whole_file
from tilewright.files.decoding.alpha import to_associated
from tilewright.files.decoding.decoded import PICTURE_CHANNELS, Decoded
from tilewright.files.decoding.decoders import decode
from tilewright.pixels import as_pixels, has_alpha, is_pillow

_MOST_CHANNELS = 4
_LARGEST_SIDES = {".png": 1_000_000, ".exr": 1 << 20, ".jpg": 65_535, ".jpeg": 65_535, ".webp": 16_383}
"""What libpng takes, what OpenImageIO reads again, and what the formats have numbers for."""
_COMPRESSIONS = {".jpg": "jpeg:95", ".jpeg": "jpeg:95", ".webp": "webp:95"}
_NAMES = {np.dtype(np.uint8): "uint8", np.dtype(np.uint16): "uint16", np.dtype(np.float32): "float"}
_LARGEST_SIDE = 2**31 - 1
NO_DATE = "1980:01:01 00:00:00"
"""Written instead of the time, so that the same pixels give the same bytes."""


def read_image(path: AnyPath, *, color: bool = True) -> NDArray[Any]:
    """Read the pixels of an image file.

    8-bit files come as uint8, 16-bit ones as uint16, half and float ones as float32; palettes are
    expanded; a photograph that its camera marked as turned or mirrored comes upright.

    Parameters
    ----------
    path : str or path-like
        PNG, JPEG, TIFF, EXR, WebP, AVIF or another image format.
    color : bool, optional
        The numbers are light, default True: they come as sRGB (integers) or linear light of sRGB's
        primaries (floats) whatever color profile, primaries or gamma the file states, and alpha that is
        multiplied in is divided out, so that it is always straight. False is for maps that hold no color,
        such as normals: the numbers come as they are in the file.

    Returns
    -------
    array, shape (height, width, channels), uint8, uint16 or float32
        Pixels ``[y, x]`` with row 0 on top, 1 to 4 channels: gray, gray and alpha, color, color and alpha.

    Raises
    ------
    TilewrightTypeError
        Something else than a path, or than True and False.
    TilewrightFileError
        The file cannot be read, is not an image, is truncated, or has pixels of another kind.

    Warns
    -----
    TilewrightWarning
        What the file states and is not in the pixels that came, or was converted: a color profile, channels
        that are neither color nor alpha, further pictures, a gain map.

    Notes
    -----
    Conversion is relative colorimetric: 8-bit pixels by littleCMS, others by the matrix and curves of the
    profile (ICC.1:2022). A profile that means sRGB within 2 of 255 changes nothing.
    """
    path = as_path(path)
    check_flag("color", color)
    decoded = _decode_file(path)
    if color:
        decoded = decoded.as_picture()
    _check_channels(path, decoded, color)
    for note in decoded.notes:
        warnings.warn(f"{path}: {note}", TilewrightWarning, stacklevel=2)
    return _upright(decoded.pixels, decoded.orientation)


def _check_channels(path: Path, decoded: Decoded, color: bool) -> None:
    names = decoded.channels
    if len(names) > _MOST_CHANNELS:
        raise TilewrightFileError(
            f"{path} has {len(names)} channels; allowed are 1 to {_MOST_CHANNELS}", value=path
        )
    if color and not decoded.is_picture:
        raise TilewrightFileError(
            f"{path} has the channels {', '.join(names)}; allowed are R, G and B, or Y, with A or without",
            value=path,
            advice="read it as data if it holds no color",
        )


def open_picture(name: str, given: Any, *, color: bool = True) -> NDArray[Any]:
    """The pixels of a picture, however a person brings it: a file's path, a Pillow image, an array.

    Parameters
    ----------
    name : str
        What the picture is called where it is refused.
    given : path, Pillow image or array
        The picture.
    color : bool, optional
        Its numbers are light, as in `read_image`; default True.

    Returns
    -------
    array
        Its pixels; an array as it is.

    Raises
    ------
    TilewrightFileError
        As in `read_image`.
    TilewrightTypeError
        ``given`` is none of these.
    """
    if isinstance(given, (str, os.PathLike)):
        return read_image(given, color=color)
    pixels = as_pixels(name, given)
    if not isinstance(pixels, np.ndarray):
        allowed = "a path, an array or a Pillow image"
        raise TilewrightTypeError(
            f"must be {allowed}, not {type(given).__name__}",
            argument=name,
            value=given,
            allowed=allowed,
            advice="pass numpy.asarray(...) of it" if isinstance(given, (list, tuple)) else "",
        )
    if color and is_pillow(given) and (profile := given.info.get("icc_profile")):
        shown = Decoded(pixels, PICTURE_CHANNELS[pixels.shape[-1]], profile=profile).as_picture()
        for note in shown.notes:
            warnings.warn(f"{name}: {note}", TilewrightWarning, stacklevel=2)
        return shown.pixels
    return pixels


def _decode_file(path: Path) -> Decoded:
    """What is in a file, which must be a plain one that can be read."""
    try:
        if path.is_dir():
            raise TilewrightFileError(f"{path} is a folder; an image file is expected", value=path)
        if not path.exists():
            raise TilewrightFileError(f"{path} does not exist", value=path)
        if not path.is_file():
            raise TilewrightFileError(f"{path} is not a plain file; an image file is expected", value=path)
        return decode(path)
    except TilewrightFileError:
        raise
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise TilewrightFileError(f"{path} cannot be read: {reason}", value=path) from None


def _upright(pixels: NDArray[Any], orientation: int) -> NDArray[Any]:
    """Pixels turned as the Exif orientation 1 to 8 says: which sides row 0 and column 0 show."""
    if orientation in (5, 6, 7, 8):
        pixels = pixels.swapaxes(0, 1)
    if orientation in (3, 4, 7, 8):
        pixels = pixels[::-1]
    if orientation in (2, 3, 6, 7):
        pixels = pixels[:, ::-1]
    return np.ascontiguousarray(pixels)


def write_image(path: AnyPath, pixels: NDArray[Any], *, color: bool = True) -> None:
    """Write pixels to an image file, or nothing at all.

    The file appears under its name only when it is complete. Nothing is lost but, in EXR, colors where alpha
    is 0 and a last bit where it is below 1: there colors are multiplied by alpha, by the format's definition.

    Parameters
    ----------
    path : str or path-like
        ``.png`` takes uint8 and uint16, ``.tif`` all types, ``.exr`` float32.
    pixels : array, shape (height, width, channels), uint8, uint16 or float32
        Pixels ``[y, x]`` with row 0 on top, 1 to 4 channels; the last of 2 or 4 is straight alpha.
    color : bool, optional
        The numbers are light, default True; False writes the channels of other maps as they are, also to EXR.

    Raises
    ------
    TilewrightTypeError
        Something else than an array or a path, or pixels of another type.
    TilewrightValueError
        Another shape, a suffix that does not go with the pixels' type, or more pixels along a side than the
        format takes: 1,000,000 for PNG, 1,048,576 for EXR.
    TilewrightFileError
        The file cannot be written.

    Examples
    --------
    >>> import tempfile
    >>> import numpy as np
    >>> import tilewright as tw
    >>> pixels = np.arange(12, dtype=np.uint8).reshape(2, 2, 3)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tw.write_image(f"{folder}/small.png", pixels)
    ...     print(bool((tw.read_image(f"{folder}/small.png") == pixels).all()))
    True
    """
    path = as_path(path)
    check_type("pixels", pixels, np.ndarray, "an array")
    check_writable(path, pixels.dtype)
    if pixels.ndim != 3 or not 1 <= pixels.shape[2] <= _MOST_CHANNELS or 0 in pixels.shape:
        raise shape_error(
            "pixels",
            pixels.shape,
            f"(height, width, channels), none of them 0, with 1 to {_MOST_CHANNELS} channels",
        )
    check_flag("color", color)
    height, width, channels = pixels.shape
    check_sides(path, width, height)
    if is_associated(path, channels, color):
        pixels = to_associated(pixels)
    import OpenImageIO as oiio

    spec = image_spec(path, width, height, channels, pixels.dtype)
    spec.attribute("DateTime", NO_DATE)
    with whole_file(path) as unfinished:
        output = oiio.ImageOutput.create(str(unfinished))
        written = (
            output is not None
            and output.open(str(unfinished), spec)
            and output.write_image(np.ascontiguousarray(pixels))
        )
        written = output is not None and output.close() and written
        # The library does not always report that a disk is full, so the file is read again.
        if not (written and _holds(unfinished, pixels)):
            raise unwritten_error(path)


def image_spec(path: Path, width: int, height: int, channels: int, kind: np.dtype[Any]) -> Any:
    """What OpenImageIO is to write to a file of this suffix."""
    import OpenImageIO as oiio

    spec = oiio.ImageSpec(width, height, channels, _NAMES[kind])
    if channels == 2:
        spec.channelnames = PICTURE_CHANNELS[2]
        spec.alpha_channel = 1
    spec.attribute("oiio:UnassociatedAlpha", 1)
    suffix = path.suffix.lower()
    if suffix == ".png":
        spec.attribute("png:compressionLevel", 4)
    else:
        spec.attribute("compression", _COMPRESSIONS.get(suffix, "zip"))
    return spec


def is_associated(path: Path, channels: int, color: bool) -> bool:
    """Whether a file of this suffix holds colors that are multiplied by alpha, as EXR does by definition."""
    return color and path.suffix.lower() == ".exr" and has_alpha(channels)


def check_sides(path: Path, width: int, height: int) -> None:
    """Refuse a picture that is wider or higher than its format takes."""
    suffix = path.suffix.lower()
    most = _LARGEST_SIDES.get(suffix, _LARGEST_SIDE)
    if max(width, height) > most:
        raise TilewrightValueError(
            f"{path} would be {width} x {height} pixels; {suffix} takes at most {most:,} on a side",
            value=(width, height),
            allowed=f"1 to {most}",
            advice="write a .tif" if most < _LARGEST_SIDE else "write it in parts",
        )


def unwritten_error(path: Path) -> TilewrightFileError:
    """The error of a file that came out incomplete, though its folder and size are good."""
    return TilewrightFileError(f"{path} could not be written (is the disk full?)", value=path)


def _holds(path: Path, pixels: NDArray[Any]) -> bool:
    """Whether a file just written can be read and holds these pixels."""
    try:
        return np.array_equal(read_image(path, color=False), pixels, equal_nan=pixels.dtype.kind == "f")
    except TilewrightFileError:
        return False


def check_writable(path: Path, kind: np.dtype[Any]) -> None:
    """Refuse a file of this suffix where it cannot hold such pixels as they are."""
    suffix = path.suffix.lower()
    if kind not in _NAMES:
        raise TilewrightTypeError(
            f"have type {kind}; allowed are uint8, uint16, float32",
            argument="pixels",
            allowed="uint8, uint16, float32",
        )
    allowed = {
        ".png": ("uint8", "uint16"),
        ".tif": ("uint8", "uint16", "float"),
        ".tiff": ("uint8", "uint16", "float"),
        ".exr": ("float",),
    }
    if suffix not in allowed:
        raise TilewrightValueError(
            f"{path} {(f'ends in {suffix!r}' if suffix else 'has no suffix')}; allowed are "
            f"{', '.join(allowed)}",
            value=path,
        )
    if _NAMES[kind] not in allowed[suffix]:
        fits = [s for s, kinds in allowed.items() if _NAMES[kind] in kinds and s != ".tiff"]
        raise TilewrightValueError(
            f"{path}: {suffix} cannot hold {kind} pixels", value=path, advice=f"use {' or '.join(fits)}"
        )


def lossless_suffix(kind: np.dtype[Any], channels: int = 1) -> str:
    """The suffix of the format in which tiles of this type are stored.

    Floats with alpha are TIFF, as EXR would hold them multiplied.
    """
    if kind != np.float32:
        return ".png"
    return ".tif" if has_alpha(channels) else ".exr"
