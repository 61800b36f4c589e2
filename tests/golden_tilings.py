"""What tile sets and tilings give, for `test_golden`: names of the public face only."""

import numpy as np

import tilewright as tw

SEEDS = (0, 7, 2**64 - 1)
FAR = 2**40 + 3
FAMILIES = {
    "corner-2": lambda: tw.corner_tiles(2),
    "corner-3": lambda: tw.corner_tiles(3),
    "corner-16": lambda: tw.corner_tiles(16),
    "wang-2": lambda: tw.wang_tiles(2),
    "wang-3-2": lambda: tw.wang_tiles(3, 2),
    "compact-corner-3": lambda: tw.corner_tiles(3, choices=2),
    "compact-corner-4": lambda: tw.corner_tiles(4, choices=2),
    "columns-3": lambda: tw.column_corner_tiles(3, 2),
    "summed-2": lambda: tw.summed_wang_tiles(2),
    "summed-3": lambda: tw.summed_wang_tiles(3),
    "shifted-2": lambda: tw.shifted_wang_tiles(2),
    "shifted-4": lambda: tw.shifted_wang_tiles(4),
    "coded": lambda: tw.corner_coded_tiles(),
    "coded-wang-2": lambda: tw.corner_coded_tiles(tw.wang_tiles(2)),
    "crossed-2": lambda: tw.crossed_wang_tiles(2),
    "cohen-8": lambda: tw.cohen_tiles(8),
    "corner-cubes-2": lambda: tw.corner_cubes(2),
    "wang-cubes-2": lambda: tw.wang_cubes(2),
    "compact-corner-cubes-3": lambda: tw.compact_corner_cubes(3),
    "compact-wang-cubes-2": lambda: tw.compact_wang_cubes(2),
    "dominoes-3": lambda: tw.dominoes(3),
}
OTHER_SETS = {
    "cohen-12": lambda: tw.cohen_tiles(12),
    "cohen-18": lambda: tw.cohen_tiles(18),
    "compact-wang-2": lambda: tw.compact_wang_tiles(2),
    "compact-wang-3-2": lambda: tw.compact_wang_tiles(3, 2),
    "coded-scanline": lambda: tw.corner_coded_tiles(scanline_only=True),
    "bricks-2": lambda: tw.brick_tiles(2),
    "bricks-4": lambda: tw.brick_tiles(4),
}
PERIODS = {
    "corner-2": (12, 7),
    "corner-3": (None, 5),
    "wang-2": (12, 7),
    "wang-3-2": (9, None),
    "compact-corner-3": (12, 8),
    "columns-3": (12, 8),
    "shifted-2": (12, 8),
    "crossed-2": (12, 8),
    "corner-cubes-2": (5, None, 6),
    "wang-cubes-2": (5, 4, 6),
    "dominoes-3": (11,),
}
WINDOWS = {
    1: {"near": (-5, 40), "word": (2**32 - 8, 16), "far": (-(2**50), 16)},
    2: {"near": (-5, -7, 24, 16), "word": (2**32 - 4, -4, 8, 8), "far": (FAR, -(2**50), 8, 8)},
    3: {"near": (-2, -3, -4, 6, 5, 4), "word": (2**32 - 2, -2, -2, 4, 4, 4), "far": (FAR, 5, -FAR, 4, 4, 4)},
}


def tile_sets():
    for name, make in (FAMILIES | OTHER_SETS).items():
        tiles = make()
        yield name, tiles.slots if len(tiles) < 10**5 else tiles.slots_of(np.arange(1000))
        if len(tiles) < 10**5:
            yield f"{name} codes", tiles.codes
    for name in tw.APERIODIC_SETS:
        yield name, tw.aperiodic_tiles(name).slots


