"""What texture synthesis, fields, walls and flows give, for `test_golden`: names of the public face only."""

import warnings
from functools import cache

import numpy as np

import tilewright as tw

SIDE = 96
WINDOWS = {"near": (-40, -30, 100, 70), "far": (2**45 + 5, -(2**45), 50, 40)}
KINDS = {"uint8": np.uint8, "uint16": np.uint16, "float32": np.float32}


class About:
    """A picture of which only means are known on every processor."""

    def __init__(self, pixels):
        self.pixels = pixels

    def sketch(self):
        """Means of four by four parts of every channel."""
        rows = np.array_split(self.pixels.astype(np.float64), 4)
        parts = [part for row in rows for part in np.array_split(row, 4, axis=1)]
        return [float(f"{mean:.9g}") for part in parts for mean in part.mean(axis=(0, 1))]


@cache
def noise(seed, channels=3, side=SIDE):
    """Smooth noise of two scales from 0 to 1, exact in any processor's arithmetic."""
    rng = np.random.default_rng(seed)
    fine = rng.integers(0, 64, (side, side, channels))
    for reach in (1, 2):
        fine = sum(np.roll(fine, (dy, dx), (0, 1)) for dy in (0, reach) for dx in (0, reach))
    return np.minimum(fine / 1008.0, 1.0)


def photo(seed=1, kind="uint8", channels=3, side=SIDE):
    """A photograph made by a formula."""
    values = noise(seed, channels, side)
    if kind == "float32":
        return (np.floor(values * 4096) / 4096).astype(np.float32)
    most = np.iinfo(KINDS[kind]).max
    return np.floor(values * most).astype(KINDS[kind])


def normals(seed=1):
    """Normals of a bumpy surface as 8-bit numbers."""
    east, south = (np.floor(noise(seed + k, 1) * 100 + 78) for k in (20, 30))
    return np.concatenate([east, south, np.full_like(east, 230)], axis=2).astype(np.uint8)


def stack(seed=1):
    """The maps of a material."""
    return {
        "albedo": photo(seed),
        "normal": normals(seed),
        "roughness": photo(seed + 10, channels=1),
        "height": photo(seed + 40, "uint16", channels=1),
    }


def mask():
    """White where pixels may be copied."""
    made = np.full((SIDE, SIDE, 1), 255, np.uint8)
    made[40:60, 30:50] = 0
    return made


