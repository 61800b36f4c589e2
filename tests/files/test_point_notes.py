"""What is written of points is read: box, corner, method, promise, seeds and version, in every format."""

import json
import warnings

import numpy as np
import pytest

import tilewright as tw
from tilewright.cli.main import run
from tilewright.errors import TilewrightFileError


def command(*arguments, code=0):
    with pytest.raises(SystemExit) as end:
        run([str(a) for a in arguments])
    assert end.value.code == code


ROOMY = [".npz", ".csv", ".txt", ".parquet", ".ply"]
MADE = tw.PointSet(
    np.random.default_rng(1).random((50, 2)) * (3, 2),
    tw.Box((3, 2), torus=False),
    "darts of mine",
    0.0125,
    {"seed": 7, "corner": (-5.0, 1000.0), "maximal": np.bool_(True)},
)


@pytest.mark.parametrize("suffix", ROOMY)
def test_all_that_is_known_comes_back(tmp_path, suffix):
    path = tmp_path / f"p{suffix}"
    text = suffix in (".csv", ".txt")
    tw.write_points(path, MADE.points + MADE.figures["corner"], about=MADE, note=text)
    found = tw.read_points(path)
    assert (found.box, found.method, found.distance) == (MADE.box, MADE.method, MADE.distance)
    assert found.figures == {"seed": 7, "corner": (-5.0, 1000.0), "maximal": True}
    np.testing.assert_allclose(found.points, MADE.points, atol=1e-12)
    assert f"tilewright {tw.__version__}".encode() in path.read_bytes().replace(b"\0", b"")


@pytest.mark.parametrize("suffix", [".npy", ".npz", ".csv", ".txt", ".parquet", ".ply"])
def test_points_alone_come_back_exactly(tmp_path, suffix):
    points = np.array([[1e-7, 0.1 + 0.2], [3.0, 1e22], [0.5, 5e-324], [2.0, 12345678901.5]])
    tw.write_points(tmp_path / f"p{suffix}", iter([points[:1], points[1:]]), 4)
    found = tw.read_points(tmp_path / f"p{suffix}", tw.Box((1e30, 1e30)))
    np.testing.assert_array_equal(found.points, points)
    again = (tmp_path / f"p{suffix}").read_bytes()
    tw.write_points(tmp_path / f"p{suffix}", points)
    # Parquet keeps blocks as groups of rows.
    assert suffix == ".parquet" or (tmp_path / f"p{suffix}").read_bytes() == again


def test_plain_readers_find_no_note_in_a_table(tmp_path):
    tw.write_points(tmp_path / "p.csv", MADE)
    assert (tmp_path / "p.csv").read_text().splitlines()[0] == '"x","y"'
    tw.write_points(tmp_path / "p.txt", MADE)
    np.testing.assert_array_equal(np.loadtxt(tmp_path / "p.txt"), MADE.points)


def test_an_older_parquet_file_is_read(tmp_path):
    pytest.importorskip("pyarrow")
    import pyarrow
    import pyarrow.parquet

    note = {b"tilewright": json.dumps({"extent": [3.0, 2.0], "torus": True}).encode()}
    table = pyarrow.table({"x": [0.5, 2.5], "y": [0.5, 1.5]}).replace_schema_metadata(note)
    pyarrow.parquet.write_table(table, tmp_path / "old.parquet")
    found = tw.read_points(tmp_path / "old.parquet")
    assert (found.box, found.method) == (tw.Box((3, 2)), "old")


