"""What channels, numbers and names of pictures mean: alpha, gray, luminance, hex colors, words of map names.

Pixels are arrays of shape (..., channels) with 1 to 4 channels: gray, gray and alpha, color, color and alpha.
"""

import os
import re
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import type_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError

LUMA = (0.299, 0.587, 0.114)
"""Weights of red, green and blue by Rec. ITU-R BT.601: how light encoded colors look.

Mikkelsen's hex-tiling weighs linear light by them too (JCGT 11 (2), 2022), and so do we there.
"""
LUMINANCE = (0.2126, 0.7152, 0.0722)
"""The same by Rec. ITU-R BT.709, whose primaries are those of sRGB."""


def has_alpha(channels: int) -> bool:
    """Whether the last of so many channels is alpha, where the first ones hold light."""
    return channels in (2, 4)


def without_alpha(pixels: NDArray[Any]) -> NDArray[Any]:
    """A view of the gray or the three colors of pixels."""
    return pixels[..., : 1 if pixels.shape[-1] < 3 else 3]


def white(kind: np.dtype[Any]) -> int:
    """The number that stands for 1: the largest of an integer type, 1 of floats and bool."""
    return int(np.iinfo(kind).max) if kind.kind in "iu" else 1


def as_rgb(pixels: NDArray[Any]) -> NDArray[Any]:
    """Three channels: gray is repeated, alpha left out."""
    colors = without_alpha(pixels)
    return colors if colors.shape[-1] == 3 else np.repeat(colors, 3, axis=-1)


def as_rgba(pixels: NDArray[Any], kind: np.dtype[Any] | None = None) -> NDArray[Any]:
    """Four channels, of type ``kind`` where given: gray is repeated, alpha kept or full."""
    out = np.empty((*pixels.shape[:-1], 4), kind or pixels.dtype)
    out[..., :3] = without_alpha(pixels)
    out[..., 3] = pixels[..., -1] if has_alpha(pixels.shape[-1]) else white(out.dtype)
    return out


def on_paper(pixels: NDArray[Any]) -> NDArray[Any]:
    """Gray or color as a drawing shows it: where nothing is drawn, there is white paper.

    Where all that is drawn has one color, its shape lies in alpha, and paper shines through as far as alpha
    is less than full; under a light drawing it is black. Others keep their color wherever they have any.

    Parameters
    ----------
    pixels : float array, shape (..., channels)
        From 0 to 1; alpha is straight.
    """
    colors = without_alpha(pixels)
    if not has_alpha(pixels.shape[-1]):
        return colors
    alpha = pixels[..., -1:]
    drawn = colors[alpha[..., 0] > 0]
    if drawn.size and np.ptp(drawn, axis=0).max() == 0:
        return colors * alpha + (1 - alpha) * float(drawn[0].mean() <= 0.5)
    return np.where(alpha > 0, colors, 1.0)


def mean_gray(pixels: NDArray[Any]) -> NDArray[np.float64]:
    """The mean of the colors, in the numbers of the pixels, shape (...)."""
    return np.asarray(without_alpha(pixels).mean(axis=-1, dtype=np.float64))


def as_pixels(name: str, given: Any) -> Any:
    """The pixels of a Pillow image, and of what offers its numbers as an array; others as they are.

    Pixels of a Pillow image come as `tilewright.read_image` gives those of the file: upright, palettes
    expanded, 8 bit as uint8, 16 bit as uint16, floats as float32.

    Parameters
    ----------
    name : str
        What the picture is called where it is refused.
    given : Pillow image, array or array-like
        The picture. Tensors and labelled arrays of other libraries are taken by ``__array__``,
        ``__array_interface__`` or ``__dlpack__``, whichever is there first.

    Returns
    -------
    array or array-like
        The pixels of a Pillow image, shape (height, width, channels); the numbers of an array; others as they
        came.

    Raises
    ------
    TilewrightTypeError
        A path, which is to be opened where files are read; a Pillow image of another kind; an array whose
        numbers are not at hand, as on a GPU.
    """
    if isinstance(given, (str, os.PathLike)):
        raise TilewrightTypeError(
            "must be an array or a Pillow image, not a path",
            argument=name,
            value=given,
            allowed="an array or a Pillow image",
            advice=f"open it: tilewright.read_image({os.fspath(given)!r})",
        )
    return _read_pillow(name, given) if is_pillow(given) else _read_protocol(name, given)


def _read_protocol(name: str, given: Any) -> Any:
    """The numbers of another library's array as a NumPy array; what offers none as it came."""
    if isinstance(given, np.ndarray):
        return given
    try:
        if hasattr(given, "__array__") or hasattr(given, "__array_interface__"):
            return np.asarray(given)
        return np.from_dlpack(given) if hasattr(given, "__dlpack__") else given
    except Exception:  # each library has its own errors for what lies on a GPU or has a gradient
        raise TilewrightTypeError(
            f"is a {type(given).__name__} whose numbers NumPy cannot take",
            argument=name,
            value=type(given).__name__,
            advice="pass it as a NumPy array, as by .detach().cpu().numpy()",
        ) from None


