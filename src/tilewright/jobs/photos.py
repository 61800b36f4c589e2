"""Photographs as they are brought: which maps there are, and the pixels of each."""

import warnings
from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError, TilewrightWarning
from tilewright.files.atomic import AnyPath
from tilewright.files.images import open_picture
from tilewright.files.map_stack import find_maps
from tilewright.pixels import has_alpha
from tilewright.signals.textures.exemplar import check_map
from tilewright.signals.textures.kinds import guess_kind

if TYPE_CHECKING:
    import PIL.Image

Picture = Union[AnyPath, NDArray[Any], "PIL.Image.Image"]
"""A file, an array of shape (h, w) or (h, w, channels), or a Pillow image."""
Photo = Picture | Mapping[str, Picture]


def list_maps(photo: Photo, what: str) -> Mapping[str, Picture]:
    """The pictures of a photograph by the names of their maps; ``what`` it is, for messages."""
    if isinstance(photo, Mapping):
        if not photo:
            raise TilewrightValueError("is an empty dict; at least one map is needed", argument=what)
        return photo
    if isinstance(photo, PathLike | str) and Path(photo).is_dir():
        return find_maps(photo)
    return {"albedo": photo}


def open_maps(photo: Photo, what: str, kinds: Mapping[str, str] | None) -> dict[str, NDArray[Any]]:
    """The pixels of every map; those that hold no color, by ``kinds`` or by name, as they are in the file."""
    maps = list_maps(photo, what)
    alone = not isinstance(photo, Mapping)
    return {
        name: _open_map(picture, what if alone else f"map {name!r}", _holds_color(name, kinds))
        for name, picture in maps.items()
    }


def _holds_color(name: Any, kinds: Any) -> bool:
    """Whether a map is one of color; what is wrong with names and kinds is said where they are checked."""
    told = kinds.get(name) if isinstance(kinds, Mapping) else None
    return (told or guess_kind(str(name))) == "color"


def _open_map(picture: Picture, what: str, color: bool) -> NDArray[Any]:
    """A map, checked at once, so that what is wrong with a file is said with its name."""
    from_file = isinstance(picture, PathLike | str)
    name = str(picture) if from_file else what
    pixels = check_map(name, open_picture(what, picture, color=color))
    if from_file:
        _warn_of_emptiness(name, pixels, color)
    return pixels


def _warn_of_emptiness(name: str, pixels: NDArray[Any], color: bool) -> None:
    """Say where a file shows nothing, which is more likely a file's fault than what was wanted."""
    if color and has_alpha(pixels.shape[-1]) and not pixels[..., -1].any():
        said = "is transparent everywhere; save it without alpha if that is not meant"
    # A few pixels are enough to see that most pictures are none of this kind.
    elif (pixels[::61, ::61] == pixels[0, 0]).all() and (pixels == pixels[0, 0]).all():
        value = pixels[0, 0] if np.ptp(pixels[0, 0]) else pixels[0, 0, :1]
        said = f"is {', '.join(f'{number:g}' for number in value)} everywhere"
    else:
        return
    warnings.warn(f"{name} {said}", TilewrightWarning, stacklevel=2)
