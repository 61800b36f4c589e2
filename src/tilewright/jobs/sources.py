"""What a person brings for a texture, opened and brought together: pictures, maps, folders, masks."""

import warnings
from collections.abc import Collection, Mapping
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice, type_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError, TilewrightWarning
from tilewright.files.atomic import AnyPath
from tilewright.files.images import open_picture
from tilewright.files.map_stack import check_color, find_maps, holds_maps, tell_green
from tilewright.pixels import has_alpha, mean_gray, white
from tilewright.signals.textures.exemplar import check_kinds, check_map
from tilewright.signals.textures.kinds import guess_kind, is_normal, is_signed
from tilewright.signals.textures.naming import check_new_names

if TYPE_CHECKING:
    import PIL.Image

Picture = Union[AnyPath, NDArray[Any], "PIL.Image.Image"]
"""A file, an array of shape (h, w) or (h, w, channels), or a Pillow image."""
Photo = Picture | Mapping[str, Picture]


class Meaning:
    """What was said of the maps: their kinds, which way green points, whether light is to be flattened.

    ``named`` are maps that were spoken of by name, and so stay what they are, packed ones too; ``beside``
    those to which others are added.
    """

    def __init__(
        self,
        kinds: Mapping[str, str] | None,
        normal: str | None,
        flatten: bool,
        named: Collection[str] | None = None,
        beside: Collection[str] = (),
    ) -> None:
        if normal is not None:
            check_choice("normal", normal, ("gl", "dx"))
        if not isinstance(flatten, bool):
            raise type_error("flatten", flatten, "True or False")
        self.kinds, self.normal, self.flatten = kinds, normal, flatten
        given = (kinds, named, beside)
        self.named = {name for names in given if isinstance(names, Collection) for name in names}
        self.beside = beside

    def known(self, listed: Mapping[str, Picture], maps: Mapping[str, NDArray[Any]]) -> dict[str, str]:
        """Kinds that need no guess: told by a file's name, by ``normal``, by ``kinds``."""
        normals = [name for name, kind in check_kinds(self.kinds, maps).items() if is_normal(kind)]
        files = {n: Path(p) for n, p in listed.items() if isinstance(p, PathLike | str)}
        told = {name: green for name in normals if name in files and (green := tell_green(files[name]))}
        told |= {name: f"normal-{name[-2:]}" for name in normals if name.lower().endswith(("-dx", "-gl"))}
        if self.normal is not None:
            if not normals:
                raise TilewrightValueError(
                    f"is {self.normal!r}, and none of the maps holds normals: {', '.join(maps)}",
                    argument="normal",
                    value=self.normal,
                )
            told |= dict.fromkeys(normals, f"normal-{self.normal}")
        for name, kind in (self.kinds or {}).items():
            if self.normal is not None and is_normal(kind) and kind != told[name]:
                raise TilewrightValueError(
                    f"is {kind} by kinds and {self.normal} by normal",
                    argument=f"map {name!r}",
                    value=kind,
                    advice="say one",
                )
            told[name] = kind
        return told


def prepare(
    photos: list[Photo], meaning: Meaning, sizes: list[tuple[int, int]] | None = None
) -> tuple[list[dict[str, NDArray[Any]]], dict[str, str]]:
    """The maps of every source in one form and size, normals whole, light even; and what each map holds.

    ``sizes`` are those of the photographs to which maps are added; without, the maps make a material, which
    has color.
    """
    from tilewright.signals.textures.channels import agree_channels
    from tilewright.signals.textures.preparation import turn_green

    prepared = []
    kinds: dict[str, str] = {}
    for number, photo in enumerate(photos):
        listed = list_maps(photo, ("photo", "second")[number], whole=sizes is None)
        maps, found = _prepare_one(listed, photo, meaning, sizes[number] if sizes else None, number)
        # The second photograph's normals are turned where they point the other way than the first's.
        for name, kind in found.items():
            if is_normal(kind) and kinds.setdefault(name, kind) != kind:
                maps[name] = turn_green(maps[name])
            kinds.setdefault(name, kind)
        prepared.append(maps)
    return agree_channels(prepared), kinds