def as_texels(name: str, pixels: NDArray[Any]) -> NDArray[Any]:
    """Numbers of a type that pictures have: uint8, uint16 or float32.

    Parameters
    ----------
    name : str
        What the picture is called where it is refused.
    pixels : array
        Floats of 16 or 64 bits become float32; bool becomes uint8, 0 or 255; other integers become uint8
        where all lie from 0 to 255, else uint16 where all lie from 0 to 65535.

    Returns
    -------
    array
        The same numbers.

    Raises
    ------
    TilewrightTypeError
        Other integers, or another type.
    """
    if pixels.dtype in (np.uint8, np.uint16, np.float32):
        return pixels
    if pixels.dtype in (np.float64, np.float16):
        with np.errstate(over="ignore"):  # what does not fit becomes infinite, and is refused as that
            return pixels.astype(np.float32)
    if pixels.dtype == bool:
        return pixels.astype(np.uint8) * np.uint8(255)
    if pixels.dtype.kind in "iu":
        return _as_small_integers(name, pixels)
    allowed = "uint8, uint16, float32, and bool, integers and floats that fit into these"
    raise TilewrightTypeError(
        f"has type {pixels.dtype}; allowed are {allowed}",
        argument=name,
        value=pixels.dtype,
        allowed=allowed,
    )


def _as_small_integers(name: str, pixels: NDArray[Any]) -> NDArray[Any]:
    low, high = (int(pixels.min()), int(pixels.max())) if pixels.size else (0, 0)
    if low < 0 or high > 65535:
        raise TilewrightTypeError(
            f"has type {pixels.dtype} and holds {low} to {high}; allowed are integers from 0 to 65535",
            argument=name,
            value=(low, high),
            allowed="integers from 0 to 65535",
            advice="scale them, or pass float32 from 0 to 1",
        )
    return pixels.astype(np.uint8 if high <= 255 else np.uint16)


def is_pillow(given: Any) -> bool:
    """Whether this is a Pillow image, told without importing Pillow."""
    return any(c.__name__ == "Image" and c.__module__ == "PIL.Image" for c in type(given).__mro__)


def _read_pillow(name: str, image: Any) -> NDArray[Any]:
    from PIL import ImageOps

    image = ImageOps.exif_transpose(image)
    if "transparency" in image.info and image.mode in ("1", "L", "P", "RGB"):
        image = image.convert("LA" if image.mode in ("1", "L") else "RGBA")
    mode = _PILLOW_MODES.get(image.mode)
    if mode is None:
        raise TilewrightTypeError(
            f"is a Pillow image of mode {image.mode}; allowed are {', '.join(_PILLOW_MODES)}",
            argument=name,
            value=image.mode,
            allowed=", ".join(_PILLOW_MODES),
        )
    pixels = np.asarray(image if image.mode == mode else image.convert(mode))
    if image.mode.startswith("I"):  # how Pillow opens 16-bit gray
        if pixels.min() < 0 or pixels.max() > 65535:
            raise TilewrightTypeError(
                "is a Pillow image of 32-bit integers beyond 16 bits", argument=name, allowed="0 to 65535"
            )
        pixels = pixels.astype(np.uint16)
    return pixels.reshape(image.height, image.width, -1)


_PILLOW_MODES = {
    **{"1": "L", "L": "L", "LA": "LA", "La": "LA", "P": "RGB", "PA": "RGBA"},
    **{"RGB": "RGB", "RGBX": "RGB", "RGBA": "RGBA", "RGBa": "RGBA"},
    **{"CMYK": "RGB", "YCbCr": "RGB", "HSV": "RGB", "LAB": "RGB"},
    **{"I;16": "I;16", "I;16L": "I;16L", "I;16B": "I;16B", "I;16N": "I;16N", "I": "I", "F": "F"},
}
"""What images of each mode are turned into."""


def read_hex(color: Any) -> tuple[int, int, int]:
    """Red, green and blue, 0 to 255, of a color such as ``"#27548f"``."""
    if not isinstance(color, str):
        raise type_error("a color", color, "a str such as '#27548f'")
    if not re.fullmatch("#[0-9a-fA-F]{6}", color):
        allowed = "'#' and six digits, as '#27548f'"
        raise TilewrightValueError(
            f"is {color!r}; expected {allowed}", argument="a color", value=color, allowed=allowed
        )
    red, green, blue = bytes.fromhex(color[1:])
    return red, green, blue


class MapWords(NamedTuple):
    """The words by which a map of a material is told.

    Three readers know them, and they differ in how sure they must be.

    Attributes
    ----------
    kind : str
        What such a map holds: `tilewright.signals.textures.kinds.guess_kind` looks for ``words`` in a name
        that a person gave, where something must be found.
    endings : tuple of str
        Whole endings of file names by which `tilewright.find_maps` takes a file into a material, which it
        must not do wrongly.
    words : tuple of str
        Single words, or the beginnings of longer ones where they have more than three letters.
    slot : str
        A regular expression: parts of names for which an engine's surface has a slot of this name.
    """

    kind: str
    endings: tuple[str, ...] = ()
    words: tuple[str, ...] = ()
    slot: str = ""


