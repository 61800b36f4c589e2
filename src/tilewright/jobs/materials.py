"""From photographs to texture tiles: opens what a person brings and synthesizes."""

from dataclasses import replace
from typing import Any

from tilewright.checks import check_type
from tilewright.errors import TilewrightValueError
from tilewright.jobs.sources import Meaning, Photo, Picture, open_masks, prepare
from tilewright.seeds import Seed
from tilewright.signals.textures import Exemplar, TextureTiles
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
        `find_maps`, and must have color. Maps that hold several, such as ``"orm"``, are taken apart. Sizes
        may differ by powers of two: smaller maps are enlarged.
    second : path, array, Pillow image or dict, optional
        A second photograph in the same forms, the source of the marked corners of an inhomogeneous set; by
        default there is none.
    mask : path, array or Pillow image, optional
        Pixels of ``photo`` that may be copied: those at least half as bright as white; by default all, but
        for transparent parts of a photograph in which alpha is no pattern.
    second_mask : path, array or Pillow image, optional
        Pixels of ``second`` that may be copied; by default all.
    weights : dict of map name to float, optional
        How much a map counts when patches are matched and cut, 0 to 1,000,000; by default 1 for color and 0.1
        for others.
    kinds : dict of map name to kind, optional
        What maps hold: ``"color"``, ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` or
        ``"normal-dx"``; by default told by their names. Packed maps that are named here stay in one.
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
        A file is not a whole image, or a folder is no one material with color, see `find_maps`.
    TilewrightTypeError
        A picture or option of another type.
    TilewrightValueError
        Maps that cannot belong together: sizes, NaN, a map of normals that holds none; or a name that is no
        folder on some system.

    Warns
    -----
    TilewrightWarning
        The direction of green in a map of normals was found and not given; transparent places, or parts of
        a packed map, are left out; a file states what is not heeded or was converted, as in `read_image`; a
        picture has one value everywhere.
    """
    if second is None and second_mask is not None:
        raise TilewrightValueError(
            "is for a second photograph", argument="second_mask", advice="give second too"
        )
    meaning = Meaning(kinds, normal, flatten, weights)
    prepared, settled = prepare([photo] if second is None else [photo, second], meaning)
    return Exemplar(prepared, open_masks([mask, second_mask], prepared, settled), weights, settled)


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
    prepared, settled = prepare(photos, Meaning(kinds, normal, flatten, beside=material.maps), sizes)
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
    seed: Seed = 0,
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
    seed : int or numpy.random.Generator, optional
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
