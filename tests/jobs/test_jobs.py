"""Whole jobs without a command line: rules, what they write, and the commands that call them."""

import copy
import inspect
import pickle
import re
from dataclasses import FrozenInstanceError, fields
from pathlib import Path

import numpy as np
import pytest

import tilewright as tw
from tilewright import jobs
from tilewright.cli import main as commands
from tilewright.errors import TilewrightError
from tilewright.jobs.job import Clash

JOBS = {name.removesuffix("Job").lower(): getattr(jobs, name) for name in dir(jobs) if name.endswith("Job")}
del JOBS[""]
ASKED = {"folder": Path("set"), "output": Path("o.png"), "source": Path("set"), "width": 5, "height": 5}


def make(kind, **options):
    """A job with what it cannot do without."""
    needed = {
        f.name: ASKED[f.name] for f in fields(kind) if f.default is f.default_factory and f.name in ASKED
    }
    return kind(**needed | options)


@pytest.mark.parametrize("name", JOBS)
def test_a_command_has_the_options_of_its_job(name):
    command = getattr(commands, name).command
    options = set(inspect.signature(command).parameters) - {"json", "quiet", "dry_run"}
    options = {option.removesuffix("_methods") for option in options}
    known = {field.name for field in fields(JOBS[name])}
    assert known <= options
    assert options - known <= {"seed"}  # the seed of construction, where nothing is constructed


@pytest.mark.parametrize("name", JOBS)
def test_commands_hold_no_logic(name):
    module = inspect.getmodule(getattr(commands, name).command)
    _, _, body = inspect.getsource(module.command).rpartition('"""\n')
    assert len(body.splitlines()) < 12
    functions = [f for f in vars(module).values() if inspect.isfunction(f)]
    assert [f.__name__ for f in functions if f.__module__ == module.__name__] == ["command"]


CLASHES = {
    "dapple": [
        {"count": True, "x": 3},
        {"endless": True, "closest": True},
        {"dither": True},
        {"input": Path("a.png"), "share": [1, 2]},
        {"output": Path("a.npy"), "motif": "arcs"},
        {"output": Path("a.cnf"), "closest": True},
        {"seconds": 3.0},
    ],
    "texture": [
        {},
        {"from_": Path("s"), "seed": 1},
        {"like": Path("s")},
        {"photo": Path("p.png"), "reject": ["center:0"]},
        {"photo": Path("p.png"), "map": {"albedo": "a.png"}},
    ],
    "bricks": [
        {"mask": Path("m.png"), "cyclic": True},
        {"pattern": "herringbone", "positions": 4},
        {"output": Path("w.npy"), "mortar": 3},
        {"lines": True},
        {"output": Path("wall"), "map": "height"},
    ],
    "flow": [{"map": "density"}, {"leave": True, "cyclic": True}, {"births": 0.1}, {"dither": True}],
    "pack": [{"picture": Path("p.png")}, {"engrave": "colors"}],
    "export": [{"output": Path("folder"), "map": "albedo"}],
    "analyze": [{"width": 3.0}],
    "points": [{"width": 3.0, "height": None}],
    "aperiodic": [{"set": True}],
}


@pytest.mark.parametrize(("name", "options"), [(n, o) for n, many in CLASHES.items() for o in many], ids=str)
def test_options_that_clash_are_refused_at_once(name, options):
    with pytest.raises(Clash) as refused:
        make(JOBS[name], **options)
    assert "{" not in str(refused.value)
    shouted = refused.value.told(str.upper)
    assert shouted != str(refused.value) or name == "aperiodic"


def test_a_clash_can_be_copied_and_sent():
    with pytest.raises(Clash) as refused:
        jobs.DappleJob(count=True, x=3)
    for again in (copy.copy(refused.value), pickle.loads(pickle.dumps(refused.value))):
        assert again.told(str.upper) == "X has no use with COUNT; leave one of them out"


def test_a_job_is_frozen_options_and_a_run(tmp_path):
    job = jobs.DappleJob(output=tmp_path / "d.npy", width=12, height=9, seed=3)
    with pytest.raises(FrozenInstanceError):
        job.width = 5
    done = job.run()
    cells = np.load(tmp_path / "d.npy")
    assert done.files == (tmp_path / "d.npy",)
    assert np.array_equal(cells, tw.dapple(tw.random_start(12, 9, seed=3), {"H0": 2, "V1": 2}, seed=3))
    assert done.figures["changed"] > 0
    assert done.sentence.startswith(f"{tmp_path / 'd.npy'}: 12 x 9 cells")


def test_a_job_can_be_stopped_and_leaves_nothing(tmp_path, gravel):
    def stop(done, total, what):
        raise tw.Cancelled

    tw.write_image(tmp_path / "g.png", gravel[:128, :128])
    job = jobs.TextureJob(photo=tmp_path / "g.png", output=tmp_path / "set", tile_size=16)
    with pytest.raises(tw.Cancelled):
        job.run(stop)
    assert [p.name for p in tmp_path.iterdir()] == ["g.png"]


def test_files_are_refused_before_the_work(tmp_path):
    with pytest.raises(TilewrightError, match=r"ends in '\.txt'; allowed are"):
        jobs.PackJob(output=tmp_path / "a.txt", colors=8).run()
    (tmp_path / "none").write_text("")
    with pytest.raises(TilewrightError, match="none is not a folder"):
        jobs.FlowJob(output=tmp_path / "none" / "a.gif").run()


def test_a_flow_is_saved_with_its_tiles(tmp_path):
    flow = tw.simulate_flow(np.zeros((4, 5), int), (tw.FlowTile("-"),), particles=3, steps=4)
    tw.save_flow(tmp_path / "f.npz", flow)
    with np.load(tmp_path / "f.npz") as arrays:
        assert np.array_equal(arrays["positions"], flow.positions)
        assert arrays["tile_speed"].tolist() == [tile.speed for tile in flow.tiles]
    assert flow.figures["alive"] == 3
    with pytest.raises(TilewrightError, match="flow must be a Flow, not int"):
        tw.save_flow(tmp_path / "g.npz", 3)


def test_points_are_told_with_their_unit(tmp_path):
    """Distances of tiles are in tiles, those of a method without in the box."""
    of_tiles = jobs.PointsJob(output=tmp_path / "a.npy", width=4, height=4).run().sentence
    assert re.search(r"none closer than [0-9.]+ tiles, in ", of_tiles)
    sampled = jobs.PointsJob(output=tmp_path / "b.npy", method="dart", count=50).run().sentence
    assert re.search(r"none closer than [0-9.]+, in ", sampled)


def test_the_verdict_is_among_the_figures_of_an_analysis(tmp_path):
    jobs.PointsJob(output=tmp_path / "a.npz", method="dart", count=50, torus=True).run()
    done = jobs.AnalyzeJob(source=tmp_path / "a.npz").run()
    assert done.figures["verdict"][0].startswith("Good blue noise")
    assert done.figures["verdict"][0] in done.sentence