MAP_WORDS = {
    "albedo": MapWords(
        "color",
        (
            *("color", "colour", "col", "diff", "dif", "diffuse", "albedo", "alb", "basecolor", "base_color"),
            *("basecolour", "base_colour", "basemap", "albedotransparency"),
        ),
        ("albedo", "color", "colour", "col", "diffuse", "diff", "basecolor"),
    ),
    "normal": MapWords(
        "normal-gl",
        (
            *("normal", "normals", "nor", "nrm", "norm", "normalgl", "normal_gl", "nor_gl", "nrm_gl"),
            *("normal_opengl", "normalogl", "normal_ogl"),
        ),
        ("normal", "normals", "normalgl", "normalogl", "nor", "nrm", "norm", "ogl"),
    ),
    "normal-dx": MapWords(
        "normal-dx", ("normal_dx", "nor_dx", "nrm_dx", "normaldx", "normal_directx"), ("normaldx",)
    ),
    "roughness": MapWords("roughness", ("roughness", "rough", "rgh"), ("roughness", "rough", "rgh")),
    "glossiness": MapWords(
        "data", ("glossiness", "gloss", "smoothness"), ("gloss", "glossiness", "smoothness")
    ),
    "metalness": MapWords(
        "data", ("metalness", "metallic", "metal"), ("metalness", "metallic", "metal"), "metal"
    ),
    "height": MapWords(
        "height",
        ("displacement", "disp", "height", "depth"),
        ("height", "depth", "displacement", "displace", "disp", "elevation"),
        "height|displace|(^|[^a-z])disp([^a-z]|$)|bump|depth",
    ),
    "bump": MapWords("height", ("bump",), ("bump",)),
    "ao": MapWords(
        "data",
        ("ambientocclusion", "ambient_occlusion", "ao", "occlusion", "occ"),
        ("ambientocclusion", "occlusion", "occ", "ao"),
        "occlusion|(^|[^a-z])ao([^a-z]|$)",
    ),
    "cavity": MapWords("data", ("cavity",), ("cavity",)),
    "arm": MapWords("data", ("arm",), ("arm",)),
    "orm": MapWords("data", ("orm", "occlusionroughnessmetallic"), ("orm",)),
    "rma": MapWords("data", ("rma",), ("rma",)),
    "mra": MapWords("data", ("mra",), ("mra",)),
    "metalroughness": MapWords(
        "data",
        ("metalroughness", "metallicroughness", "metalnessroughness"),
        ("metalroughness", "metallicroughness", "metalnessroughness"),
    ),
    "maskmap": MapWords("data", ("maskmap", "mask_map"), ("maskmap",)),
    "metallicsmoothness": MapWords("data", ("metallicsmoothness",), ("metallicsmoothness",)),
    "opacity": MapWords(
        "data", ("opacity", "alpha", "mask"), ("mask", "opacity", "alpha"), "opacity|alpha|mask"
    ),
    "emissive": MapWords(
        "color", ("emission", "emissive", "emit"), ("emissive", "emission"), "(^|[^a-z])emi(ss|t)|glow"
    ),
    "specular": MapWords("data", ("specular", "spec"), ("specular",)),
    "translucency": MapWords("color", ("translucency", "translucent")),
    "others": MapWords("data", (), ("thickness", "index", "curvature")),
}
"""Maps of a material in the order in which a stack of them is listed."""


class Part(NamedTuple):
    """One of the maps that share a picture.

    Attributes
    ----------
    map : str
        Which map it is.
    channel : str
        Where it lies: ``"r"``, ``"g"``, ``"b"`` or ``"a"``.
    inverted : bool
        Whether it is white less what is stored: smoothness is 1 less roughness.
    """

    map: str
    channel: str
    inverted: bool = False


PACKED_MAPS = {
    "glossiness": (Part("roughness", "r", True),),
    "arm": (Part("ao", "r"), Part("roughness", "g"), Part("metalness", "b")),
    "orm": (Part("ao", "r"), Part("roughness", "g"), Part("metalness", "b")),
    "rma": (Part("roughness", "r"), Part("metalness", "g"), Part("ao", "b")),
    "mra": (Part("metalness", "r"), Part("roughness", "g"), Part("ao", "b")),
    "metalroughness": (Part("roughness", "g"), Part("metalness", "b")),
    "maskmap": (Part("metalness", "r"), Part("ao", "g"), Part("roughness", "a", True)),
    "metallicsmoothness": (Part("metalness", "r"), Part("roughness", "a", True)),
}
"""Maps that hold others, channel by channel.

glTF 2.0, section 3.9.2, for roughness in green and metal in blue; the names of Unreal for the orders; Unity's
manual, "Mask and detail maps" of HDRP and "Metallic mode" of the Standard Shader, for smoothness in alpha.
"""


def packed_parts(name: str) -> tuple[Part, ...]:
    """What a map of this name holds in its channels; nothing where it is one map: ``ORM``, ``Mask_Map``."""
    return PACKED_MAPS.get(re.sub("[^a-z]", "", name.lower()), ())