def translations():
    culik, kari, jeandel = (tw.aperiodic_tiles(n) for n in ("culik-13", "kari-14", "jeandel-rao-11-5"))
    for construction in ("diagonal", "horizontal", "vertical", "rotation", "subdivision"):
        for name, wang in (("culik", culik), ("kari", kari)):
            if construction in ("horizontal", "vertical"):
                sound = tw.translation_is_sound(wang, construction)
                yield f"{name} {construction} is sound", str(sound)
                if not sound:
                    continue
            yield f"{name} {construction}", tw.as_corner_tiles(wang, construction).slots
    yield "as Wang tiles", tw.as_wang_tiles(tw.corner_tiles(3, choices=2)).slots
    yield "dropped", tw.drop_idle(tw.as_corner_tiles(jeandel, "rotation")).slots
    yield "blocks", tw.possible_blocks(jeandel, 2, 1)
    machine = tw.strip(culik, 2)
    for part in ("columns", "source", "target", "read", "write"):
        yield f"strip {part}", getattr(machine.trim(), part)
    yield "period", tw.find_period(tw.wang_tiles(2), 2)
    grouped = tw.grouped_subdivision(tw.aperiodic_tiles("jeandel-rao-11-4")).tiles
    yield "grouped", grouped.slots
    merged = tw.merge_colors(tw.corner_tiles(4), (0, 1, 1, 0))
    yield "merged", merged.slots


def direct_tilings():
    for name, make in FAMILIES.items():
        tiles = make()
        for seed in SEEDS:
            tiling = tw.direct(tiles, seed)
            for window, where in WINDOWS[tiles.shape.dimension].items():
                yield f"{name} seed {seed} {window}", tiling.indices(*where)


def direct_hashes():
    for name, make in FAMILIES.items():
        tiles = make()
        windows = WINDOWS[tiles.shape.dimension]
        for hash in ("permutation", "long-period"):
            tiling = tw.direct(tiles, 7, hash=hash)
            for window in ("near", "far"):
                yield f"{name} {hash} {window}", tiling.indices(*windows[window])
        if name in PERIODS:
            tiling = tw.direct(tiles, 7, period=PERIODS[name])
            yield f"{name} period", tiling.indices(*windows["near"])
    for colors in (2, 3):
        tiling = tw.direct(tw.wang_tiles(colors), 7, wang="two-hashes")
        for window, where in WINDOWS[2].items():
            yield f"two hashes {colors} {window}", tiling.indices(*where)
    x, y = np.arange(-20, 20), np.arange(2**33, 2**33 + 20)[:, np.newaxis]
    hashes = {
        "mixer": tw.MixerHash(5),
        "permutation": tw.PermutationHash(5, 100),
        "summed permutation": tw.PermutationHash(5, 64, nested=False),
        "tilings": tw.LongPeriodHash.for_tilings(5),
        "noise": tw.LongPeriodHash.for_noise(5),
    }
    for name, hash in hashes.items():
        for stream in (0, 3):
            yield f"{name} words {stream}", hash.words(stream, x, y)
            yield f"{name} words of cells {stream}", hash.words(stream, x, y, 9)
            yield f"{name} numbers {stream}", hash.numbers(stream, x, y)
            for colors in (2, 3, 300):
                yield f"{name} colors {colors} {stream}", hash.colors(colors, stream, x, y)
    yield "start", str(tw.MixerHash(5).start(3, 2**32 - 1, 2))


def scanlines():
    sets = {name: FAMILIES[name] for name in ("corner-3", "wang-3-2", "coded", "dominoes-3")} | OTHER_SETS
    for name, make in sets.items():
        tiles = make()
        size = (40,) if tiles.shape.dimension == 1 else (24, 16)
        for seed in (0, 7):
            tiling = tw.scanline(tiles, *size, seed=seed)
            start = (0,) * len(size)
            yield f"{name} seed {seed}", tiling.indices(*start, *size)
    yield "stochastic cohen-12", tw.stochastic(tw.cohen_tiles(12), 9, 8, seed=3).indices(0, 0, 9, 8)
    yield "stochastic wang-2", tw.stochastic(tw.wang_tiles(2), 9, 8, seed=3).indices(-4, 0, 9, 8)


