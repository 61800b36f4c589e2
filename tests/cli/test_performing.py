"""What commands say while they work: progress, compiling, costs; and nothing where that is asked for."""

import json
import os
import subprocess
import sys
import warnings

import numpy as np
import pytest

import tilewright as tw
from tilewright import jobs
from tilewright.cli import performing
from tilewright.cli.main import run
from tilewright.kernels.compiling import Clock, Compiling


@pytest.fixture
def moments(monkeypatch):
    """A clock that is set by hand, in place of the one that progress looks at."""
    now = [100.0]
    monkeypatch.setattr(performing.time, "monotonic", lambda: now[0])
    return now


def call(*arguments):
    with pytest.raises(SystemExit) as ended:
        run([str(a) for a in arguments])
    return ended.value.code


def test_progress_is_a_line_every_ten_seconds_where_there_is_no_terminal(moments, capsys):
    with performing.progress_shown(quiet=False) as progress:
        for done in range(41):
            progress(done, 40, f"center:{done}")
            moments[0] += 1
    assert capsys.readouterr().err.splitlines() == [
        "tilewright: center:10: 25%, about 30 s left",
        "tilewright: center:20: 50%, about 20 s left",
        "tilewright: center:30: 75%, about 10 s left",
        "tilewright: center:40: 100%, about 0 s left",
    ]


def test_time_left_is_measured_anew_in_each_part_of_the_work(moments):
    pace = performing.Pace()
    for done in range(5):
        assert pace.left(done, 4) == ("" if done < 2 else f"about {4 - done} s left")
        moments[0] += 1
    assert pace.left(0, 1000) == ""
    moments[0] += 100
    assert pace.left(100, 1000) == "about 15 minutes left"
    assert pace.left(50, 1000) == ""


def test_quiet_says_nothing_but_the_result(tmp_path, gravel, capsys, moments):
    tw.write_image(tmp_path / "g.png", gravel[:64, :64])
    wanted = ("texture", tmp_path / "g.png", "-o", tmp_path / "set", "--tile-size", 16)
    assert call(*wanted, "--weight", "albedo=2", "--quiet") == 0
    out = capsys.readouterr()
    assert (out.err, out.out.count("\n")) == ("", 1)
    with performing.progress_shown(quiet=True) as progress:
        moments[0] += 100
        progress(1, 2, "work")
    assert capsys.readouterr().err == ""


def test_notes_are_silent_only_where_that_is_asked_for(tmp_path, capsys):
    stripes = np.tile(np.repeat(np.array([20, 200], np.uint8), 12), 8)
    tw.write_image(tmp_path / "stripes.png", np.tile(stripes, (192, 1))[..., None])
    wanted = ("texture", tmp_path / "stripes.png", "--tile-size", 32, "--tiles", "corner", "--force")
    for options, noted in ((("--quiet",), False), ((), True)):
        with warnings.catch_warnings():
            warnings.simplefilter("always")
            assert call(*wanted, "-o", tmp_path / "set", *options) == 0
        assert ("note:" in capsys.readouterr().err) == noted


def test_what_a_run_would_cost_is_said_without_it(tmp_path, gravel, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    tw.write_image("g.png", gravel[:200, :200])
    texture = ("texture", "g.png", "--tile-size", 32, "--json")
    assert call(*texture, "--dry-run") == 0
    foreseen = json.loads(capsys.readouterr().out)
    assert [p.name for p in tmp_path.iterdir()] == ["g.png"]
    assert call(*texture) == 0
    made = json.loads(capsys.readouterr().out)
    assert foreseen["output"] == made["folder"] == "g-tiles"
    assert {n: foreseen[n] for n in ("tiles", "tile_size")} == {n: made[n] for n in ("tiles", "tile_size")}
    assert 0 < foreseen["seconds"] < 100
    assert call("points", "--count", 9, "--colors", 5, "--dry-run") == 0
    assert "builds tiles True" in capsys.readouterr().out
    assert call("texture", "g.png", "-o", "g-tiles", "--seed", 4, "--dry-run") == 2
    assert call("compare", "--dry-run") == 0
    assert capsys.readouterr().out == "nothing would be written\n"


def test_another_seed_of_point_tiles_is_told_from_other_points(tmp_path):
    job = jobs.PointsJob(count=9, output=tmp_path / "p.npy", seed=1)

    def stop(done, total, what):
        raise tw.Cancelled

    noted = pytest.warns(tw.TilewrightWarning, match="the lattice seed gives other points")
    with noted, pytest.raises(tw.Cancelled):
        job.run(stop)


def test_compiling_is_announced_once_and_not_counted(monkeypatch):
    told, now = [], [50.0]
    monkeypatch.setattr("tilewright.kernels.compiling.time.perf_counter", lambda: now[0])
    monkeypatch.setattr(Compiling, "seconds", 0.0)
    monkeypatch.setattr(Compiling, "announce", lambda: told.append(now[0]))
    clock = Clock()
    now[0] = 51
    Compiling.begin()
    now[0] = 54
    Compiling.begin()
    now[0] = 56
    Compiling.end()
    now[0] = 57
    Compiling.end()
    Compiling.begin()
    now[0] = 58
    Compiling.end()
    now[0] = 60
    assert (told, Compiling.seconds, clock.seconds) == ([51], 7, 3)


def test_the_first_use_says_that_it_compiles_and_the_second_does_not(tmp_path):
    said = []
    wanted = (sys.executable, "-m", "tilewright", "points", "--count", "9", "-o")
    for number in range(2):
        done = subprocess.run(
            [*wanted, str(tmp_path / f"{number}.npy")],
            env=os.environ | {"XDG_CACHE_HOME": str(tmp_path), "LOCALAPPDATA": str(tmp_path)},
            capture_output=True, text=True, check=True,
        )  # fmt: skip
        said.append(done.stderr)
    assert said[0].startswith("tilewright: compiling, once for this version\n")
    assert "compiling" not in said[1]


def test_warming_does_work_of_every_kind(monkeypatch):
    made = []
    kinds = {name for name in dir(jobs) if name.endswith("Job")} - {"Job", "WarmJob"}
    for name in kinds:
        monkeypatch.setattr(getattr(jobs, name), "run", lambda self: made.append(type(self).__name__))
    done = jobs.WarmJob().run()
    assert done.files == ()
    # Pages and what is read are no loops, and a comparison is of points, which others of these do.
    assert set(made) == kinds - {"ViewJob", "InfoJob", "CompareJob"}
