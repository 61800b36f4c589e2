"""Pixels by OpenImageIO and by Pillow, in one form; complaints of both in one form too."""

import io
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from tilewright.errors import TilewrightError, TilewrightFileError
from tilewright.files.decoding.decoded import PICTURE_CHANNELS, Decoded
from tilewright.files.decoding.formats import damaged_error, unknown_error
from tilewright.files.decoding.rgb_spaces import RgbSpace, gamma_curve, lab_to_srgb, space_of
from tilewright.pixels import as_pixels

_TYPES = {"uint8": np.uint8, "uint16": np.uint16, "half": np.float32, "float": np.float32}

_MOST_PIXELS = 1 << 30
"""Half of what Pillow refuses; by itself it stops at photographs of 179 million, which telephones make."""
_COUNTED_ELSEWHERE = ("JPEG", "MPO", "TIFF")
"""Formats whose further pictures Pillow counts too: those of telephones are previews and gain maps."""


def say_others(others: int, what: str = "several pictures") -> str:
    """A note of pictures that are not read, empty where there are none."""
    return f"holds {what}; the first of {others + 1} is taken" if others > 0 else ""


def by_openimageio(path: Path, page: int = 0, count: bool = False) -> Decoded:
    """A picture of a file by OpenImageIO; ``count``: say how many there are."""
    import OpenImageIO as oiio

    config = oiio.ImageSpec()
    config.attribute("oiio:UnassociatedAlpha", 1)
    source = oiio.ImageInput.open(str(path), config)
    if source is None:
        raise _refusal(path)
    try:
        if page:
            source.seek_subimage(page, 0)
        spec = source.spec()
        kind = _TYPES.get(str(spec.format))
        if kind is None:
            raise TilewrightFileError(
                f"{path} holds {spec.format} pixels; allowed are 8-bit, 16-bit, half and float", value=path
            )
        wanted = "float" if kind is np.float32 else str(spec.format)
        pixels = source.read_image(page, 0, 0, spec.nchannels, wanted)
        if pixels is None or source.has_error:
            raise damaged_error(path)
        others = _count_others(source) if count else 0
    finally:
        source.close()
    return Decoded(
        pixels.reshape(spec.height, spec.width, -1).astype(kind, copy=False),
        _channel_names(spec),
        profile=bytes(np.asarray(spec.getattribute("ICCProfile")).tobytes()) if "ICCProfile" in spec else b"",
        space=_stated_space(spec),
        orientation=spec.get_int_attribute("Orientation", 1),
    ).noting(say_others(others))


def _refusal(path: Path) -> TilewrightFileError:
    """Why a file could not be opened, without a library's own words."""
    import OpenImageIO as oiio

    try:
        reason = oiio.geterror()
    except UnicodeDecodeError:  # it quotes damaged bytes
        return damaged_error(path)
    if "exceeds" in reason:
        return TilewrightFileError(
            f"{path} states a size of more than 1,048,576 pixels on a side or 32 GB", value=path
        )
    return unknown_error(path)


def _count_others(source: Any) -> int:
    others = 0
    while source.seek_subimage(others + 1, 0):
        others += 1
    return others


def _channel_names(spec: Any) -> tuple[str, ...]:
    """R, G, B, A and Y where a channel is one of these, also as a part of a layer."""
    names = tuple(str(name) for name in spec.channelnames)
    short = tuple(name.rpartition(".")[2].upper() for name in names)
    if len(names) == 1:
        return ("Y",)
    plain = tuple(s if s in "RGBAY" and names.count(n) == 1 else n for n, s in zip(names, short, strict=True))
    return plain if len(set(plain)) == len(plain) else names


def _stated_space(spec: Any) -> RgbSpace | None:
    """The primaries that an EXR file states, of linear light."""
    stated = spec.getattribute("chromaticities")
    if stated is None or len(stated) != 8:
        return None
    return space_of("the primaries that it states", tuple(float(v) for v in stated), gamma_curve(1.0))


def by_pillow(path: Path, data: bytes | None = None, page: int = 0) -> Decoded:
    """A picture of a file by Pillow, upright; ``data`` are its bytes where they were mended."""
    from PIL import Image

    usual, Image.MAX_IMAGE_PIXELS = Image.MAX_IMAGE_PIXELS, _MOST_PIXELS
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of sizes, and of pieces of metadata that are damaged
            with Image.open(path if data is None else io.BytesIO(data)) as image:
                if page:
                    image.seek(page)
                profile = image.info.get("icc_profile") or b""
                if image.mode == "LAB":
                    return Decoded(lab_to_srgb(np.array(image)), PICTURE_CHANNELS[3])
                sizes = len(image.info.get("sizes", ()))
                frames = 1 if image.format in _COUNTED_ELSEWHERE else getattr(image, "n_frames", 1)
                pixels = as_pixels(str(path), image)
    except TilewrightError:
        raise
    except Image.UnidentifiedImageError:
        raise unknown_error(path) from None
    except Image.DecompressionBombError:
        raise TilewrightFileError(f"{path} states a size of more than 2^31 pixels", value=path) from None
    except Exception:  # each of its decoders has its own errors
        raise damaged_error(path) from None
    finally:
        Image.MAX_IMAGE_PIXELS = usual
    note = f"holds {sizes} sizes; the largest is taken" if sizes > 1 else say_others(frames - 1)
    return Decoded(pixels, PICTURE_CHANNELS[pixels.shape[-1]], profile=profile).noting(note)
