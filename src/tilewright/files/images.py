"""Photographs and pictures: read and written with their type kept, 8-bit, 16-bit and float."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightFileError, TilewrightTypeError, TilewrightValueError
from tilewright.files.whole import whole_file

READABLE = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".bmp", ".webp", ".tga", ".hdr")
_TYPES = {"uint8": np.uint8, "uint16": np.uint16, "half": np.float32, "float": np.float32}


def read_image(path: str | Path) -> NDArray[Any]:
    """The pixels of an image file, shape (height, width, channels), 1 to 4 channels.

    8-bit files come as uint8, 16-bit ones as uint16, half and float ones as float32; palettes are
    expanded; alpha is kept as it is in the file, not multiplied in.

    Raises
    ------
    TilewrightFileError
        The file cannot be read, is not an image, or is truncated.
    """
    path = Path(path)
    if path.is_dir():
        raise TilewrightFileError(f"{path} is a folder; an image file is expected")
    if not path.is_file():
        raise TilewrightFileError(f"{path} does not exist")
    if path.suffix.lower() == ".png":
        _check_png(path)
    import OpenImageIO as oiio

    config = oiio.ImageSpec()
    config.attribute("oiio:UnassociatedAlpha", 1)
    source = oiio.ImageInput.open(str(path), config)
    if source is None:
        reason = " ".join(oiio.geterror().split())
        raise TilewrightFileError(f"{path} cannot be read as an image ({reason or 'unknown format'})")
    try:
        spec = source.spec()
        kind = _TYPES.get(str(spec.format))
        if kind is None:
            raise TilewrightFileError(
                f"{path} holds {spec.format} pixels; allowed are 8-bit, 16-bit, half and float"
            )
        wanted = "float" if kind is np.float32 else str(spec.format)
        pixels = source.read_image(0, 0, 0, min(spec.nchannels, 4), wanted)
        broken = bool(source.has_error)
        reason = " ".join(source.geterror().split())
    finally:
        source.close()
    if pixels is None or broken:
        raise TilewrightFileError(f"{path} is truncated or damaged ({reason or 'not all pixels are there'})")
    return np.ascontiguousarray(pixels.reshape(spec.height, spec.width, -1).astype(kind, copy=False))


def _check_png(path: Path) -> None:
    """Refuse a damaged PNG before a C library prints its own complaint."""
    from PIL import Image

    try:
        with Image.open(path) as image:
            image.verify()
    except Exception as error:
        reason = " ".join(str(error).split()) or type(error).__name__
        raise TilewrightFileError(f"{path} is not a whole PNG image ({reason})") from None


def write_image(path: str | Path, pixels: NDArray[Any]) -> None:
    """Write pixels, shape (height, width, channels), losslessly, or not at all.

    PNG takes uint8 and uint16, TIFF all types, EXR float32. The file appears under its name only when it is
    complete.
    """
    path = Path(path)
    kind = check_writable(path, pixels.dtype)
    import OpenImageIO as oiio

    height, width, channels = pixels.shape
    spec = oiio.ImageSpec(width, height, channels, kind)
    spec.attribute("oiio:UnassociatedAlpha", 1)
    spec.attribute(
        "compression", {".exr": "zip", ".tif": "zip", ".tiff": "zip"}.get(path.suffix.lower(), "none")
    )
    if path.suffix.lower() == ".png":
        spec.attribute("png:compressionLevel", 6)
    with whole_file(path) as unfinished:
        output = oiio.ImageOutput.create(str(unfinished))
        if output is None:
            raise TilewrightFileError(f"{path} could not be written ({' '.join(oiio.geterror().split())})")
        written = output.open(str(unfinished), spec) and output.write_image(np.ascontiguousarray(pixels))
        reason = " ".join(output.geterror().split())
        written = output.close() and written
        # The library does not always report that a disk is full, so the file is read again.
        if not (written and _holds(unfinished, pixels)):
            raise TilewrightFileError(f"{path} could not be written ({reason or 'is the disk full?'})")


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
        raise TilewrightTypeError(f"pixels have type {kind}; allowed are uint8, uint16, float32")
    allowed = {
        ".png": ("uint8", "uint16"),
        ".tif": ("uint8", "uint16", "float"),
        ".tiff": ("uint8", "uint16", "float"),
        ".exr": ("float",),
    }
    if suffix not in allowed:
        raise TilewrightValueError(
            f"{path} ends in {suffix or 'nothing'!r}; allowed are {', '.join(allowed)}"
        )
    if names[kind] not in allowed[suffix]:
        fits = [s for s, kinds in allowed.items() if names[kind] in kinds and s != ".tiff"]
        raise TilewrightValueError(f"{path}: {suffix} cannot hold {kind} pixels; use {' or '.join(fits)}")
    return names[kind]


def lossless_suffix(kind: np.dtype[Any]) -> str:
    """The suffix of the format in which tiles of this type are stored."""
    return ".exr" if kind == np.float32 else ".png"