def packings():
    for name in (
        "corner-2",
        "corner-3",
        "wang-2",
        "wang-3-2",
        "corner-cubes-2",
        "wang-cubes-2",
        "dominoes-3",
    ):
        tiles = FAMILIES[name]()
        laid = tw.packing(tiles)
        extent = tuple(min(n, 8) for n in laid.size)
        yield f"{name} closed", laid.indices(*(0,) * len(extent), *extent)
        for axis, places in enumerate(laid.place(np.arange(len(tiles)))):
            yield f"{name} place {axis}", places
    yield "corner-5 closed", tw.packing(tw.corner_tiles(5)).indices(0, 0, 25, 25)
    for name in ("corner-2", "wang-2"):
        tiles = FAMILIES[name]()
        for seed in (0, 7):
            yield f"{name} found {seed}", tw.find_packing(tiles, seed=seed).indices(0, 0, 4, 4)
        yield f"{name} count", str(tw.count_packings(tiles))
        search = tw.PackingSearch(tiles, seed=1)
        found = search.find(40)
        yield f"{name} search", found
        yield f"{name} trials", str(search.trials)
        for part, classes in enumerate(tw.classify_packings(tiles, found)):
            yield f"{name} classes {part}", classes
    yield "corner-3 found", tw.find_packing(tw.corner_tiles(3), seed=0).indices(0, 0, 9, 9)
    nest = tw.packing(tw.wang_tiles(2))
    yield "wang-3 nested", tw.find_packing(tw.wang_tiles(3), nest=nest).indices(0, 0, 9, 9)
    for colors in (2, 4):
        laid = tw.recursive_packing(tw.corner_tiles(colors))
        yield f"corner-{colors} recursive", laid.indices(0, 0, colors**2, colors**2)
    yield "wang-3 recursive", tw.recursive_packing(tw.wang_tiles(3)).indices(0, 0, 9, 9)
    extended = tw.extend_packing(tw.packing(tw.corner_tiles(2)), seed=4)
    yield "corner-3 extended", extended.indices(0, 0, 9, 9)


def density_tilings():
    gray = (np.arange(48).reshape(6, 8) * 5).astype(np.uint8)
    for name in ("corner-2", "corner-3", "coded"):
        tiles = FAMILIES[name]()
        for outside in ("clamp", "repeat"):
            tiling = tw.density_tiling(tiles, gray, 5, cells_per_pixel=2.5, outside=outside)
            yield f"{name} {outside}", tiling.indices(-3, -4, 30, 24)
        tiling = tw.density_tiling(tiles, lambda x, y: (x % 16) / 16, 5, hash="permutation")
        yield f"{name} function", tiling.indices(FAR, -4, 20, 10)


def solved_tilings():
    """What a solver finds, which needs python-sat."""
    fixed = np.full((6, 8), -1)
    fixed[2, 3] = 5
    jeandel = tw.aperiodic_tiles()
    for seed in (0, 7):
        yield f"fill {seed}", tw.fill(jeandel, 12, 9, seed=seed).indices(0, 0, 12, 9)
    yield "fill fixed", tw.fill(jeandel, 8, 6, fixed=fixed).indices(0, 0, 8, 6)
    yield "fill torus", tw.fill(tw.corner_tiles(2), 8, 6, torus=True, seed=3).indices(0, 0, 8, 6)
    periodic = tw.periodic_tiling(tw.aperiodic_tiles("lagae-44"), 5, 5)
    width, height = (periodic.domain.periods[a] for a in (0, 1))
    yield "periodic", periodic.indices(0, 0, width, height)
    partial = np.full((12, 16), -1)
    partial[3, 4:6], partial[7, 2] = 1, 0
    for cyclic in (False, True):
        for seed in (0, 5):
            made = tw.complete_dapple(partial, {"H0": 2, "V1": 2}, cyclic=cyclic, seed=seed)
            yield f"completed cyclic {cyclic} seed {seed}", made


def aperiodic_tilings():
    for name in tw.APERIODIC_SETS:
        tiles = tw.aperiodic_tiles(name)
        for seed in (0, 9):
            tiling = tw.aperiodic_tiling(tiles, seed)
            yield f"{name} seed {seed}", tiling.indices(-9, -8, 20, 16)
        yield f"{name} far", tiling.indices(10**6, -(10**6), 8, 8)
    for name in ("culik-13", "kari-14", "ammann-16", "jeandel-rao-11-5"):
        tiling = tw.aperiodic_tiling(tw.aperiodic_tiles(name), 4)
        for construction in ("diagonal", "rotation", "subdivision"):
            made = tw.translated_tiling(tiling, construction)
            yield f"{name} {construction}", made.indices(-6, -7, 14, 12)
    made = tw.translated_tiling(tw.direct(tw.corner_tiles(3), 5), "wang")
    yield "corners as Wang tiles", made.indices(-6, -7, 14, 12)
    kari = tw.aperiodic_tiling(tw.aperiodic_tiles("kari-14"), 4)
    yield "kari vertical", tw.translated_tiling(kari, "vertical").indices(-6, -7, 14, 12)


