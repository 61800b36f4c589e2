"""What is exported, drawn, saved and written by commands, for `test_golden`: the public face only."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

import tilewright as tw
from golden_points import tiles_of
from golden_textures import SIDE, material, photo, stack, surface

TARGETS = ["threejs", "godot", "unity", "unreal", "blender", "glsl", "hlsl", "wgsl", "osl", "ktx2", "atlas"]

# Runs `python -m tilewright` once for each list of arguments, in one process; says how each ended.
_RUNNER = """
import io, json, runpy, sys
said = []
for arguments in json.load(sys.stdin):
    out, sys.stdout = sys.stdout, io.TextIOWrapper(io.BytesIO(), "utf-8")
    sys.argv, code = ["tilewright", *arguments], None
    try:
        runpy.run_module("tilewright", run_name="__main__", alter_sys=False)
    except SystemExit as end:
        code = end.code
    sys.stdout.flush()
    said.append((code, sys.stdout.buffer.getvalue().decode()))
    sys.stdout = out
json.dump(said, sys.stdout)
"""

COMMANDS = {
    "texture": "texture photo.png -o set --tile-size 32 --seed 1 --tiles corner",
    "texture of maps": "texture --map albedo=photo.png --map normal=normal.png --map roughness=rough.png"
    " -o maps --tile-size 32 --normal gl --weight albedo=2 --tiles corner",
    "texture again": "texture --from set --reject corner:0 -o again",
    "texture of Wang tiles": "texture photo.png -o wang --tiles wang --colors 2 --tile-size 32",
    "texture of two": "texture photo.png --second second.png --mask mask.png -o two --tile-size 32"
    " --colors 2",
    "render": "render set -o plane.png --x -50 --width 120 --height 70 --lattice-seed 7",
    "render TIFF": "render maps -o normal.tif --map normal --width 90 --height 60",
    "render a density": "render two -o way.png --density gray.png --cells-per-pixel 2 --width 90 --height 60",
    "view": "view set -o page.html --lattice-seed 3",
    "analyze": "analyze set",
    "export": "export set --to wgsl -o wgsl",
    "export atlas": "export set --to atlas -o atlas.png",
    "export array": "export maps --to array --map roughness -o array.tif",
    "points": "points --count 500 -o points.npy --lattice-seed 3",
    "points CSV": "points --width 5 --height 4 --x -2.5 -o points.csv",
    "points torus": "points --width 4 --height 3 --torus -o torus.parquet",
    "points of a sampler": "points --method dart --count 300 --torus --seed 2 -o darts.ply",
    "points of tiles": "points --method corner-relaxed --colors 2 --points 16 --rho 0.7 --count 100"
    " --save kept -o relaxed.npy",
    "analyze points": "analyze points.npy --width 4 --height 4",
    "pack": "pack --colors 3 -o packing.npy",
    "pack Wang": "pack --tiles wang --colors 2 --method search --seed 7 -o packing.png",
    "pack jigsaw": "pack --colors 2 -o puzzle.svg --engrave numbers",
    "pack recursive": "pack --colors 4 --method recursive -o recursive.npy",
    "dapple": "dapple --width 30 --height 20 --motif arcs --seed 3 -o dapple.png",
    "dapple picture": "dapple --input photo.png --dither --width 24 --limit H0=3 --limit V1=3 -o face.svg",
    "dapple endless": "dapple --endless --x 1000000000000 --share 0.6 --share 0.4 -o far.npy",
    "dapple clauses": "dapple --width 6 --height 5 -o clauses.cnf",
    "dapple count": "dapple --count --width 6 --height 6",
    "bricks": "bricks --width 4 --height 5 --size 48 16 --x -3 -o wall.png --seed 2",
    "bricks cyclic": "bricks --width 4 --height 4 --size 48 16 --cyclic -o wall-maps",
    "bricks SVG": "bricks --width 6 --height 6 -o wall.svg --seed 2",
    "bricks tiles": "bricks --width 6 --height 6 --input photo.png -o wall.npy",
    "bricks bond": "bricks --pattern herringbone --size 48 16 --width 4 --height 4 -o bond.png --map height",
    "flow": "flow --width 10 --height 8 --particles 30 --steps 10 --size 6 -o crowd.gif",
    "flow density": "flow --width 10 --height 8 --particles 30 --steps 40 --emit 0.1 --kill 0.1 -o dense.png",
    "flow positions": "flow --width 10 --height 8 --particles 30 --steps 20 --cyclic --slow 0.2 -o flow.npz",
    "aperiodic": "aperiodic kari-14 --width 12 --height 9 --x 1000000 -o kari.svg",
    "aperiodic set": "aperiodic kari-14 --to vertical --set -o set.npy",
    "aperiodic picture": "aperiodic jeandel-rao-24 --width 12 --height 9 -o jeandel.png",
}


def folder_of(name, folder):
    """The files of a folder, those of a folder within it as one."""
    for path in sorted(folder.iterdir()):
        yield f"{name} {path.name}", sorted(path.rglob("*.*")) if path.is_dir() else path


def in_folder(group):
    """A group that has a folder of its own while it lasts."""

    def run():
        with tempfile.TemporaryDirectory() as folder:
            yield from group(Path(folder))

    return run


@in_folder
def saved_sets(folder):
    made = {
        "texture": material(),
        "float texture": material("float32"),
        "maps": surface(),
        "points": tiles_of("corner"),
        "read again": tw.ready_tiles(3),
    }
    for name, one in made.items():
        tw.save(one, folder / name)
        yield from folder_of(name, folder / name)
    again = tw.load(folder / "maps")
    for map, pixels in again.maps.items():
        yield f"loaded {map}", pixels


@in_folder
def files(folder):
    points = tw.sample_points("dart", 60, seed=3)
    for suffix in ("npy", "csv", "parquet", "ply"):
        tw.write_points(folder / f"points.{suffix}", points)
        yield f"points {suffix}", folder / f"points.{suffix}"
    for kind, suffixes in (("uint8", "png tif"), ("uint16", "png tif"), ("float32", "tif exr")):
        for suffix in suffixes.split():
            tw.write_image(folder / f"{kind}.{suffix}", photo(kind=kind)[:20, :30])
            yield f"{kind} {suffix}", folder / f"{kind}.{suffix}"
    field = tw.TextureField(material(), tw.direct(material().tiles, 7))
    for suffix in ("png", "tif"):
        field.save(folder / f"plane.{suffix}", -300, 5, 600, 270)
        yield f"plane {suffix}", folder / f"plane.{suffix}"
    wall = tw.BrickField(tw.endless_brick_tiling(3, 5), size=(48, 16))
    wall.save(folder / "wall.png", -20, 3, 90, 60)
    wall.save(folder / "wall", -20, 3, 90, 60)
    yield "wall", folder / "wall.png"
    yield from folder_of("wall", folder / "wall")
    cells = tw.dapple(tw.random_start(8, 6, seed=2), {"H0": 3, "V1": 3})
    flow = tw.simulate_flow(cells, particles=20, steps=12, seed=3)
    tw.save_animation(folder / "flow.gif", flow, size=6)
    yield "flow", folder / "flow.gif"
    tw.save_svg(folder / "cells.svg", tw.draw_cells(cells))
    yield "svg", folder / "cells.svg"


@in_folder
def engines(folder):
    for to in TARGETS:
        tw.save_for_engine(surface(), folder / to, to, seed=7)
        yield from folder_of(to, folder / to)
    tw.save_for_engine(material("float32"), folder / "float", "ktx2")
    yield from folder_of("float ktx2", folder / "float")


@in_folder
def exports(folder):
    pixels, laid = tw.make_atlas(material())
    yield "atlas", pixels
    yield "packing", laid.indices(0, 0, 4, 4)
    tw.save_atlas(surface(), folder / "normal.png", map="normal")
    yield "atlas of normals", folder / "normal.png"
    tw.save_array(surface(), folder / "height.tif", map="height")
    yield "array", folder / "height.tif"
    for name, kind in (("8", "uint8"), ("16", "uint16"), ("float", "float32")):
        whole = photo(kind=kind, channels=4)[:16, :16]
        levels = [np.stack([whole[:: 1 << k, :: 1 << k]] * 2) for k in range(5)]
        tw.write_ktx2(folder / f"{name}.ktx2", levels, srgb=kind == "uint8")
        yield f"ktx2 {name}", folder / f"{name}.ktx2"
    for name, one in (("page", material()), ("page of maps", surface())):
        tw.save_viewer(one, folder / "page.html", seed=3)
        yield name, folder / "page.html"
    tw.save_viewer(material(), folder / "page.html", compare=tw.side_by_side(material()))
    yield "page of methods", folder / "page.html"


def drawings():
    cells = tw.dapple(tw.random_start(12, 9, seed=2), {"H0": 3, "V1": 3})
    for motif in ("fill", "strokes", "arcs"):
        yield f"cells {motif}", tw.draw_cells(cells, motif=motif)
        yield f"painted cells {motif}", tw.paint_cells(cells, motif=motif, size=12)
    yield "colored cells", tw.draw_cells(cells, colors=("#27548f", "#ecd5a3"), size=9)
    sets = {
        "corner": tw.corner_tiles(3),
        "wang": tw.wang_tiles(3, 2),
        "coded": tw.corner_coded_tiles(),
        "bricks": tw.brick_tiles(3),
        "kari": tw.aperiodic_tiles("kari-14"),
    }
    for name, tiles in sets.items():
        yield f"tiles {name}", tw.draw_tiles(tiles)
        yield f"painted tiles {name}", tw.paint_tiles(tiles)
        if name in ("corner", "wang", "coded"):
            tiling = tw.direct(tiles, 5)
            yield f"tiling {name}", tw.draw_tiling(tiling, -4, -3, 9, 7)
            yield f"painted tiling {name}", tw.paint_tiling(tiling, -4, -3, 9, 7, size=16)
    for name, tiles in (("corner", tw.corner_tiles(2)), ("wang", tw.wang_tiles(2))):
        for engrave in ("none", "colors", "numbers"):
            yield f"jigsaw {name} {engrave}", tw.draw_jigsaw(tw.packing(tiles), engrave=engrave, piece=25)
    pieces = tw.Jigsaw(tw.packing(tw.corner_tiles(2)))
    yield "outline", pieces.outline(1, 2)
    yield "row", pieces.row(1)
    wall = tw.endless_brick_tiling(3, 5)
    for mode in ("bricks", "lines"):
        yield f"wall {mode}", tw.draw_wall(wall, -90, -50, 400, 200, mode=mode, scale=0.5)
    yield "bond", tw.draw_wall(tw.BondBricks("herringbone"), 0, 0, 600, 300)


@in_folder
def commands(folder):
    maps = stack()
    for name, pixels in (
        ("photo", maps["albedo"]),
        ("second", photo(2)),
        ("normal", maps["normal"]),
        ("rough", maps["roughness"]),
        ("gray", (np.arange(24, dtype=np.uint8) * 10).reshape(4, 6, 1)),
        ("mask", np.full((SIDE, SIDE, 1), 255, np.uint8)),
    ):
        tw.write_image(folder / f"{name}.png", pixels)
    given = set(folder.iterdir())
    asked = [[*line.split(), "--json"] for line in COMMANDS.values()]
    done = subprocess.run(
        [sys.executable, "-c", _RUNNER],
        cwd=folder, input=json.dumps(asked), capture_output=True, text=True, check=True,
    )  # fmt: skip
    for name, (code, said) in zip(COMMANDS, json.loads(done.stdout), strict=True):
        yield name, {"code": code, **json.loads(said)}
    for path in sorted(folder.iterdir()):
        if path.is_dir():
            yield from folder_of(path.name, path)
        elif path not in given:
            yield path.name, path


GROUPS = {
    "saved sets": saved_sets,
    "files": files,
    "engines": engines,
    "exports": exports,
    "drawings": drawings,
    "commands": commands,
}
