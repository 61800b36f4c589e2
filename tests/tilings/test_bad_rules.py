"""Tilings under constraints, given what they should not be: one clear line, nothing half-written."""

import math

import numpy as np
import pytest

import tilewright as tw
from tilewright.cli.main import run
from tilewright.errors import TilewrightError

LIMITS = {"H0": 2, "V1": 2}
RAGGED = [[1], [1, 2]]
TOO_MANY = [[0, 1, 0, 0], [1, 0, 0, 1], [0, 0, 1, 0], [0, 0, 0, 1], [0, 1, 1, 1], [1, 1, 0, 0], [1, 1, 0, 1]]


@pytest.mark.parametrize(
    ("start", "limits", "options"),
    [
        ([[1]], {"H0": 1}, {}),
        ([[1, 0], [0, 1]], {"H0": 2}, {}),
        ([[0, 0, 0]], {}, {}),
        ([[0, 0, 0]], {"H0": math.inf}, {}),
        ([[0, 1], [1, 0]], {"H0": 1}, {"fixed": np.ones((2, 2), bool)}),
        ([[0, 2, 2]], {"H0": 3}, {"totals": {2: 2}}),
    ],
)
def test_where_nothing_is_to_be_changed_the_start_is_the_closest(start, limits, options):
    found = tw.closest_dapple(start, limits, **options)
    assert np.array_equal(found.tiling, start)
    assert (found.distance, found.bound) == (0, 0)


def test_where_all_is_fixed_what_violates_is_impossible():
    for limits, options in ((LIMITS, {}), ({}, {"totals": {1: 3}})):
        with pytest.raises(tw.Impossible):
            tw.closest_dapple([[0, 0, 0]], limits, fixed=np.ones((1, 3), bool), **options)


