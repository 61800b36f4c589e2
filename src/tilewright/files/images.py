"""Photographs and pictures: read and written with their type kept, 8-bit, 16-bit and float."""

import os
import zlib
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_type, shape_error
from tilewright.errors import TilewrightFileError, TilewrightTypeError, TilewrightValueError
from tilewright.files.atomic import AnyPath, as_path, whole_file
from tilewright.pixels import as_pixels

_TYPES = {"uint8": np.uint8, "uint16": np.uint16, "half": np.float32, "float": np.float32}
_MOST_CHANNELS = 4
NO_DATE = "1980:01:01 00:00:00"
"""Written instead of the time, so that the same pixels give the same bytes."""
_PNG = b"\x89PNG\r\n\x1a\n"


def read_image(path: AnyPath) -> NDArray[Any]:
    """Read the pixels of an image file.

    8-bit files come as uint8, 16-bit ones as uint16, half and float ones as float32; palettes are
    expanded; alpha is kept as it is in the file, not multiplied in; a photograph that its camera marked
    as turned or mirrored comes upright.

    Parameters
    ----------
    path : str or path-like
        PNG, JPEG, TIFF, EXR or another image format.

    Returns
    -------
    array, shape (height, width, channels), uint8, uint16 or float32
        Pixels ``[y, x]`` with row 0 on top, 1 to 4 channels.

    Raises
    ------
    TilewrightTypeError
        Something else than a path.
    TilewrightFileError
        The file cannot be read, is not an image, is truncated, or has pixels of another kind.
    """
    path = as_path(path)
    _check_readable(path)
    import OpenImageIO as oiio

    config = oiio.ImageSpec()
    config.attribute("oiio:UnassociatedAlpha", 1)
    source = oiio.ImageInput.open(str(path), config)
    if source is None:
        reason = first_line(oiio.geterror()) or "unknown format"
        raise TilewrightFileError(
            f"{path} cannot be read as an image, such as PNG, JPEG, TIFF or EXR ({reason})", value=path
        )
    try:
        spec = source.spec()
        kind = _TYPES.get(str(spec.format))
        if kind is None:
            raise TilewrightFileError(
                f"{path} holds {spec.format} pixels; allowed are 8-bit, 16-bit, half and float", value=path
            )
        if spec.nchannels > _MOST_CHANNELS:
            raise TilewrightFileError(
                f"{path} has {spec.nchannels} channels; allowed are 1 to {_MOST_CHANNELS}", value=path
            )
        wanted = "float" if kind is np.float32 else str(spec.format)
        pixels = source.read_image(0, 0, 0, spec.nchannels, wanted)
        broken = bool(source.has_error)
        reason = first_line(source.geterror()) or "not all pixels are there"
    finally:
        source.close()
    if pixels is None or broken:
        raise TilewrightFileError(f"{path} is truncated or damaged ({reason})", value=path)
    pixels = pixels.reshape(spec.height, spec.width, -1).astype(kind, copy=False)
    return _upright(pixels, spec.get_int_attribute("Orientation", 1))


