"""Which library decodes which format.

OpenImageIO decodes most: it keeps 16 bits and floats, and says when pixels are missing. Pillow decodes

- AVIF, which OpenImageIO is built without;
- BMP, DDS without compression and ICO: OpenImageIO takes bytes for alpha that are none, exchanges channels
  that lie in an unusual order, and makes gray black;
- TIFF of L*a*b*, which OpenImageIO takes for RGB, and of palettes, whose 16 bits it scales as other programs
  do not write them;
- JPEG with a gain map, which OpenImageIO makes a picture of high dynamic range from, and JPEG with stray
  bytes between the segments of its header.
"""

import struct
import warnings
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from tilewright.errors import TilewrightFileError
from tilewright.files.decoding.bitmaps import read_masked_bitmap
from tilewright.files.decoding.decoded import PICTURE_CHANNELS, Decoded
from tilewright.files.decoding.formats import (
    ADVICE,
    raw_error,
    tell_format,
)
from tilewright.files.decoding.libraries import by_openimageio, by_pillow, say_others
from tilewright.files.decoding.media import avif_code_points, is_compressed_dds, mended_jpeg
from tilewright.files.decoding.png_chunks import PngChunks, read_chunks
from tilewright.files.decoding.rgb_spaces import (
    SRGB_PRIMARIES,
    RgbSpace,
    adobe_rgb,
    are_srgb,
    gamma_curve,
    space_of,
    space_of_code_points,
    srgb_curve,
)
from tilewright.files.decoding.targa import read_targa_alpha
from tilewright.files.decoding.tiff_pages import TiffPages, read_pages

_SRGB_GAMMA = 0.45455
_GAMMA_THRESHOLD = 0.05
"""What libpng takes for the same exponent, as a share."""
_UNCALIBRATED = 65535
_EXIF, _COLOR_SPACE = 0x8769, 0xA001
_INTEROPERABILITY, _INDEX, _ADOBE_RGB = 0xA005, 1, "R03"


def decode(path: Path) -> Decoded:
    """The pixels of an image file as they are in it, and what it states of them.

    Raises
    ------
    TilewrightFileError
        A format that is not read, a damaged file, or pixels of another kind.
    """
    return _DECODERS.get(tell_format(path), by_openimageio)(path)


def _decode_png(path: Path) -> Decoded:
    chunks = read_chunks(path)
    if chunks.fault:
        raise TilewrightFileError(f"{path} is not a whole PNG image ({chunks.fault})", value=path)
    # libpng leaves out profiles that do not go with the channels, without a word.
    decoded = replace(by_openimageio(path), profile=chunks.profile)
    others = say_others(chunks.pictures - 1, "an animation")
    if chunks.code_points:
        return replace(_in_code_points(decoded, chunks.code_points), profile=b"").noting(others)
    # A profile goes before the chunk of sRGB, and both go before gamma and primaries.
    if decoded.profile or b"sRGB" in chunks.kept:
        return decoded.noting(others)
    return replace(decoded, space=_png_space(chunks)).noting(others)


def _png_space(chunks: PngChunks) -> RgbSpace | None:
    """The color space that gAMA and cHRM describe, None for sRGB."""
    gamma, primaries = chunks.gamma, chunks.chromaticities
    usual = gamma is None or abs(gamma / _SRGB_GAMMA - 1) <= _GAMMA_THRESHOLD
    if usual and (primaries is None or are_srgb(primaries)):
        return None
    curve = srgb_curve if usual or gamma is None else gamma_curve(1 / gamma)
    chunk = "the PNG chunk gAMA" if primaries is None else "the PNG chunks gAMA and cHRM"
    return space_of(chunk, primaries or SRGB_PRIMARIES, curve)


def _in_code_points(decoded: Decoded, points: tuple[int, int]) -> Decoded:
    space = space_of_code_points(*points)
    if space is not None or 2 in points:  # 2: not specified
        return replace(decoded, space=space)
    named = f"H.273: primaries {points[0]}, transfer {points[1]}"
    return replace(decoded, unheeded=f"its color space ({named}) is not heeded")


def _decode_jpeg(path: Path) -> Decoded:
    try:
        decoded = by_openimageio(path)
    except TilewrightFileError:
        mended = mended_jpeg(path)
        if mended is None:
            raise
        return by_pillow(path, mended).noting("has stray bytes between the parts of its header")
    if decoded.pixels.dtype != np.uint8:  # the picture of 8 bit multiplied by the gain map
        decoded = by_pillow(path).noting("its gain map for bright displays is left out")
    return decoded if decoded.profile else _by_exif(path, decoded)


