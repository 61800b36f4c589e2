"""Texture tiles made by rule, so that tests need no synthesis: borders match, interiors are noise."""

from dataclasses import replace

import numpy as np
from scipy.ndimage import gaussian_filter

from tilewright.pixels import white
from tilewright.signals.textures import TextureTiles, copy_from_sources
from tilewright.signals.textures.tone import TONED, Tone
from tilewright.tiles import TileSet, corner_tiles
from tilewright.tiles.variants import Variants


def handmade(
    tiles: TileSet,
    size: int = 16,
    kind: type = np.uint8,
    channels: int = 3,
    maps: int = 1,
    variants: Variants | None = None,
) -> TextureTiles:
    """Tiles that copy random pixels from one random source."""
    variants = Variants.uniform(tiles) if variants is None else variants
    rng = np.random.default_rng([len(variants), size, channels])
    most = 1 if kind is np.float32 else np.iinfo(kind).max
    sources = tuple(
        {f"map{m}": (rng.random((64, 80, channels)) * most).astype(kind) for m in range(maps)}
        for _ in range(2)
    )
    origins = np.empty((len(variants), size, size, 3), np.uint16)
    for axis, top in enumerate((2, 64, 80)):
        origins[..., axis] = rng.integers(0, top, origins.shape[:3])
    masks = (rng.random((64, 80)) < 0.9, np.ones((64, 80), bool))
    recipe = {"method": "by hand", "seed": 3, "weights": {"map0": 1.0}, "patches": {"center:0": [0, 1, 2]}}
    pixels = copy_from_sources(sources, origins)
    return TextureTiles(tiles, pixels, sources, origins, recipe, masks, variants=variants)


def under_clouds(material: TextureTiles, span: int) -> TextureTiles:
    """The same tiles, calmer, under clouds: the first map has tone."""
    kind = next(iter(material.maps.values())).dtype
    most = white(kind)
    rng = np.random.default_rng(4)
    clouds = gaussian_filter(rng.normal(0, 0.4, (20, 26, 3)), (3, 3, 0)).astype(np.float32)
    calm = {name: (pixels / 4 + most * 0.4).astype(kind) for name, pixels in material.maps.items()}
    mean = calm[material.main].mean(axis=(0, 1, 2), dtype=np.float64).astype(np.float32)
    texels = {material.main: clouds * np.float32(most)}
    tone = Tone(material.tile_size, span, texels, {material.main: mean})
    return replace(material, maps=calm, tone=tone)


def of_numbers(material: TextureTiles, kind: str) -> TextureTiles:
    """The same, whose main map holds roughness or heights: tone is an offset alone; heights have any size."""
    assert material.tone is not None
    main, kinds = material.main, material.kinds | {material.main: kind}
    maps, texels = dict(material.maps), dict(material.tone.maps)
    if kind == "height" and maps[main].dtype.kind == "f":
        maps[main], texels[main] = 8 * maps[main] - 3, 8 * texels[main]
    return replace(material, maps=maps, kinds=kinds, tone=replace(material.tone, maps=texels, means={}))


def handmade_surface(colors=2):
    """A stack of maps of all types: half of what a material may have."""
    base, rng = handmade(corner_tiles(colors), 16), np.random.default_rng(8)
    shape = base.sources[0]["map0"].shape[:2]
    maps = {
        "base color": (3, np.uint8),
        "normal": (3, np.uint8),
        "roughness": (1, np.uint8),
        "metallic": (1, np.uint8),
        "ao": (1, np.uint16),
        "height": (1, np.float32),
        "emissive": (3, np.float32),
    }

    def pixels(channels, kind):
        most = 1 if kind == np.float32 else np.iinfo(kind).max
        return (rng.random((*shape, channels)) * most).astype(kind)

    sources = tuple({name: pixels(*what) for name, what in maps.items()} for _ in base.sources)
    kinds = {"base color": "color", "normal": "normal-gl", "emissive": "color", "roughness": "roughness"}
    kinds = {name: kinds.get(name, "data") for name in maps}
    return replace(base, maps=copy_from_sources(sources, base.origins), sources=sources, kinds=kinds)


def surface_under_clouds(colors=2):
    """`handmade_surface` whose colors, roughness and heights have tone."""
    surface, rng = handmade_surface(colors), np.random.default_rng(6)
    kinds = surface.kinds | {"height": "height"}
    toned = {name: kind for name, kind in kinds.items() if kind in TONED}
    maps = {
        name: rng.normal(0, 0.1 * white(surface.maps[name].dtype), (9, 7, surface.maps[name].shape[3]))
        for name in toned
    }
    means = {
        name: np.full(maps[name].shape[2], 0.5 * white(surface.maps[name].dtype), np.float32)
        for name, kind in toned.items()
        if kind == "color"
    }
    texels = {name: map.astype(np.float32) for name, map in maps.items()}
    return replace(surface, kinds=kinds, tone=Tone(surface.tile_size, 2, texels, means))