def _prepare_one(
    listed: Mapping[str, Picture],
    photo: Photo,
    meaning: Meaning,
    size: tuple[int, int] | None,
    number: int,
) -> tuple[dict[str, NDArray[Any]], dict[str, str]]:
    from tilewright.signals.textures.channels import restore_blue, unpack_maps
    from tilewright.signals.textures.preparation import (
        flatten_light,
        match_sizes,
        mend_normals,
        settle_normals,
    )

    opened = _open_maps(listed, ("photo", "second")[number], isinstance(photo, Mapping), meaning.kinds)
    check_new_names(opened, meaning.beside)
    maps = unpack_maps(opened, meaning.named)
    known = meaning.known(listed, maps)
    kinds = check_kinds(known, maps)
    normals = [name for name, kind in kinds.items() if is_normal(kind)]
    maps |= {name: restore_blue(maps[name], is_signed(maps[name])) for name in normals}
    maps = match_sizes(maps, kinds, size)
    for name, kind in kinds.items():
        if name in normals:
            maps[name] = mend_normals(maps[name], kind, name)
        elif meaning.flatten and kind == "color":
            maps[name] = flatten_light(maps[name])
    return maps, settle_normals(maps, kinds, set(known), " of the second photograph" if number else "")


def list_maps(photo: Photo, what: str, *, whole: bool = True) -> Mapping[str, Picture]:
    """The picture of each map; ``whole`` where a folder must have a map of color."""
    if isinstance(photo, Mapping):
        if not photo:
            raise TilewrightValueError("is an empty dict; at least one map is needed", argument=what)
        return photo
    if isinstance(photo, PathLike | str) and holds_maps(photo):
        found = find_maps(photo)
        if whole:
            check_color(photo, found)
        return found
    return {"albedo": photo}


def _open_maps(
    listed: Mapping[str, Picture], what: str, by_name: bool, kinds: Mapping[str, str] | None
) -> dict[str, NDArray[Any]]:
    """The pixels of every map; those that hold no color, by ``kinds`` or by name, as they are in the file."""
    return {
        name: _open_map(picture, f"map {name!r}" if by_name else what, _holds_color(name, kinds))
        for name, picture in listed.items()
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
        _warn_of_one_value(name, pixels)
    return pixels


def _warn_of_one_value(name: str, pixels: NDArray[Any]) -> None:
    """Say where a file shows nothing, which is more likely a file's fault than what was wanted."""
    # A few pixels are enough to see that most pictures are none of this kind.
    if (pixels[::61, ::61] != pixels[0, 0]).any() or (pixels != pixels[0, 0]).any():
        return
    value = pixels[0, 0] if np.ptp(pixels[0, 0]) else pixels[0, 0, :1]
    said = ", ".join(f"{number:g}" for number in value)
    warnings.warn(f"{name} is {said} everywhere", TilewrightWarning, stacklevel=2)


def open_masks(
    given: list[Picture | None], prepared: list[dict[str, NDArray[Any]]], kinds: Mapping[str, str]
) -> list[NDArray[np.bool_] | None]:
    """For each photograph the pixels that may be copied: as given, else those that are there."""
    from tilewright.signals.textures.transparency import find_there

    return [
        find_there(maps, kinds, f"the {which}photograph")
        if mask is None
        else _fit_mask(_open_mask(mask), maps)
        for which, mask, maps in zip(("", "second "), given, prepared, strict=False)
    ]


def _fit_mask(mask: NDArray[np.bool_], maps: Mapping[str, NDArray[Any]]) -> NDArray[np.bool_]:
    """A mask at the size of the maps, where it was made for smaller ones."""
    height, width = next(iter(maps.values())).shape[:2]
    if mask.ndim != 2 or not mask.size:
        return mask
    times = height // mask.shape[0]
    if (mask.shape[0] * times, mask.shape[1] * times) != (height, width):
        return mask  # which is refused with both sizes named
    return mask.repeat(times, axis=0).repeat(times, axis=1)


def _open_mask(mask: Picture) -> NDArray[np.bool_]:
    pixels = open_picture("mask", mask, color=False)
    if pixels.dtype == bool:
        return pixels
    if pixels.dtype.kind not in "uf" or not np.isfinite(pixels).all():
        raise TilewrightTypeError(
            f"holds {pixels.dtype}; allowed are bool, unsigned integers, and floats without NaN",
            argument="mask",
            value=pixels.dtype,
            allowed="bool, unsigned integers, and floats without NaN",
        )
    bright = mean_gray(pixels) if pixels.ndim == 3 else pixels.astype(np.float64)
    if pixels.ndim == 3 and has_alpha(pixels.shape[2]):  # what is not there is not white
        bright = bright * (pixels[..., -1] / white(pixels.dtype))
    usable = bright >= white(pixels.dtype) / 2
    if pixels.ndim == 3 and not usable.any() and has_alpha(pixels.shape[2]) and np.ptp(pixels[..., -1]) > 0:
        raise TilewrightValueError(
            "is black everywhere, and its shape lies in alpha",
            argument="mask",
            advice="make it white where pixels may be copied",
        )
    return usable