def dapples():
    limits, many = {"H0": 2, "V1": 2}, {"H0": 3, "V0": 3, "H1": 3, "V1": 3, "H2": 2, "V2": 2}
    shades = np.add.outer(np.arange(40), np.arange(60)).astype(np.uint8) * 2
    for seed in (0, 7):
        start = tw.random_start(30, 20, seed=seed)
        three = tw.random_start(30, 20, (0.3, 0.3, 0.4), seed=seed)
        yield f"start {seed}", start
        yield f"start of three {seed}", three
        for cyclic in (False, True):
            yield f"dapple {seed} cyclic {cyclic}", tw.dapple(start, limits, cyclic=cyclic, seed=seed)
        yield f"rectify {seed}", tw.rectify(start, limits)
        yield f"dapple of three {seed}", tw.dapple(three, many, seed=seed)
        for rule, where in tw.find_violations(start, limits).items():
            yield f"violations {seed} {rule}", where
        endless = tw.endless_dapple(limits, start=0.4, seed=seed)
        yield f"endless {seed}", endless.cells(-9, -8, 30, 20)
        yield f"endless far {seed}", endless.cells(10**12, -(10**12), 16, 12)
    for dither in (False, True):
        yield f"picture dither {dither}", tw.start_from_image(shades, 20, 16, dither=dither)
        picture = tw.start_from_image(shades, 20, 16, 3, dither=dither, limits=many)
        yield f"picture of three dither {dither}", picture
    yield "formula", tw.dapple_formula((6, 7), limits).dimacs()
    yield "count", str(tw.count_dappled(7, 6, limits))
    yield "count cyclic", str(tw.count_dappled(4, 5, limits, cyclic=True))
    best = tw.closest_dapple(tw.random_start(12, 9, seed=1), limits)
    yield "closest", str((best.distance, best.bound))


def brick_tilings():
    classes = tw.dapple(tw.random_start(16, 12, seed=2), {"H0": 3, "V1": 3})
    ring = tw.dapple(tw.random_start(16, 12, seed=2), {"H0": 3, "V1": 3}, cyclic=True)
    mask = np.ones((9, 11), bool)
    mask[3:5, 4:7] = mask[0, 0] = False
    edges = np.full((10, 11), -1)
    edges[0, 2:5] = 1
    for positions in (2, 3, 4):
        yield f"tiling {positions}", tw.brick_tiling(classes, positions, 5).indices(0, 0, 16, 12)
        if positions > 2:
            closed = tw.brick_tiling(ring, positions, 5, torus=True)
            yield f"torus {positions}", closed.indices(0, 0, 16, 12)
        endless = tw.endless_bricks(positions, 5, longest=(3, 4))
        yield f"endless {positions}", endless.indices(-9, -8, 24, 16)
        yield f"endless far {positions}", endless.indices(10**12, -(10**12), 16, 12)
        for seed in (0, 5):
            wall = tw.brick_region(mask, positions, horizontal=edges if positions > 2 else None, seed=seed)
            for part in ("cells", "horizontal", "vertical"):
                yield f"region {positions} seed {seed} {part}", getattr(wall, part)
            yield f"region {positions} seed {seed} longest", str(wall.longest)


GROUPS = {
    "tile sets": tile_sets,
    "translations": translations,
    "direct tilings": direct_tilings,
    "direct hashes": direct_hashes,
    "scanlines": scanlines,
    "packings": packings,
    "density tilings": density_tilings,
    "solved tilings": solved_tilings,
    "aperiodic tilings": aperiodic_tilings,
    "dapples": dapples,
    "brick tilings": brick_tilings,
}
