"""From photographs to texture tiles: opens what a person brings and synthesizes."""

from collections.abc import Mapping
from dataclasses import replace
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice, check_type, type_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.files.images import open_picture
from tilewright.files.map_stack import tell_green
from tilewright.jobs.photos import Photo, Picture, list_maps, open_maps
from tilewright.pixels import white, without_alpha
from tilewright.signals.textures import Exemplar, TextureTiles
from tilewright.signals.textures.exemplar import check_kinds
from tilewright.signals.textures.kinds import is_normal
from tilewright.signals.textures.tone import take_more_tone
from tilewright.tiles import TileSet, corner_tiles


def open_exemplar(
    photo: Photo,
    *,
    second: Photo | None = None,
    mask: Picture | None = None,
    second_mask: Picture | None = None,
    weights: dict[str, float] | None = None,
    kinds: dict[str, str] | None = None,
    normal: str | None = None,
    flatten: bool = False,
) -> Exemplar:
    """Make an exemplar from files, arrays or Pillow images.

    Parameters
    ----------
    photo : path, array of shape (h, w) or (h, w, channels), Pillow image, or dict of map name to these
        A single picture becomes the map ``"albedo"``; a folder gives the maps that its file names tell, see
        `find_maps`. Sizes may differ by powers of two: smaller maps are enlarged.
    second : path, array, Pillow image or dict, optional
        A second photograph in the same forms, the source of the marked corners of an inhomogeneous set; by
        default there is none.
    mask : path, array or Pillow image, optional
        Pixels of ``photo`` that may be copied: those at least half as bright as white; by default all.
    second_mask : path, array or Pillow image, optional
        Pixels of ``second`` that may be copied; by default all.
    weights : dict of map name to float, optional
        How much a map counts when patches are matched and cut, 0 to 1,000,000; by default 1 for color and 0.1
        for others.
    kinds : dict of map name to kind, optional
        What maps hold: ``"color"``, ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` or
        ``"normal-dx"``; by default told by their names.
    normal : str, optional
        ``"gl"`` or ``"dx"``: whether green points up or down in maps of normals; by default found from the
        height map, or from the slopes of the normals themselves, and said in a warning.
    flatten : bool, optional
        Take out of color maps the light that varies slowly, which makes repetition visible; default False.

    Returns
    -------
    Exemplar
        The maps with their masks, weights and kinds.

    Raises
    ------
    TilewrightFileError
        A file is not a whole image, or a folder has no maps that can be told by name.
    TilewrightTypeError
        A picture or option of another type.
    TilewrightValueError
        Maps that cannot belong together: sizes, NaN, a map of normals that holds none.

    Warns
    -----
    TilewrightWarning
        The direction of green in a map of normals was found and not given; a file states what is not heeded
        or was converted, as in `read_image`; a picture has one value everywhere.
    """
    if second is None and second_mask is not None:
        raise TilewrightValueError(
            "is for a second photograph", argument="second_mask", advice="give second too"
        )
    meaning = _Meaning(kinds, normal, flatten)
    prepared, settled = _prepare([photo] if second is None else [photo, second], meaning)
    masks = [_open_mask(mask)] + ([] if second is None else [_open_mask(second_mask)])
    return Exemplar(
        prepared, [_fit_mask(m, p) for m, p in zip(masks, prepared, strict=True)], weights, settled
    )


