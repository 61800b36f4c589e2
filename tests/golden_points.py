"""What samplers, point tiles and their analysis give, for `test_golden`: names of the public face only."""

from functools import cache

import numpy as np

import tilewright as tw

PLAIN, CUBE = tw.Box(torus=False), tw.Box((1.0, 1.0, 1.0))
SAMPLERS = {
    "dart": [{}, {"rho": 0.6, "box": PLAIN}, {"box": CUBE}],
    "relaxation": [{}, {"box": PLAIN}],
    "lloyd": [{"iterations": 3}, {"iterations": 3, "box": PLAIN}],
    "best-candidate": [{}, {"box": CUBE}],
    "bridson": [{}, {"box": PLAIN}, {"box": CUBE}],
    "jones": [{}, {"rho": 0.7, "box": PLAIN}],
    "maximal": [{}, {"rho": 0.7}, {"box": CUBE}],
    "scallop-log": [{}, {"box": PLAIN}],
    "scallop-linear": [{}],
    "scallop-boundary": [{}, {"box": PLAIN}],
    "penrose": [{}, {"box": tw.Box((2.0, 1.0), torus=False)}],
    "elimination": [{}, {"box": CUBE}],
    "uniform": [{}],
    "jittered": [{}, {"box": CUBE}],
    "sobol": [{}],
    "regular": [{}, {"box": CUBE}],
    "hexagonal": [{}],
}
TILE_METHODS = {
    "corner": {"points": 8, "rho": 0.6, "colors": 2},
    "corner-relaxed": {"points": 16, "rho": 0.7, "colors": 2},
    "edge": {"points": 12, "rho": 0.6},
    "template": {"points": 16, "rho": 0.7, "variants": 4},
    "shade": {"points": 16},
    "hiller": {"points": 12},
    "kopf": {"points": 256},
}


def samplers():
    for method, cases in SAMPLERS.items():
        for number, settings in enumerate(cases):
            for seed in (0, 7):
                made = tw.sample_points(method, 120, seed=seed, **settings)
                yield f"{method} {number} seed {seed}", made.points
                yield f"{method} {number} seed {seed} figures", {"distance": made.distance, "rho": made.rho}


def parts_of(name, tiles):
    for part in ("points", "starts", "ranks"):
        yield f"{name} {part}", getattr(tiles, part)
    yield f"{name} set", tiles.tiles.slots
    said = {"distance": tiles.distance, "variants": tiles.variants, "method": tiles.method}
    yield f"{name} figures", {**said, "figures": tiles.figures, "recipe": tiles.recipe}


@cache
def tiles_of(method):
    """Small tiles of a method."""
    return tw.make_point_tiles(method, seed=4, **TILE_METHODS[method])


def point_tiles():
    for method in TILE_METHODS:
        yield from parts_of(method, tiles_of(method))
    tiles = tw.poisson_tiles(tw.corner_tiles(1), 12, 0.65, variants=3, method="relaxed", seed=3)
    yield from parts_of("three variants", tiles)
    close, border = tw.find_closeness(tiles), tw.border_density(tiles)
    yield "closeness", {name: getattr(close, name) for name in ("within", "across_edges", "across_corners")}
    yield "border density", {k: np.asarray(v).tolist() for k, v in vars(border).items()}
    for density in (50.0, 3000.0):
        yield f"recursion {density}", tw.recursive_points(tiles_of("kopf"), np.array([[0, 0]]), density)


def ready_tiles():
    for given in ((4, 32, 0.75), (4, 32, 0.70), (3, 32, 0.75), (4, 64, 0.75), (6, 32, 0.70)):
        yield from parts_of(f"ready {given}", tw.ready_tiles(*given))


def point_fields():
    tiles = tw.ready_tiles()
    field = tw.PointField(tiles, tw.direct(tiles.tiles, 7))
    yield "points", field.points(-3.5, 2.25, 6, 4.5)
    yield "points local", field.points(2**40 + 0.5, -(2**40), 4, 4, local=True)
    yield "points thinned", field.points(0, 0, 8, 8, density=0.3)
    yield "points by a function", field.points(0, 0, 8, 8, density=lambda x, y: (x % 8) / 8)
    yield "sample", field.sample(500)
    yield "sample of a window", field.sample(300, -2.5, 1, 5, 7.5)
    yield "sample blocks", np.concatenate(list(field.sample_blocks(700, -5, 3)))
    yield "blocks", np.concatenate(list(field.blocks(-2.5, 3.5, 6, 5)))
    yield "count", str((field.count(-2.5, 3.5, 60, 50), field.count(0, 0, 9, 9, density=0.2)))
    yield "rows", field.rows_at(-5, 2**40, 9, 7)
    positions = np.add.outer(np.arange(40), (0.25, 0.75)) * (0.7, -1.1)
    distances, window = field.nearest(positions)
    yield "nearest distances", distances
    for name, seen in (("nearest", window), ("window", field.window(-3.5, 2.25, 6, 4.5, density=0.6))):
        for part in ("points", "cells", "numbers", "ranks", "ids"):
            yield f"{name} {part}", getattr(seen, part)
    closed = tw.PointField(tiles, tw.direct(tiles.tiles, 7, period=(4, 3))).torus()
    yield "torus", closed.points
    yield "torus box", str((closed.box.extent, closed.box.torus, round(closed.distance, 9)))
    small = tiles_of("template")
    yield "variants", tw.PointField(small, tw.direct(small.tiles, 7)).points(-4, -4, 8, 8)


def point_analysis():
    made = [tw.sample_points("dart", 256, seed=seed) for seed in (0, 1)]
    for kind in ("centered", "wrapped", "star"):
        yield f"discrepancy {kind}", {"value": tw.discrepancy(made[0], kind)}
    yield (
        "measures",
        {
            "bond order": tw.bond_order(made[0]),
            "coverage": tw.coverage_radius(made[0]),
            "nearest": tw.nearest_mean(made[0]),
            "rho": tw.relative_radius(made[0].points),
            "most": tw.max_radius(256, PLAIN),
        },
    )
    yield "periodogram", tw.periodogram(made[0], 32)
    spectrum = tw.power_spectrum(made, 64)
    for part in ("power", "radial", "anisotropy", "samples"):
        yield f"spectrum {part}", getattr(spectrum, part)
    yield "spectrum figures", dict(spectrum.figures)
    spikes = tw.lattice_spikes(spectrum, 4)
    yield "lattice spikes", {"on": spikes.on, "off": spikes.off, "at": list(spikes.at)}
    seen = tw.radial_distribution(made, bins=40)
    yield "distribution", np.stack([seen.distance, seen.density])
    yield "report", dict(tw.analyze(made).figures)
    plate = tw.zone_plate(tw.sample_points("uniform", 2**16))
    said = {name: getattr(plate, name) for name in ("error", "error_near", "rate", "holes")}
    yield "zone plate", said
    yield "zone plate picture", plate.picture
    rows = tw.compare(["regular"], sets=1).plain_rows()
    yield "comparison", rows


GROUPS = {
    "samplers": samplers,
    "point tiles": point_tiles,
    "ready tiles": ready_tiles,
    "point fields": point_fields,
    "point analysis": point_analysis,
}
