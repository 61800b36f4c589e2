"""Point files and folders of point tiles: round trips, and what is refused."""

import json
from dataclasses import replace

import numpy as np
import pytest

import tilewright as tw
from tilewright.cli.main import run
from tilewright.errors import TilewrightFileError, TilewrightTypeError, TilewrightValueError

POINTS = np.random.default_rng(1).random((500, 2))


@pytest.mark.parametrize("suffix", [".npy", ".csv", ".parquet"])
def test_points_come_back_exactly(tmp_path, suffix):
    path = tmp_path / f"p{suffix}"
    tw.write_points(path, tw.PointSet(POINTS))
    np.testing.assert_array_equal(tw.read_points(path, tw.Box()).points, POINTS)
    tw.write_points(path, iter([POINTS[:200], POINTS[200:]]), 500)
    np.testing.assert_array_equal(tw.read_points(path, tw.Box(torus=False)).points, POINTS)


def test_parquet_keeps_the_box(tmp_path):
    box = tw.Box((3.0, 2.0), torus=False)
    tw.write_points(tmp_path / "p.parquet", tw.PointSet(POINTS, box))
    assert tw.read_points(tmp_path / "p.parquet").box == box


def test_points_without_a_box_get_one_around_them(tmp_path):
    np.save(tmp_path / "p.npy", POINTS * 100 - 50)
    found = tw.read_points(tmp_path / "p.npy")
    assert not found.box.torus
    np.testing.assert_allclose(found.points - found.points[0], (POINTS - POINTS[0]) * 100)
    assert found.box.volume == pytest.approx(100**2, rel=0.1)


def test_ply_is_what_other_programs_read(tmp_path):
    tw.write_points(tmp_path / "p.ply", POINTS)
    head, _, body = (tmp_path / "p.ply").read_bytes().partition(b"end_header\n")
    assert b"element vertex 500" in head
    np.testing.assert_array_equal(np.frombuffer(body, "<f8").reshape(-1, 3)[:, :2], POINTS)


def write(path, text):
    path.write_bytes(text if isinstance(text, bytes) else text.encode())


