"""Texture tiles in a tile-set folder: plain images."""

from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from tilewright import __version__
from tilewright.checks import check_choice
from tilewright.errors import TilewrightFileError
from tilewright.files.images import lossless_suffix, read_image, write_image
from tilewright.files.manifest import (
    NEWEST_SCHEMA,
    SCHEMA,
    TONE_SCHEMA,
    VARIANTS_SCHEMA,
    Reader,
    StoredVariants,
    Tiles,
    Writer,
    restore_variants,
    store_variants,
)
from tilewright.signals.textures import TextureTiles
from tilewright.signals.textures.kinds import KINDS
from tilewright.signals.textures.naming import check_map_names
from tilewright.signals.textures.tone import Tone
from tilewright.tiles.variants import Variants


class StoredTone(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True):
    """Tone outside the tiles: tiles from grid point to grid point, and a picture of it for each map."""

    span: int
    maps: dict[str, str]
    means: dict[str, list[float]] = {}
    """For maps of color the mean of each channel; not there before schema 5."""

    @classmethod
    def of(cls, tone: Tone, files: dict[str, str]) -> "StoredTone":
        """The description of tone whose pictures are in files."""
        return cls(tone.span, files, {name: mean.tolist() for name, mean in tone.means.items()})


class TextureManifest(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True):
    """What ``tileset.json`` of a texture holds."""

    schema: int
    program: str
    signal: str
    tile_size: int
    tiles: Tiles
    maps: dict[str, list[str]]
    origins: list[str]
    sources: list[dict[str, str]]
    masks: list[str]
    recipe: dict[str, Any]
    checksums: dict[str, str]
    kinds: dict[str, str] = {}
    """What each map holds; not there in schema 1."""
    variants: StoredVariants = 1
    """Pictures of each tile; not there before schema 3, nor where there is one."""
    tone: StoredTone | None = None
    """What lies over the tiles; not there before schema 4, nor where nothing does."""


def write_texture(folder: Path, material: TextureTiles) -> None:
    """Fill an empty folder."""
    writer = Writer(folder)

    def image(name: str, pixels: NDArray[Any]) -> str:
        name, target = writer.free(name)
        write_image(target, pixels, color=False)
        return writer.seal(name)

    def suffix(pixels: NDArray[Any]) -> str:
        return lossless_suffix(pixels.dtype, pixels.shape[-1])

    stems = _stems(material.variants)
    maps = {
        name: [
            image(f"{safe_stem(name)}/{stem}{suffix(pixels)}", picture)
            for stem, picture in zip(stems, pixels, strict=True)
        ]
        for name, pixels in material.maps.items()
    }
    origins = [
        image(f"origins/{stem}.png", spots) for stem, spots in zip(stems, material.origins, strict=True)
    ]
    sources = [
        {
            name: image(f"exemplar/{s}-{safe_stem(name)}{suffix(pixels)}", pixels)
            for name, pixels in source.items()
        }
        for s, source in enumerate(material.sources)
    ]
    masks = [
        image(f"exemplar/{s}-mask.png", mask[..., np.newaxis].astype(np.uint8) * 255)
        for s, mask in enumerate(material.masks)
    ]
    toned = {} if material.tone is None else material.tone.maps
    tone = {name: image(f"tone/{safe_stem(name)}.exr", texels) for name, texels in toned.items()}
    writer.finish(
        TextureManifest(
            _schema(material),
            f"tilewright {__version__}",
            "texture",
            material.tile_size,
            Tiles.of(material.tiles),
            maps,
            origins,
            sources,
            masks,
            material.recipe,
            writer.checksums,
            material.kinds,
            store_variants(material.variants),
            None if material.tone is None else StoredTone.of(material.tone, tone),
        )
    )


def _schema(material: TextureTiles) -> int:
    """The oldest that tells all of a material."""
    if material.tone is not None:
        numbers = any(material.kinds[name] != "color" for name in material.tone.maps)
        return NEWEST_SCHEMA if material.tone.means or numbers else TONE_SCHEMA
    return SCHEMA if len(material.variants) == len(material.tiles) else VARIANTS_SCHEMA


def _stems(variants: Variants) -> list[str]:
    """Names of the pictures: ``05`` of a tile's first, ``05-1`` of its second."""
    digits = len(str(len(variants.counts) - 1))
    return [
        f"{tile:0{digits}d}" + (f"-{variant}" if variant else "")
        for tile, count in enumerate(variants.counts)
        for variant in range(count)
    ]