def _by_exif(path: Path, decoded: Decoded) -> Decoded:
    """The color space by Exif, as cameras state it without a profile (DCF 2.0, section 4.2)."""
    from PIL import Image

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of damaged tags
            with Image.open(path) as image:
                exif = image.getexif()
                space, index = (exif.get_ifd(part) for part in (_EXIF, _INTEROPERABILITY))
    except (OSError, SyntaxError, ValueError, KeyError, TypeError, struct.error):
        return decoded  # damaged, or written in a way of its maker
    if space.get(_COLOR_SPACE) != _UNCALIBRATED:
        return decoded
    if index.get(_INDEX) == _ADOBE_RGB:
        return replace(decoded, space=adobe_rgb())
    return replace(decoded, unheeded="its Exif data say that its colors are not sRGB, and not what they are")


def _decode_tiff(path: Path) -> Decoded:
    pages = read_pages(path)
    if pages is None:
        return by_openimageio(path)
    if pages.is_raw:
        raise raw_error(path)
    if pages.page is None:
        raise TilewrightFileError(
            f"{path} holds a preview and no whole picture that is read here", value=path, advice=ADVICE
        )
    if pages.refused_colors:
        raise TilewrightFileError(
            f"{path} holds {pages.refused_colors} colors, which are not read",
            value=path,
            advice="save it as RGB",
        )
    if pages.is_lab:
        return by_pillow(path, page=pages.page).noting(
            "its colors were converted from CIE L*a*b* to sRGB", say_others(pages.others)
        )
    if pages.is_palette:
        return by_pillow(path, page=pages.page).noting(say_others(pages.others))
    decoded = by_openimageio(path, pages.page)
    return replace(
        decoded, channels=_tiff_channels(pages, decoded.channels), associated=pages.associated
    ).noting(say_others(pages.others))


def _tiff_channels(pages: TiffPages, told: tuple[str, ...]) -> tuple[str, ...]:
    """Names of the channels by what the file states; CMYK comes as three without further ones."""
    if pages.color_channels not in (1, 3) or len(told) != pages.color_channels + len(pages.extra):
        return told
    if pages.color_channels == 1 and len(told) > len(PICTURE_CHANNELS):  # bands of a survey, no gray picture
        return tuple(f"channel{n}" for n in range(len(told)))
    extra = [f"channel{pages.color_channels + n}" for n in range(len(pages.extra))]
    if pages.has_alpha:
        extra[0] = "A"
    return (*PICTURE_CHANNELS[pages.color_channels], *extra)


def _decode_targa(path: Path) -> Decoded:
    decoded = by_openimageio(path)
    alpha = read_targa_alpha(path)
    if decoded.channels[-1] != "A" or alpha.there:
        return replace(decoded, associated=alpha.associated)
    rest = decoded.pixels[..., -1]
    varied = "states that it has no alpha; the last byte of its pixels is left out"
    return replace(decoded, pixels=decoded.pixels[..., :-1], channels=decoded.channels[:-1]).noting(
        varied if (rest != rest.flat[0]).any() else ""
    )


def _decode_bitmap(path: Path) -> Decoded:
    pixels = read_masked_bitmap(path)
    return by_pillow(path) if pixels is None else Decoded(pixels, PICTURE_CHANNELS[pixels.shape[-1]])


def _decode_dds(path: Path) -> Decoded:
    return by_openimageio(path) if is_compressed_dds(path) else by_pillow(path)


def _decode_avif(path: Path) -> Decoded:
    from PIL import features

    if not features.check("avif"):
        raise TilewrightFileError(
            f"{path} is AVIF, which this Pillow does not read",
            value=path,
            advice="install Pillow 11.3 or newer",
        )
    decoded = by_pillow(path)
    points = avif_code_points(path)
    return decoded if decoded.profile or points is None else _in_code_points(decoded, points)


def _decode_exr(path: Path) -> Decoded:
    return replace(by_openimageio(path, count=True), associated=True)  # by definition


def _decode_animation(path: Path) -> Decoded:
    return by_openimageio(path, count=True)


_DECODERS: dict[str, Callable[[Path], Decoded]] = {
    "png": _decode_png,
    "jpeg": _decode_jpeg,
    "tiff": _decode_tiff,
    "tga": _decode_targa,
    "bmp": _decode_bitmap,
    "dds": _decode_dds,
    "avif": _decode_avif,
    "exr": _decode_exr,
    "gif": _decode_animation,
    "webp": _decode_animation,
    "ico": by_pillow,
}