def add_maps(
    material: TextureTiles,
    photo: Photo,
    *,
    second: Photo | None = None,
    kinds: dict[str, str] | None = None,
    normal: str | None = None,
    flatten: bool = False,
) -> TextureTiles:
    """Cut further maps of the same photograph as a material was cut.

    Parameters
    ----------
    material : TextureTiles
        Where every pixel came from is read from ``material.origins``; nothing is decided anew.
    photo : path, array, Pillow image, or dict of map name to these
        New maps; one of a name that is there replaces it. Sizes may differ from the photograph's by powers
        of two.
    second : path, array or dict of map name to either, optional
        The same maps of the second photograph, where the material has two.
    kinds : dict of map name to kind, optional
        What maps hold, as in `open_exemplar`; by default told by their names.
    normal : str, optional
        ``"gl"`` or ``"dx"``, as in `open_exemplar`; by default found from the maps.
    flatten : bool, optional
        Take out of color maps the light that varies slowly; default False.

    Returns
    -------
    TextureTiles
        The material with the maps. They count nothing in its recipe, so `resynthesize` makes the same cuts.

    Raises
    ------
    TilewrightFileError
        A file is not a whole image, or a folder has no maps that can be told by name.
    TilewrightTypeError
        Something else than texture tiles and pictures.
    TilewrightValueError
        Maps for another number of photographs, or of a size that does not go with the photograph's.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> photo = np.random.default_rng(1).integers(0, 256, (64, 64, 3), np.uint8)
    >>> material = tw.texture_tiles(photo, tw.corner_tiles(2), tile_size=16)
    >>> material = tw.add_maps(material, {"height": photo[..., 0]})
    >>> material.maps["height"].shape
    (16, 16, 16, 1)
    """
    from tilewright.signals.textures.seams import copy_maps

    check_type("material", material, TextureTiles, "TextureTiles")
    if (second is not None) != (len(material.sources) == 2):
        raise TilewrightValueError(
            f"the material is made from {len(material.sources)} photographs",
            advice="give maps for each of them",
        )
    sizes = [next(iter(s.values())).shape[:2] for s in material.sources]
    photos = [photo] if second is None else [photo, second]
    prepared, settled = _prepare(photos, _Meaning(kinds, normal, flatten), sizes)
    new = Exemplar(prepared, material.masks or None, None, settled)
    tone, held = take_more_tone(material.tone, new)
    maps = copy_maps(held.sources, material.origins, new.kinds, material.tiles, material.variants)
    recipe = dict(material.recipe)
    if isinstance(recipe.get("weights"), dict):
        recipe["weights"] = dict.fromkeys(new.kinds, 0.0) | recipe["weights"]
    return replace(
        material,
        recipe=recipe,
        tone=tone,
        maps=material.maps | maps,
        sources=tuple(old | added for old, added in zip(material.sources, new.sources, strict=True)),
        kinds=material.kinds | new.kinds,
    )


class _Meaning:
    """What was said of the maps: their kinds, which way green points, whether light is to be flattened."""

    def __init__(self, kinds: Mapping[str, str] | None, normal: str | None, flatten: bool) -> None:
        if normal is not None:
            check_choice("normal", normal, ("gl", "dx"))
        if not isinstance(flatten, bool):
            raise type_error("flatten", flatten, "True or False")
        self.kinds, self.normal, self.flatten = kinds, normal, flatten

    def known(self, photo: Photo, maps: Mapping[str, NDArray[Any]]) -> dict[str, str]:
        """Kinds that need no guess: told by a file's name, by ``normal``, by ``kinds``."""
        normals = [name for name, kind in check_kinds(self.kinds, maps).items() if is_normal(kind)]
        files = {n: Path(p) for n, p in list_maps(photo, "photo").items() if isinstance(p, PathLike | str)}
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


def _prepare(
    photos: list[Photo], meaning: _Meaning, sizes: list[tuple[int, int]] | None = None
) -> tuple[list[dict[str, NDArray[Any]]], dict[str, str]]:
    """The maps of every source in one size, normals whole, light even; and what each map holds."""
    from tilewright.signals.textures.preparation import turn_green

    prepared = []
    kinds: dict[str, str] = {}
    for number, photo in enumerate(photos):
        maps = open_maps(photo, ("photo", "second")[number], meaning.kinds)
        maps, found = _prepare_one(photo, maps, meaning, sizes[number] if sizes else None, number)
        # The second photograph's normals are turned where they point the other way than the first's.
        for name, kind in found.items():
            if is_normal(kind) and kinds.setdefault(name, kind) != kind:
                maps[name] = turn_green(maps[name])
            kinds.setdefault(name, kind)
        prepared.append(maps)
    return prepared, kinds


def _prepare_one(
    photo: Photo,
    maps: dict[str, NDArray[Any]],
    meaning: _Meaning,
    size: tuple[int, int] | None,
    number: int,
) -> tuple[dict[str, NDArray[Any]], dict[str, str]]:
    from tilewright.signals.textures.preparation import (
        flatten_light,
        match_sizes,
        mend_normals,
        settle_normals,
    )

    known = meaning.known(photo, maps)
    kinds = check_kinds(known, maps)
    maps = match_sizes(maps, kinds, size)
    for name, kind in kinds.items():
        if is_normal(kind):
            maps[name] = mend_normals(maps[name], kind, name)
        elif meaning.flatten and kind == "color":
            maps[name] = flatten_light(maps[name])
    return maps, settle_normals(maps, kinds, set(known), " of the second photograph" if number else "")