def read_texture(folder: Path, manifest: TextureManifest) -> TextureTiles:
    """The material of a folder, every file checked."""
    reader = Reader(folder, manifest.checksums)

    def image(name: str) -> NDArray[Any]:
        return read_image(reader.path(name), color=False)  # as it was written, by any version

    check_map_names(manifest.maps)
    tiles = manifest.tiles.make()
    variants = restore_variants(manifest.variants, tiles)
    size, count = manifest.tile_size, len(variants)
    maps = {n: _stack(n, [image(f) for f in files], count, size) for n, files in manifest.maps.items()}
    origins = _stack("origins", [image(f) for f in manifest.origins], count, size)
    sources = tuple({n: image(f) for n, f in source.items()} for source in manifest.sources)
    masks = tuple(image(f)[..., 0] > 127 for f in manifest.masks)
    _check_sources(sources, masks, maps)
    _check_origins(origins, sources)
    kinds = {n: check_choice(f"kind of map {n!r}", k, KINDS) for n, k in manifest.kinds.items() if n in maps}
    tone = None
    if manifest.tone is not None:
        toned = {n: _texels(n, image(f), maps) for n, f in manifest.tone.maps.items()}
        colors = {n: texels for n, texels in toned.items() if kinds.get(n, "color") == "color"}
        means = {n: _mean(n, mean, colors) for n, mean in manifest.tone.means.items()}
        tone = Tone(size, manifest.tone.span, toned, means)
    return TextureTiles(tiles, maps, sources, origins, manifest.recipe, masks, kinds, variants, tone)


def _texels(name: str, texels: NDArray[Any], maps: dict[str, NDArray[Any]]) -> NDArray[np.float32]:
    """Tone of a map, which has the map's channels and numbers."""
    channels = maps[name].shape[3] if name in maps else 0
    if texels.dtype != np.float32 or texels.shape[2] != channels or not np.isfinite(texels).all():
        raise TilewrightFileError(
            f"tone of {name} is {texels.dtype} {texels.shape}; expected finite float32 of {channels} channels"
        )
    return texels


def _mean(name: str, mean: list[float], colors: dict[str, NDArray[np.float32]]) -> NDArray[np.float32]:
    """The mean of a map of color that has tone, a number for each channel."""
    channels = colors[name].shape[2] if name in colors else 0
    if not channels or len(mean) != channels or not all(0 <= value < np.inf for value in mean):
        raise TilewrightFileError(f"mean of {name} is {mean}; expected {channels} finite numbers from 0 on")
    return np.array(mean, np.float32)


def _stack(name: str, pictures: list[NDArray[Any]], count: int, size: int) -> NDArray[Any]:
    if len(pictures) != count:
        raise TilewrightFileError(f"{name} lists {len(pictures)} pictures; the set has {count}")
    for t, picture in enumerate(pictures):
        if picture.shape != (size, size, pictures[0].shape[2]) or picture.dtype != pictures[0].dtype:
            raise TilewrightFileError(
                f"picture {t} of {name} is {picture.dtype} {picture.shape}; expected {pictures[0].dtype} "
                f"{(size, size, pictures[0].shape[2])}"
            )
    return np.stack(pictures)


def _check_sources(
    sources: tuple[dict[str, NDArray[Any]], ...],
    masks: tuple[NDArray[np.bool_], ...],
    maps: dict[str, NDArray[Any]],
) -> None:
    """Raise unless every source has all maps, of one size, and masks, if any, fit."""
    if not sources or len(masks) not in (0, len(sources)):
        raise TilewrightFileError(
            f"there are {len(sources)} sources and {len(masks)} masks; expected as many"
        )
    for number, source in enumerate(sources):
        if list(source) != list(maps):
            raise TilewrightFileError(f"source {number} has maps {list(source)}; the tiles have {list(maps)}")
        sizes = [pixels.shape[:2] for pixels in (*source.values(), *masks[number : number + 1])]
        if len(set(sizes)) > 1:
            raise TilewrightFileError(f"the maps and mask of source {number} differ in size: {sizes}")
        for name, pixels in source.items():
            if (pixels.dtype, pixels.shape[2]) != (maps[name].dtype, maps[name].shape[3]):
                raise TilewrightFileError(
                    f"map {name!r} of source {number} is {pixels.dtype} with {pixels.shape[2]} channels; its "
                    f"tiles are {maps[name].dtype} with {maps[name].shape[3]}"
                )


def _check_origins(origins: NDArray[Any], sources: tuple[dict[str, NDArray[Any]], ...]) -> None:
    """Raise unless every origin is a pixel of a source."""
    if origins.dtype != np.uint16 or origins.shape[3] != 3:
        raise TilewrightFileError("origins must be 16-bit images with three channels")
    sizes = np.array([next(iter(source.values())).shape[:2] for source in sources])
    for t, spots in enumerate(origins):
        number = spots[..., 0]
        if number.max() >= len(sources) or (spots[..., 1:] >= sizes[number]).any():
            raise TilewrightFileError(f"picture {t} of origins names a pixel outside its source")


def safe_stem(name: str) -> str:
    """A map's name as part of a file name."""
    return "".join(c if c.isalnum() or c in "-_" else "_" for c in name) or "map"