BAD = {
    "missing": ("p.csv", None, "is not a file"),
    "suffix": ("p.doc", "1,2", "is not a point file"),
    "text": ("p.csv", "x,y\na,b\n", "not numbers"),
    "one column": ("p.csv", "x\n1\n2\n", "has one column"),
    "nan": ("p.csv", "x,y\n0.1,0.2\nnan,0.3\n", "coordinates must be finite"),
    "ragged": ("p.csv", "x,y\n0.1,0.2\n0.3\n", "damaged"),
    "empty": ("p.csv", "", "damaged"),
    "only a header": ("p.csv", "x,y\n", ""),
    "cut npy": ("p.npy", b"\x93NUMPY\x01\x00v\x00{'descr': '<f8', 'fortran_o", "damaged"),
    "no parquet": ("p.parquet", b"PAR1 nothing", "damaged"),
    "a line": ("p.csv", "x,y\n0.1,0.2\n0.1,0.3\n", "on a line"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_files_are_one_line(tmp_path, case):
    name, text, message = BAD[case]
    if text is not None:
        write(tmp_path / name, text)
    with pytest.raises(TilewrightFileError) as refusal:
        tw.read_points(tmp_path / name)
    assert message in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_csv_needs_no_header_and_other_columns_do_no_harm(tmp_path):
    write(tmp_path / "a.csv", "0.1,0.2\n0.3,0.4\n0.5,0.1\n")
    write(tmp_path / "b.csv", "name;y;x\na;0.2;0.1\nb;0.4;0.3\nc;0.1;0.5\n")
    box = tw.Box()
    np.testing.assert_array_equal(
        tw.read_points(tmp_path / "a.csv", box).points, tw.read_points(tmp_path / "b.csv", box).points
    )


def test_point_tiles_come_back(tmp_path):
    tiles = tw.make_point_tiles("template", 16, 0.7)
    tw.save(tiles, tmp_path / "set")
    again = tw.load(tmp_path / "set")
    for name in ("points", "starts", "ranks"):
        np.testing.assert_array_equal(getattr(again, name), getattr(tiles, name))
    assert (again.variants, again.distance, again.method) == (tiles.variants, tiles.distance, tiles.method)
    assert again.figures == tiles.figures
    assert again.recipe == tiles.recipe
    with pytest.raises(TilewrightFileError, match="holds points"):
        run_load_texture(tmp_path / "set")


def test_variants_are_stored(tmp_path):
    tiles, rng = tw.wang_tiles(1, 2), np.random.default_rng(1)

    def made(variants):
        return tw.PointTiles.of(tiles, [rng.random((3, 2)) for _ in range(len(variants))], variants=variants)

    weighted = tw.Variants.weighted([[1], [0, 2.5, 1], [3, 0], [1, 1]])
    for name, variants, schema, stored in (
        ("even", tw.Variants.uniform(tiles, 2), 2, 2),
        ("weighted", weighted, 3, [[2**24], [0, 11983726, 4793490], [2**24, 0], [2**23, 2**23]]),
    ):
        tw.save(made(variants), tmp_path / name)
        manifest = json.loads((tmp_path / name / "tileset.json").read_text())
        assert (manifest["schema"], manifest["variants"]) == (schema, stored)
        assert tw.load(tmp_path / name).variants == variants
    manifest["variants"][3] = [2**23, 5]
    (tmp_path / name / "tileset.json").write_text(json.dumps(manifest))
    with pytest.raises(TilewrightFileError, match="tile 3 do not add up"):
        tw.load(tmp_path / name)


def run_load_texture(folder):
    from tilewright.files import load_texture

    return load_texture(folder)


def test_a_changed_or_cut_point_folder_is_refused(tmp_path):
    tw.save(tw.ready_tiles(3), tmp_path / "set")
    file = tmp_path / "set" / "points.npz"
    whole = file.read_bytes()
    for damaged in (whole[:-100], whole[:1000] + b"x" + whole[1001:]):
        file.write_bytes(damaged)
        with pytest.raises(TilewrightFileError, match="checksum is wrong"):
            tw.load(tmp_path / "set")
    file.write_bytes(whole)
    manifest = json.loads((tmp_path / "set" / "tileset.json").read_text())
    manifest["variants"] = 2
    (tmp_path / "set" / "tileset.json").write_text(json.dumps(manifest))
    with pytest.raises(TilewrightFileError, match="starts has"):
        tw.load(tmp_path / "set")


@pytest.mark.parametrize("suffix", [".npy", ".csv", ".parquet", ".ply"])
def test_blocks_must_be_points_and_as_many_as_said(tmp_path, suffix):
    path = tmp_path / f"p{suffix}"
    for count in (499, 501, -1):
        with pytest.raises(TilewrightValueError, match="count is"):
            tw.write_points(path, iter([POINTS]), count)
    for bad in ([POINTS[:3].T], [np.full((2, 2), np.nan)]):
        with pytest.raises(TilewrightValueError):
            tw.write_points(path, iter(bad), 2)
    with pytest.raises(TilewrightTypeError):
        tw.write_points(path, None)
    with pytest.raises(TilewrightValueError, match="shape"):
        tw.write_points(path, tw.sample_points("uniform", 9, box=tw.Box((1, 1, 1))))
    assert list(tmp_path.iterdir()) == []
    tw.write_points(path, [[0.25, 0.5], [0.5, 0.75]])
    if suffix in (".npy", ".ply"):
        with pytest.raises(TilewrightTypeError, match="count"):
            tw.write_points(path, iter([POINTS]))


@pytest.mark.parametrize(
    "text",
    [
        "# x y\n0.1 0.2\n0.3 0.4\n",
        "  0.1   0.2\n 0.3 0.4\n",
        "x y\n0.1 0.2\n0.3 0.4\n",
        "#x,y\n0.1,0.2\n0.3,0.4\n",
    ],
)
def test_tables_written_by_numpy_are_read(tmp_path, text):
    write(tmp_path / "p.txt", text)
    np.testing.assert_array_equal(
        tw.read_points(tmp_path / "p.txt", tw.Box()).points, [[0.1, 0.2], [0.3, 0.4]]
    )


def test_what_is_saved_can_be_loaded(tmp_path):
    rows = [np.array([[0.1, 0.2], [0.6, 0.7]])] * 16
    tiles = tw.PointTiles.of(tw.corner_tiles(2), rows, distance=np.float32(0.25))
    again = tw.PointTiles(
        tiles.tiles, tiles.points.astype(float), tiles.starts.astype(np.uint64), tiles.ranks.astype(float)
    )
    for name, one in (("a", tiles), ("b", again)):
        tw.save(one, tmp_path / name)
        np.testing.assert_array_equal(tw.load(tmp_path / name).points, tiles.points)


@pytest.mark.parametrize(
    "change",
    [
        {"ranks": np.array([0.5, 0.1] * 16)},
        {"points": "a"},
        {"points": np.full((32, 2), 1.0)},
        {"distance": np.nan},
        {"distance": -1.0},
        {"variants": True},
        {"variants": 2},
        {"variants": tw.Variants.uniform(tw.corner_tiles(2), 2)},
        {"variants": tw.Variants.uniform(tw.corner_tiles(1), 16)},
        {"starts": np.arange(17) * 2.0},
        {"method": 3},
        {"recipe": None},
        {"tiles": None},
        {"ranks": np.full(32, 1.0)},
    ],
)
def test_point_tiles_that_make_no_sense_are_refused(change):
    made = tw.PointTiles.of(tw.corner_tiles(2), [np.array([[0.1, 0.2], [0.6, 0.7]])] * 16)
    with pytest.raises((TilewrightTypeError, TilewrightValueError)):
        replace(made, **change)


# The command line


def command(*arguments, code=0):
    with pytest.raises(SystemExit) as end:
        run([str(a) for a in arguments])
    assert end.value.code == code


@pytest.mark.parametrize(
    ("options", "count"),
    [
        (["--count", 12345], 12345),
        (["--count", 1000, "--width", 8, "--height", 5.5, "--x", 0.5], 1000),
        (["--width", 6, "--height", 4, "--torus"], 24 * 32),
        (["--method", "dart", "--count", 500, "--rho", 0.7, "--torus"], 500),
        (["--method", "template", "--points", 16, "--width", 5, "--height", 5], 400),
        (["--method", "corner", "--colors", 2, "--seed", 3, "--count", 700], 700),
    ],
)
def test_points_command(tmp_path, capsys, options, count):
    path = tmp_path / "p.npy"
    command("points", "-o", path, "--json", *options)
    figures = json.loads(capsys.readouterr().out)
    assert figures["count"] == count
    assert np.load(path).shape == (count, 2)


def test_saved_tiles_give_the_same_points(tmp_path, capsys):
    command(
        "points",
        "-o",
        tmp_path / "a.npy",
        "--count",
        900,
        "--colors",
        3,
        "--points",
        16,
        "--rho",
        0.7,
        "--method",
        "corner-relaxed",
        "--save",
        tmp_path / "set",
    )
    command("points", "-o", tmp_path / "b.npy", "--count", 900, "--tiles", tmp_path / "set")
    np.testing.assert_array_equal(np.load(tmp_path / "a.npy"), np.load(tmp_path / "b.npy"))


def test_analyze_command_reads_points(tmp_path, capsys):
    command("points", "-o", tmp_path / "p.parquet", "--width", 8, "--height", 8, "--torus")
    command("analyze", tmp_path / "p.parquet", "--json", "-o", tmp_path / "sheet.png")
    figures = json.loads(capsys.readouterr().out.splitlines()[-1])
    assert figures["rho"] >= 0.75
    assert (tmp_path / "sheet.png").stat().st_size > 10_000


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ([], "give --count, or --width and --height"),
        (["--width", 5], "go together"),
        (["--count", 0], "count is 0"),
        (["--count", 10, "--rho", 1.5], "rho is 1.5"),
        (["--count", 10, "--colors", 1], "take more colors, or variants"),
        (["--width", "nan", "--height", 3], "width is nan"),
        (["--method", "dart"], "dart needs --count"),
        (["--method", "dart", "--count", 10**12], "count is 1000000000000"),
        (["--method", "dart", "--count", 1000, "--rho", 0.9], "can be reached"),
        (["--method", "dream", "--count", 10], "method is 'dream'"),
        (["--width", 2.5, "--height", 2, "--torus"], "whole tiles"),
        (["--width", 3, "--height", 3, "--x", 1e17], "too coarse"),
        (["--count", 1000, "--x", 2**60], "too coarse"),
        (["--count", 10, "--method", "dart", "--save", "set"], "are for tiles"),
        (["--count", 10, "--colors", 9, "--rho", 0.5], "at most 4096"),
    ],
)
def test_points_command_refuses(tmp_path, capsys, options, message):
    command("points", "-o", tmp_path / "p.npy", *options, code=2)
    said = capsys.readouterr().err
    assert message in said
    assert said.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("suffix", ["npy", "csv", "xyz", "ply"])
def test_a_height_is_left_out_with_a_note(tmp_path, suffix):
    """Where all points have the same, as in a plane, nothing is said."""
    path = tmp_path / f"space.{suffix}"
    for flat in (False, True):
        space = np.random.default_rng(1).random((9, 3)) * (1, 1, not flat)
        if suffix == "npy":
            np.save(path, space)
        elif suffix == "ply":
            head = "ply\nformat ascii 1.0\nelement vertex 9\n" + "".join(
                f"property float {a}\n" for a in "xyz"
            )
            path.write_text(head + "end_header\n" + "".join(f"{x} {y} {z}\n" for x, y, z in space))
        else:
            header = "x,y,z\n" if suffix == "csv" else ""
            between = "," if suffix == "csv" else " "
            path.write_text(header + "".join(f"{x}{between}{y}{between}{z}\n" for x, y, z in space))
        if flat and suffix != "csv":  # of named columns of a text only two are read
            assert len(tw.read_points(path)) == 9
        else:
            with pytest.warns(tw.TilewrightWarning, match="left out, since points lie in a plane"):
                assert len(tw.read_points(path)) == 9