def make(photograph, tiles, **settings):
    """Texture tiles, without a warning that small photographs repeat."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", tw.TilewrightWarning)
        return tw.texture_tiles(photograph, tiles, **({"tile_size": 32, "seed": 1} | settings))


@cache
def material(kind="uint8"):
    """A small set for whatever needs one."""
    return make(photo(kind=kind), tw.corner_tiles(2))


@cache
def surface():
    """A small material of several maps."""
    return make(stack(), tw.corner_tiles(2), normal="gl", weights={"albedo": 2.0})


def parts_of(name, made):
    for map, pixels in made.maps.items():
        yield f"{name} {map}", pixels
    yield f"{name} origins", made.origins
    yield f"{name} recipe", made.recipe
    yield f"{name} kinds", dict(made.kinds)


def texture_tiles():
    for kind in KINDS:
        yield from parts_of(kind, material(kind))
    yield from parts_of("gray", make(photo(channels=1)[..., 0], tw.corner_tiles(2)))
    yield from parts_of("alpha", make(photo(channels=4), tw.corner_tiles(2)))
    yield from parts_of("stack", surface())
    yield from parts_of("flattened", make(stack(), tw.corner_tiles(2), normal="dx", flatten=True))
    yield from parts_of("64", make(photo(side=160), tw.corner_tiles(1), tile_size=64, seed=5))
    two = {"second": photo(2), "mask": mask(), "second_mask": mask()[::-1]}
    yield from parts_of("two sources", make(photo(), tw.corner_tiles(2), **two))
    yield from parts_of("mask", make(photo(), tw.corner_tiles(2), mask=mask(), seed=3))


def texture_methods():
    sets = {
        "corner": (tw.corner_tiles(2), ("ng", "squares")),
        "wang": (tw.wang_tiles(2), ("centered-diamonds", "diamonds", "burke")),
        "cohen": (tw.cohen_tiles(8), ("centered-diamonds",)),
        "coded": (tw.corner_coded_tiles(scanline_only=True), ("nested",)),
        "aperiodic": (tw.aperiodic_tiles("jeandel-rao-24"), ("nested",)),
    }
    for name, (tiles, methods) in sets.items():
        for method in methods:
            made = make(photo(), tiles, method=method)
            yield f"{name} {method}", made.pixels
            yield f"{name} {method} recipe", made.recipe


def texture_default():
    """What a newcomer gets: tone outside the tiles, and courses."""
    toned = make(stack(), None, normal="gl", tone=True, tile_size=16)
    yield from parts_of("tone", toned)
    for map, texels in toned.tone.maps.items():
        yield f"tone of {map}", texels
    yield "means", toned.tone.mean("albedo")
    light = make(photo(kind="float32"), None, tone=True, tile_size=16)
    for window, where in WINDOWS.items():
        for map in toned.maps:
            laid = tw.TextureField(toned, tw.direct(toned.tiles, 7))
            yield f"laid {map} {window}", laid.render(*where, map=map)
        yield f"laid light {window}", About(tw.TextureField(light, tw.direct(light.tiles, 7)).render(*where))
    wall = tw.BrickField(tw.BondBricks("running-bond", (16, 8))).render(width=128, height=128)
    yield from parts_of("courses", make(wall, None, tile_size=None))


def texture_changes():
    base = material()
    name, other = list(base.recipe["patches"])[:2]
    yield from parts_of("again", tw.resynthesize(base))
    yield from parts_of("rejected", tw.resynthesize(base, reject=[name]))
    yield from parts_of("picked", tw.resynthesize(base, pick={other: (0, 50, 60)}))
    added = {"rough": photo(5, channels=1), "bump normal": normals(5)}
    yield from parts_of("added", tw.add_maps(base, added, normal="gl"))
    exemplar = tw.open_exemplar(stack(), normal="gl")
    for map, pixels in exemplar.sources[0].items():
        yield f"exemplar {map}", pixels
    found = tw.find_regularity(np.tile(photo()[:32, :32], (4, 4, 1)))
    yield "regularity", {k: str(v) for k, v in vars(found).items()}


def texture_fields():
    for kind in KINDS:
        made = material(kind)
        field = tw.TextureField(made, tw.direct(made.tiles, 7))
        for window, where in WINDOWS.items():
            yield f"{kind} {window}", field.render(*where)
    field = tw.TextureField(surface(), tw.direct(surface().tiles, 7))
    for map in surface().maps:
        yield f"stack {map}", field.render(-40, -30, 100, 70, map=map)
    for name, plane in (("repeat", tw.RepeatField), ("hex", tw.HexField), ("noise", tw.NoiseField)):
        seeds = ({},) if name == "repeat" else ({"seed": 0}, {"seed": 7})
        for seed in seeds:
            for kind in KINDS:
                for window, where in WINDOWS.items():
                    made = plane(photo(kind=kind), **seed)
                    shown = made.render(*where)
                    exact = kind == "uint8" or name != "hex"
                    yield f"{name} {kind} {seed} {window}", shown if exact else About(shown)
    beside = tw.side_by_side(material(), seed=3)
    for name, one in beside.contenders.items():
        yield f"beside {name}", one.field.render(-9, -8, 40, 30)
        yield f"beside {name} costs", str((one.label, one.lattice.tolist(), one.fetches, one.texels))


def texture_analysis():
    small = make(photo(channels=1)[:80, :80], tw.corner_tiles(2), tile_size=16)
    yield "report of a stack", dict(tw.analyze(surface(), cells=6, seed=3).figures)
    yield "comparison", tw.compare_textures(small, seed=3).figures


def walls():
    endless = tw.endless_brick_tiling(3, 5)
    tiled = tw.brick_tiling(tw.dapple(tw.random_start(6, 8, seed=2), {"H0": 3, "V1": 3}), 4, 5)
    hole = np.ones((5, 6), bool)
    hole[2, 2:4] = False
    size = {"size": (48, 16)}
    patterns = {
        "endless": (tw.BrickField(endless, seed=3), (-20, -30)),
        "endless far": (tw.BrickField(endless, seed=3), (10**11, -(10**11))),
        "tiling": (tw.BrickField(tiled, tw.BrickStyle("sandstone"), seed=4, **size), (10, 12)),
        "region": (tw.BrickField(tw.brick_region(hole, 3), tw.BrickStyle("gray"), **size), (60, 10)),
    }
    for bond in ("running-bond", "flemish-bond", "herringbone", "basket-weave"):
        style = tw.BrickStyle("yellow", mortar=3, bevel=2.5, variation=0.5, wear=0.2, grain=0.4)
        patterns[bond] = (tw.BrickField(tw.BondBricks(bond, (48, 16)), style, seed=9), (-20, -30))
    ringed = tw.BondBricks("running-bond", (48, 16), period=(4, 6))
    patterns["closed bond"] = (tw.BrickField(ringed, seed=9), (150, 80))
    for name, (field, corner) in patterns.items():
        for map, pixels in field.render_maps(*corner, 110, 60).items():
            yield f"{name} {map}", pixels
        yield f"{name} preview", field.render(*corner, 110, 60)
        found = field.bricks(*corner, 110, 60)
        yield f"{name} sides", found.sides
        yield f"{name} ids", found.ids
        yield f"{name} tones", field.tones(found)
    yield from parts_of("brick tiles", tw.brick_texture_tiles(tw.brick_tiles(2), tile_size=32, seed=3))


def flows():
    cells = tw.dapple(tw.random_start(12, 9, seed=2), {"H0": 3, "V1": 3})
    strewn, tiles = tw.strew_tiles(cells, emitting=0.1, killing=0.1, slow=0.1, fast=0.1, rate=0.1, seed=4)
    yield "strewn", strewn
    yield "strewn tiles", str(tiles)
    cases = {
        "torus": tw.simulate_flow(cells, particles=40, steps=60, seed=3),
        "closed": tw.simulate_flow(cells, particles=40, steps=60, torus=False, every=5, seed=3),
        "open": tw.simulate_flow(cells, particles=40, steps=60, torus=False, leaves=True, seed=3),
        "onward": tw.simulate_flow(cells, particles=40, steps=60, turns_back=False, seed=3),
        "strewn": tw.simulate_flow(strewn, tiles, particles=40, steps=60, seed=3),
    }
    for name, flow in cases.items():
        for part in ("times", "positions", "ways", "departures", "born", "killed", "left"):
            yield f"{name} {part}", getattr(flow, part)
        yield f"{name} visits", flow.visits()
        yield f"{name} density", flow.density(3)
        yield f"{name} arms", flow.arms()
    for name in ("torus", "strewn"):
        yield f"{name} drawn density", tw.draw_density(cases[name])
        for color in ("direction", "particle"):
            yield f"{name} drawn trails {color}", tw.draw_trails(cases[name], size=8, color=color)


GROUPS = {
    "texture tiles": texture_tiles,
    "texture methods": texture_methods,
    "texture default": texture_default,
    "texture changes": texture_changes,
    "texture fields": texture_fields,
    "texture analysis": texture_analysis,
    "walls": walls,
    "flows": flows,
}