@pytest.mark.parametrize(
    "note", ["{[", "{}", '{"extent": [1, 0], "torus": true}', '{"extent": 3, "torus": 1}']
)
def test_a_damaged_note_is_one_line(tmp_path, note):
    (tmp_path / "p.csv").write_text(f"# tilewright {note}\n0.5,0.5\n0.25,0.75\n")
    with pytest.raises(TilewrightFileError) as refusal:
        tw.read_points(tmp_path / "p.csv")
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize("suffix", ROOMY)
@pytest.mark.parametrize(
    ("options", "box", "corner"),
    [
        (["--count", 700], tw.Box((5, 5), torus=False), None),
        (["--width", 3, "--height", 2.5, "--x", -7.5, "--y", 3], tw.Box((3, 2.5), torus=False), (-7.5, 3.0)),
        (["--width", 4, "--height", 3, "--torus"], tw.Box((4, 3)), None),
    ],
)
def test_the_command_tells_its_box(tmp_path, suffix, options, box, corner):
    path = tmp_path / f"p{suffix}"
    note = ["--note"] if suffix in (".csv", ".txt") else []
    command("points", "-o", path, "--lattice-seed", 5, *options, *note)
    found = tw.read_points(path)
    assert found.box == box
    assert found.figures.get("corner") == corner
    assert (found.figures["seed"], found.figures["lattice_seed"]) == (tw.ready_tiles().recipe["seed"], 5)
    assert found.distance == pytest.approx(tw.ready_tiles().distance)
    assert (found.points < found.box.extent).all()


def test_a_sampler_tells_its_seed(tmp_path):
    command("points", "-o", tmp_path / "p.npz", "--method", "dart", "--count", 300, "--seed", 4, "--torus")
    found = tw.read_points(tmp_path / "p.npz")
    assert (found.method, found.box, found.figures["seed"]) == ("dart", tw.Box(), 4)
    assert found.distance > 0


def test_analyze_says_which_box_it_assumed(tmp_path, capsys):
    command("points", "-o", tmp_path / "p.csv", "--count", 2000)
    capsys.readouterr()
    with warnings.catch_warnings():
        warnings.simplefilter("always")
        command("analyze", tmp_path / "p.csv", "--json")
    said = capsys.readouterr()
    assert "names no box" in said.err
    figures = json.loads(said.out)
    assert figures["torus"] is False
    assert figures["box"] == pytest.approx([8, 8], rel=0.05)
    command("points", "-o", tmp_path / "q.ply", "--count", 2000)
    capsys.readouterr()
    command("analyze", tmp_path / "q.ply", "--json")
    said = capsys.readouterr()
    assert said.err == ""
    assert json.loads(said.out)["box"] == [8, 8]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (["--torus", "--count", 1, "--seed", 1], "--torus takes --width and --height"),
        (["--method", "kopf", "--torus"], "--torus takes --width and --height"),
        (["--count", 1, "--seed", 1, "--x", 0.5], "whole tiles where --count stands alone"),
        (["--seed", 1], "give --count, or --width and --height"),
        (["--method", "dart", "--seed", 1], "dart needs --count"),
    ],
)
def test_clashes_are_told_before_tiles_are_made(tmp_path, capsys, monkeypatch, options, message):
    from tilewright.jobs.points import PointsJob

    def make(job, progress):
        raise AssertionError("tiles were made first")

    monkeypatch.setattr(PointsJob, "_tiles", make)
    command("points", "-o", tmp_path / "p.npy", *options, code=2)
    assert message in capsys.readouterr().err


def test_one_name_for_two_things_is_refused(tmp_path, capsys):
    command("points", "--count", 1, "--save", tmp_path / "a.npy", "-o", tmp_path / "a.npy", code=2)
    assert "have the same name" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_columns_of_sets_and_windows():
    blue = tw.ready_tiles()
    window = tw.PointField(blue, tw.direct(blue.tiles, seed=7)).window(2.5, 2.5, 3, 3)
    columns = window.columns()
    assert list(columns) == ["x", "y", "cell_x", "cell_y", "number", "rank", "id"]
    np.testing.assert_array_equal(columns["id"], window.ids)
    far = tw.PointField(blue, tw.direct(blue.tiles, seed=7)).window(2**40, 0, 1, 1)
    assert "id" not in far.columns()
    assert list(MADE.columns()) == ["x", "y"]
    pyarrow = pytest.importorskip("pyarrow")
    table = window.to_arrow()
    assert isinstance(table, pyarrow.Table)
    np.testing.assert_array_equal(table.column("x").to_numpy(), window.points[:, 0])