def test_windows_down_to_a_cell_are_solved():
    start = np.zeros((2, 128 * 128 // 2 + 1), np.uint8)
    start[:, ::2] = 1
    assert tw.closest_dapple(start, {"H0": 1, "H1": 1}).gap == 0
    corner = tw.random_start(129, 129, seed=1)
    corner[:128] = np.indices((128, 129)).sum(axis=0) % 2
    assert tw.closest_dapple(corner, LIMITS).distance > 0


def test_whole_numbers_of_numpy_are_pixels_too():
    wall, field = tw.endless_brick_tiling(3), tw.BrickField(tw.endless_brick_tiling(3))
    window = np.int64(-7), np.uint8(3), np.int32(9), np.uint8(8)
    plain = field.render_maps(-7, 3, 9, 8)
    assert all(np.array_equal(pixels, plain[name]) for name, pixels in field.render_maps(*window).items())
    assert np.array_equal(field.render(*window), field.render(-7, 3, 9, 8))
    assert tw.draw_wall(wall, *window) == tw.draw_wall(wall, -7, 3, 9, 8)


CALLS = {
    "scale is nan": lambda: tw.draw_wall(tw.endless_brick_tiling(3), 0, 0, 144, 48, scale=math.nan),
    "scale must be a number": lambda: tw.draw_wall(tw.endless_brick_tiling(3), 0, 0, 144, 48, scale="x"),
    "seed is -1": lambda: tw.dapple([[0]], LIMITS, seed=-1),
    "seed must be an integer, not 1.5": lambda: tw.complete_dapple([[-1]], LIMITS, seed=1.5),
    r"seed must be an integer, not array\(3\)": lambda: tw.filled_tiling(
        tw.wang_tiles(2), 3, 3, seed=np.array(3)
    ),
    "shape must be": lambda: tw.dapple_formula(None, LIMITS),
    "height is 0": lambda: tw.dapple_formula((0, 0), LIMITS),
    "too many for a formula": lambda: tw.dapple_formula((20_000, 20_000), LIMITS),
    r"values has shape \(\)": lambda: tw.dapple_formula((2, 2), LIMITS).violated(None),
    "totals must be a mapping": lambda: tw.closest_dapple([[1]], LIMITS, totals=5),
    "totals must be a mapping .* not str": lambda: tw.count_dappled(2, 2, LIMITS, totals=""),
    "fixed is not a table": lambda: tw.dapple([[0]], LIMITS, fixed=RAGGED),
    "classes is not a table": lambda: tw.brick_tiling(RAGGED, 3),
    "mask is not a table": lambda: tw.brick_region(RAGGED, 3),
    "pixels are not equally long": lambda: tw.start_from_image(RAGGED, 3, 3),
    "packings is not a table": lambda: tw.classify_packings(tw.wang_tiles(2), RAGGED),
    "shares must be numbers": lambda: tw.random_start(3, 3, shares=None),
    "checkpoint must be": lambda: tw.PackingSearch(tw.wang_tiles(2), checkpoint=True),
    "checkpoint is of another": lambda: tw.PackingSearch(tw.wang_tiles(2), checkpoint={"tried": RAGGED}),
    "flow must be a Flow": lambda: tw.draw_trails(None),
    "colors must be a list": lambda: tw.paint_cells([[0, 1]], colors=5),
    r"start gave shape \(3,\)": lambda: tw.endless_dappled_tiling(
        LIMITS, start=lambda x, y: np.zeros(3)
    ).cells(0, 0, 5, 5),
    "constant and of single tiles, to dither": lambda: tw.start_from_image(
        np.zeros((9, 9)), 9, 9, 3, dither=True, limits={"H0+1": 2}
    ),
    "smaller must be a packing": lambda: tw.extend_packing(tw.direct(tw.corner_tiles(2))),
    "drawing must be": lambda: tw.save_svg("never.svg", None),
    "shape must be a Shape": lambda: tw.ListedTileSet(None, [[1, 2]]),
    "shape is \\[\\]": lambda: tw.tile_set([[1, 2, 3, 4]], []),
    "colors must be a tuple": lambda: tw.ListedTileSet(tw.wang_tiles(2).shape, [[0] * 4], np.array(3)),
    "4096 corner-coded tiles is neither": lambda: tw.density_tiling(tw.crossed_wang_tiles(2), lambda x, y: x),
    "name is array": lambda: tw.aperiodic_tiles(np.array([1, 2])),
    "positions must be an integer, not \\[": lambda: tw.brick_tiles([]),
    "size must be a width": lambda: tw.BrickField(tw.endless_brick_tiling(3), size=np.array([30, 40])),
    "progress must be": lambda: tw.random_packing(tw.wang_tiles(2), progress=3),
    "progress must be a function": lambda: tw.periodic_tiling(tw.wang_tiles(2), 3, 3, progress=True),
    "seconds must be a number": lambda: tw.closest_dapple([[1]], LIMITS, seconds=np.True_),
    "tiles must be an integer": lambda: tw.dapple([[1]], LIMITS, tiles=np.ones((30, 40))),
    "or a smaller margin": lambda: tw.drop_idle(tw.tile_set(TOO_MANY)),
}


@pytest.mark.parametrize("message", CALLS)
def test_bad_arguments_get_one_line(message):
    with pytest.raises(TilewrightError, match=message) as refused:
        CALLS[message]()
    assert "\n" not in str(refused.value)
    assert len(str(refused.value)) < 300


def test_positions_are_checked_whatever_was_asked_for_before():
    tw.brick_tiles(3)
    with pytest.raises(TilewrightError, match="positions must be an integer"):
        tw.brick_tiles(np.float64(3.0))


COMMANDS = {
    "empty.npz is empty": "bricks -o z.png --boundary empty.npz",
    "nope.npz does not exist": "bricks -o z.png --boundary nope.npz",
    "--boundary is of 4 x 3 cells": "bricks -o z.npy --boundary sides.npz --width 7",
    "is not a whole PNG image": "pack -o z.svg --picture cut.png",
    "nope.csv does not exist": "aperiodic nope.csv",
    "empty.csv is empty": "aperiodic empty.csv",
    "pins.npy does not hold tiles": "dapple --pins pins.npy",
    "width times height is": "bricks -o z --width 100000 --height 100000",
    "--x is 99999999999999999999": "bricks --x 99999999999999999999",
    "--x and --y are about walls that go on": "bricks -o z.npy --mask white.png --x 30",
    "--size is 0": "bricks --size 0 0",
    "--map is 'foo'": "bricks -o z.png --map foo",
    "--map has no use with a .npy file": "bricks -o z.npy --map id",
    "--lines is about drawings": "bricks --lines",
    "seed is -1": "pack --seed -1",
    "--engrave is about": "pack -o z.npy --engrave colors",
    "--limit is 'H2'": "flow --limit H2=3",
    "--every is 0": "flow -o q.gif --every 0 --steps 5",
    "--births is about cells that give birth": "flow -o q.gif --births 9 --steps 5",
    "--size is 200": "flow -o q.png --map trails --size 200",
    "--fps is 51": "flow -o q.gif --fps 51",
    "--color is 'red'": "flow -o q.gif --color red",
    "the number of pixels of a frame": "flow -o q.gif --width 2000 --height 2000",
    "frames times pixels": "flow -o q.gif --steps 100000",
    "--width has no use with --pins": "dapple -o z.png --pins whole.npy --width 0",
    "--cell has no use with a .npy file": "dapple -o z.npy --cell 0",
    "--x is about --endless": "dapple -o z.png --x 0",
    "--share is 1e+308": "dapple -o q.png --endless --share 1e308 --share 1e308",
    "name a set to draw": "aperiodic -o list.svg",
}


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("files")
    for name in ("empty.npz", "empty.csv"):
        (folder / name).touch()
    tw.write_image(folder / "white.png", np.full((9, 9, 1), 255, np.uint8))
    (folder / "cut.png").write_bytes((folder / "white.png").read_bytes()[:40])
    np.save(folder / "pins.npy", np.ones(3))
    np.save(folder / "whole.npy", np.full((4, 4), -1))
    np.savez(folder / "sides.npz", horizontal=np.full((4, 4), -1), vertical=np.full((3, 5), -1))
    (folder / "set.csv").write_bytes(b"\xef\xbb\xbf0,1,0,0\n0,0,0,1\n")
    return folder


@pytest.mark.parametrize("message", COMMANDS)
def test_bad_commands_get_one_line_and_leave_nothing(message, files, monkeypatch, capsys):
    monkeypatch.chdir(files)
    before = sorted(files.iterdir())
    with pytest.raises(SystemExit) as ended:
        run(COMMANDS[message].split())
    said = capsys.readouterr().err
    assert ended.value.code == 2
    assert message in said
    assert said.count("\n") == 1
    assert sorted(files.iterdir()) == before


def test_tables_of_spreadsheets_and_large_suffixes_are_read_and_written(files, tmp_path, capsys):
    for arguments in (
        ["aperiodic", str(files / "set.csv"), "--set", "-o", str(tmp_path / "set.NPY".lower())],
        ["bricks", "-o", str(tmp_path / "wall.NPY"), "--width", "4", "--height", "4"],
    ):
        with pytest.raises(SystemExit) as ended:
            run(arguments)
        assert ended.value.code == 0
    assert np.load(tmp_path / "set.npy").tolist() == [[0, 1, 0, 0], [0, 0, 0, 1]]
    assert (tmp_path / "wall.NPY").exists()


def test_a_flow_keeps_its_own_cells():
    cells = np.zeros((4, 4), np.uint8)
    flow = tw.simulate_flow(cells, particles=1, steps=1)
    cells[:] = 1
    assert flow.cells.max() == 0
    assert np.array_equal(tw.simulate_flow(cells.astype(object), particles=1, steps=1).cells, cells)


def test_speeds_of_strewn_cells_stay_in_their_range():
    _, tiles = tw.strew_tiles([[0, 1]], tiles=(tw.FlowTile("-", 0.001), tw.FlowTile("|", 8)), emitting=0.5)
    assert (min(t.speed for t in tiles), max(t.speed for t in tiles)) == (0.001, 8)


def test_small_walls_close_and_seeds_make_other_walls(tmp_path):
    made = []
    for seed in range(5):
        for file, options in (("a.npy", ["--cyclic"]), ("b.npy", [])):
            with pytest.raises(SystemExit) as ended:
                run(["bricks", "-o", str(tmp_path / file), "--width", "4", "--height", "4",
                         "--force", "--seed", str(seed), *options])  # fmt: skip
            assert ended.value.code == 0
            made.append(np.load(tmp_path / file).tobytes())
    assert len(set(made)) == 10