def texture_tiles(
    photo: Photo,
    tiles: TileSet | None = None,
    *,
    second: Photo | None = None,
    mask: Picture | None = None,
    second_mask: Picture | None = None,
    weights: dict[str, float] | None = None,
    kinds: dict[str, str] | None = None,
    normal: str | None = None,
    flatten: bool = False,
    tile_size: int | str | None = None,
    seed: int = 0,
    **options: Any,
) -> TextureTiles:
    """Make texture tiles from a photograph, or from a stack of maps.

    Parameters
    ----------
    photo : path, array of shape (h, w) or (h, w, channels), or dict of map name to either
        A single picture becomes the map ``"albedo"``; a folder gives the maps that its file names tell, see
        `find_maps`. Arrays hold uint8, uint16 or float32; other types are turned into these as `Exemplar`
        says, and other libraries' arrays are taken by ``__array__`` or ``__dlpack__``.
    tiles : TileSet, optional
        Corner, corner-coded or Wang tiles; by default those that suit the photograph, and with an older
        ``method`` the complete corner set over 2 colors, over 4 with two photographs.
    second : path, array or dict, optional
        A second photograph for the marked corners of an inhomogeneous set; by default there is none.
    mask : path or array, optional
        Pixels of ``photo`` that may be copied: those at least half as bright as white; by default all.
    second_mask : path or array, optional
        Pixels of ``second`` that may be copied; by default all.
    weights : dict of map name to float, optional
        How much a map counts when patches are matched and cut, 0 to 1,000,000; by default 1 for color and 0.1
        for others.
    kinds : dict of map name to kind, optional
        What maps hold, as in `open_exemplar`; by default told by their names.
    normal : str, optional
        ``"gl"`` or ``"dx"``, as in `open_exemplar`; by default found from the maps.
    flatten : bool, optional
        Take out of color maps the light that varies slowly; default False.
    tile_size : int or "auto", optional
        Pixels along a tile, even, 16 to 1,024; by default what suits the photograph. Older methods take 128,
        and with ``"auto"`` a size near it that is a whole number of the photograph's periods.
    seed : int, optional
        The same seed gives the same bytes; 0 to 2^64 - 1, default 0.
    **options : str, bool, dict, int or callable
        ``method``, ``tone``, ``variants``, ``pick``, ``reject``, ``threads`` and ``progress``, as in
        `synthesize`.

    Returns
    -------
    TextureTiles
        Pictures for each tile of the set, and where each of their pixels was copied from.

    Raises
    ------
    TilewrightFileError
        A file is not a whole image.
    TilewrightTypeError
        A picture or option of another type.
    TilewrightValueError
        A picture, size or option that cannot be used; the message names it and what is allowed.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> photo = np.random.default_rng(1).integers(0, 256, (64, 64, 3), np.uint8)
    >>> material = tw.texture_tiles(photo, tw.corner_tiles(2), tile_size=16, seed=1)
    >>> material.pixels.shape
    (16, 16, 16, 3)
    >>> source, y, x = material.origins[3, 10, 5]
    >>> bool((material.pixels[3, 10, 5] == photo[y, x]).all())
    True
    """
    from tilewright.signals.textures import synthesize

    exemplar = open_exemplar(
        photo,
        second=second,
        mask=mask,
        second_mask=second_mask,
        weights=weights,
        kinds=kinds,
        normal=normal,
        flatten=flatten,
    )
    if tiles is None and options.get("method") not in (None, "faithful"):
        tiles = corner_tiles(2 if second is None else 4)
    return synthesize(exemplar, tiles, tile_size=tile_size, seed=seed, **options)


def _fit_mask(mask: NDArray[np.bool_] | None, maps: Mapping[str, NDArray[Any]]) -> NDArray[np.bool_] | None:
    """A mask at the size of the maps, where it was made for smaller ones."""
    height, width = next(iter(maps.values())).shape[:2]
    if mask is None or mask.ndim != 2 or not mask.size:
        return mask
    times = height // mask.shape[0]
    if (mask.shape[0] * times, mask.shape[1] * times) != (height, width):
        return mask  # which is refused with both sizes named
    return mask.repeat(times, axis=0).repeat(times, axis=1)


def _open_mask(mask: Picture | None) -> NDArray[np.bool_] | None:
    if mask is None:
        return None
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
    half = white(pixels.dtype) / 2
    if pixels.ndim == 3:  # gray or color, either of them with alpha, which does not count
        pixels = without_alpha(pixels).mean(axis=2)
    return pixels >= half
