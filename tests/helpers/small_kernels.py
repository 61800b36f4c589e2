"""Small work for every kernel, with and without its compiler; run as a script it prints what came of it."""

import functools
import hashlib
import json
import sys
import time
import warnings
from dataclasses import replace

import numba
import numpy as np

import tilewright as tw
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.sheet import reduce_blocks, sum_variances
from tilewright.signals.textures.tone import Tone, take_tone


def tilings():
    """Tile indices of every direct algorithm, by scanline, packings, dapples, bricks."""
    sets = (tw.corner_tiles(3), tw.wang_tiles(2, 3), tw.corner_tiles(4, choices=2), tw.corner_cubes(2))
    for tiles in (*sets, tw.classed_corner_tiles(2, 5)):
        window = (-3, 2**40, 5, 4) if tiles.shape.dimension == 2 else (-3, 2, 1, 3, 2, 2)
        yield repr(tiles), tw.direct(tiles, 7).indices(*window)
    yield "scanline", tw.scanline(tw.cohen_tiles(8), 6, 5, 3).cells
    yield "packing", tw.random_packing(tw.corner_tiles(2), seed=3).cells
    yield "packings", np.array(tw.count_packings(tw.wang_tiles(1)))
    yield "dapple", tw.dapple(tw.random_start(9, 8, seed=1), {"H0": 2, "V1": 2}, seed=1)
    three = tw.random_start(6, 5, (1, 1, 1), 1)
    yield "dapple of subsets", tw.dapple(three, {"H0+1": 2, "V2": 2}, seed=1)
    yield "endless dapple", tw.endless_dappled_tiling({"H0": 2, "V1": 2}, seed=1).cells(-3, 5, 6, 4)
    yield "dappled tilings", np.array(tw.count_dappled(3, 3, {"H0": 2, "V1": 2}))
    wall = tw.endless_brick_tiling(3, 5)
    yield "endless bricks", wall.indices(10, -4, 5, 4)
    yield "bricks", tw.brick_tiling(np.array([[0, 1, 0], [1, 0, 1]]), 3, 2).cells
    yield "region", tw.brick_region(np.ones((3, 4), np.uint8), 3, seed=2).cells
    yield "wall", tw.BrickField(wall, size=(12, 8)).render(0, 0, 20, 14)


def flows():
    """Particles, and pictures of them."""
    tiles = (tw.FlowTile("-", 0.5), tw.FlowTile("|", 0.25, emits=0.4), tw.FlowTile("+", 0.5, kills=0.5))
    cells = np.arange(12).reshape(3, 4) % 3
    flow = tw.simulate_flow(cells, tiles, particles=5, steps=9, seed=2)
    yield "flow", flow.positions
    yield (
        "flow out",
        tw.simulate_flow(cells, tiles, particles=5, steps=9, torus=False, leaves=True, seed=2).positions,
    )
    yield "trails", tw.draw_trails(flow, size=6)


def points():
    """Samplers of few points, point tiles, fields of them, figures."""
    from tilewright.samplers import METHODS

    for method in METHODS:
        yield method, tw.sample_points(method, 9, seed=3).points
    one = tw.corner_tiles(1)
    tiles = tw.poisson_tiles(one, points=8, rho=0.5, method="relaxed", variants=2, seed=1)
    yield "tiles", tiles.points
    yield "closeness", np.array(tw.find_closeness(tiles).within)
    field = tw.PointField(tiles, tw.direct(tiles.tiles, 7))
    yield "points", field.points(-0.5, 1.25, 3, 2)
    yield "whole tiles", field.points(-1, 1, 2, 2)
    yield "sample", field.sample(20)
    yield "nearest", field.nearest([[0.5, 0.5], [-7.1, 3.3]])[0]
    plane = tw.sample_points("dart", 20, seed=1)
    yield "spectrum", tw.power_spectrum(plane).power[:4, :4]


def textures():
    """Cuts and copies of texture tiles."""
    rng = np.random.default_rng(5)
    photo = (rng.random((40, 40, 1)) * 255).astype(np.uint8)
    stack = {"albedo": photo, "height": photo}
    material = tw.texture_tiles(stack, tw.corner_tiles(1), tile_size=16, seed=1)
    yield "texture", material.origins
    yield "heights", material.maps["height"]
    yield "field", tw.TextureField(material, tw.direct(material.tiles, 7)).render(-5, 3, 40, 20)
    toned = replace(material, tone=Tone(16, 1, {"albedo": rng.normal(0, 9, (5, 7, 1)).astype(np.float32)}))
    color = rng.random((33, 32, 3)).astype(np.float32)
    yield "blocks", reduce_blocks(color, 2)
    yield "variances", np.array(sum_variances(color.reshape(-1, 3)))
    taken, _ = take_tone(Exemplar([{"color": (color * 255).astype(np.uint8)}]), 16)
    yield "tone", taken.maps["color"]
    yield "toned", tw.TextureField(toned, tw.direct(material.tiles, 7)).render(-5, 3, 40, 20)


def work() -> dict[str, str]:
    """A digest of what each piece of work gives; floats to six digits, as a compiler may fuse operations."""
    found = {}
    for group in (tilings, flows, points, textures):
        started = time.perf_counter()
        for name, array in group():
            if "--times" in sys.argv:
                print(f"{time.perf_counter() - started:6.1f} s  {name}", file=sys.stderr, flush=True)
                started = time.perf_counter()
            values = np.round(np.asarray(array, float), 6) + 0.0
            found[f"{group.__name__}: {name}"] = hashlib.sha256(values.tobytes()).hexdigest()[:16]
    return found


class Recorder:
    """Stands for numba's compiler: kernels stay plain Python, and each says that it was called."""

    def __init__(self) -> None:
        self.known, self.called = set(), set()

    def compile(self, **options):
        """As `numba.njit` with options: a decorator."""

        def decorate(function):
            name = f"{function.__module__.rpartition('.')[2]}.{function.__name__}"
            self.known.add(name)

            @functools.wraps(function)
            def noted(*arguments):
                self.called.add(name)
                return function(*arguments)

            return noted

        return decorate


if __name__ == "__main__":
    warnings.simplefilter("ignore")  # words wrap around, which NumPy's scalars say
    recorder = Recorder()
    numba.njit = recorder.compile
    found = work()
    print(json.dumps([found, sorted(recorder.known - recorder.called)]))