def open_picture(name: str, given: Any) -> NDArray[Any]:
    """The pixels of a picture, however a person brings it: a file's path, a Pillow image, an array.

    Parameters
    ----------
    name : str
        What the picture is called where it is refused.
    given : path, Pillow image or array
        The picture.

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
        return read_image(given)
    pixels = as_pixels(name, given)
    if not isinstance(pixels, np.ndarray):
        allowed = "a path, an array or a Pillow image"
        raise TilewrightTypeError(
            f"must be {allowed}, not {type(given).__name__}", argument=name, value=given, allowed=allowed
        )
    return pixels


def _check_readable(path: Path) -> None:
    """Refuse what is no file, and a damaged PNG before a C library prints its own complaint."""
    try:
        if path.is_dir():
            raise TilewrightFileError(f"{path} is a folder; an image file is expected", value=path)
        if not path.exists():
            raise TilewrightFileError(f"{path} does not exist", value=path)
        if not path.is_file():
            raise TilewrightFileError(f"{path} is not a plain file; an image file is expected", value=path)
        fault = png_fault(path)
    except TilewrightFileError:
        raise
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise TilewrightFileError(f"{path} cannot be read: {reason}", value=path) from None
    if fault:
        raise TilewrightFileError(f"{path} is not a whole PNG image ({fault})", value=path)


def png_fault(path: Path) -> str:
    """What is wrong with the chunks of a PNG file; nothing where it is whole, or another kind of file."""
    with path.open("rb") as file:
        if file.read(len(_PNG)) != _PNG:
            return ""
        while len(head := file.read(8)) == 8:
            left, kind = int.from_bytes(head[:4]), head[4:]
            checksum = zlib.crc32(kind)
            while left and (piece := file.read(min(left, 1 << 20))):
                left -= len(piece)
                checksum = zlib.crc32(piece, checksum)
            given = file.read(4)
            if len(given) < 4:
                break
            # A chunk whose name starts with a small letter is not needed for the pixels.
            if int.from_bytes(given) != checksum and kind[:1].isupper():
                return f"the checksum of its chunk {kind.decode('latin-1')!r} is wrong"
            if kind == b"IEND":
                return ""
        return "it is truncated"


def _upright(pixels: NDArray[Any], orientation: int) -> NDArray[Any]:
    """Pixels turned as the Exif orientation 1 to 8 says: which sides row 0 and column 0 show."""
    if orientation in (5, 6, 7, 8):
        pixels = pixels.swapaxes(0, 1)
    if orientation in (3, 4, 7, 8):
        pixels = pixels[::-1]
    if orientation in (2, 3, 6, 7):
        pixels = pixels[:, ::-1]
    return np.ascontiguousarray(pixels)


def first_line(text: str) -> str:
    """The first of the complaints an image library has gathered, on one line."""
    return " ".join(text.strip().partition("\n")[0].split())


def write_image(path: AnyPath, pixels: NDArray[Any]) -> None:
    """Write pixels to an image file without loss, or not at all.

    The file appears under its name only when it is complete.

    Parameters
    ----------
    path : str or path-like
        ``.png`` takes uint8 and uint16, ``.tif`` all types, ``.exr`` float32.
    pixels : array, shape (height, width, channels), uint8, uint16 or float32
        Pixels ``[y, x]`` with row 0 on top, 1 to 4 channels.

    Raises
    ------
    TilewrightTypeError
        Something else than an array or a path, or pixels of another type.
    TilewrightValueError
        Another shape, or a suffix that does not go with the pixels' type.
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
    kind = check_writable(path, pixels.dtype)
    if pixels.ndim != 3 or not 1 <= pixels.shape[2] <= _MOST_CHANNELS or 0 in pixels.shape:
        raise shape_error(
            "pixels",
            pixels.shape,
            f"(height, width, channels), none of them 0, with 1 to {_MOST_CHANNELS} channels",
        )
    import OpenImageIO as oiio

    height, width, channels = pixels.shape
    spec = oiio.ImageSpec(width, height, channels, kind)
    spec.attribute("oiio:UnassociatedAlpha", 1)
    spec.attribute("DateTime", NO_DATE)
    if path.suffix.lower() == ".png":
        spec.attribute("png:compressionLevel", 4)
    else:
        spec.attribute("compression", "zip")
    with whole_file(path) as unfinished:
        output = oiio.ImageOutput.create(str(unfinished))
        if output is None:
            raise TilewrightFileError(
                f"{path} could not be written ({first_line(oiio.geterror())})", value=path
            )
        written = output.open(str(unfinished), spec) and output.write_image(np.ascontiguousarray(pixels))
        reason = first_line(output.geterror())
        written = output.close() and written
        # The library does not always report that a disk is full, so the file is read again.
        if not (written and _holds(unfinished, pixels)):
            raise TilewrightFileError(
                f"{path} could not be written ({reason or 'is the disk full?'})", value=path
            )


def _holds(path: Path, pixels: NDArray[Any]) -> bool:
    """Whether a file just written can be read and holds these pixels."""
    try:
        return np.array_equal(read_image(path), pixels, equal_nan=pixels.dtype.kind == "f")
    except TilewrightFileError:
        return False


def check_writable(path: Path, kind: np.dtype[Any]) -> str:
    """The pixel type a file of this suffix would hold; an error where it cannot hold such pixels."""
    suffix = path.suffix.lower()
    names = {np.dtype(np.uint8): "uint8", np.dtype(np.uint16): "uint16", np.dtype(np.float32): "float"}
    if kind not in names:
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
    if names[kind] not in allowed[suffix]:
        fits = [s for s, kinds in allowed.items() if names[kind] in kinds and s != ".tiff"]
        raise TilewrightValueError(
            f"{path}: {suffix} cannot hold {kind} pixels", value=path, advice=f"use {' or '.join(fits)}"
        )
    return names[kind]


def lossless_suffix(kind: np.dtype[Any]) -> str:
    """The suffix of the format in which tiles of this type are stored."""
    return ".exr" if kind == np.float32 else ".png"
