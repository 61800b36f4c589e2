"""What is replaced is never lost: signals, kills, two writers, and what killed runs have left."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightError, TilewrightWarning
from tilewright.files import exchange, leftovers
from tilewright.files.atomic import whole_file, whole_folder


@pytest.fixture(autouse=True)
def _sweep_again():
    leftovers.sweep.cache_clear()


@pytest.fixture(params=["one step", "two steps"])
def steps(request, monkeypatch):
    """Replacing where the system exchanges names, and where it cannot."""
    if request.param == "two steps":
        monkeypatch.setattr(exchange, "exchange", lambda one, other: False)
    return request.param


def allow(folder):
    return ""


def fill(path, text):
    with whole_folder(path, allow) as folder:
        (folder / "letter").write_text(text)


def names(folder):
    return sorted(p.name for p in folder.iterdir())


def test_a_folder_takes_the_place_of_another(tmp_path, steps):
    fill(tmp_path / "a", "old")
    fill(tmp_path / "a", "new")
    assert (tmp_path / "a" / "letter").read_text() == "new"
    assert names(tmp_path) == ["a"]


@pytest.mark.skipif(os.name == "nt", reason="needs POSIX signals")
@pytest.mark.parametrize("when", [1, 2])
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM"])
def test_a_signal_between_the_renames_loses_nothing(tmp_path, monkeypatch, when, name):
    """As a signal that arrives during a rename: the exception comes when the call is done."""
    monkeypatch.setattr(exchange, "exchange", lambda one, other: False)
    rename, calls = os.replace, []

    def interrupted(source, target):
        rename(source, target)
        calls.append(target)
        if len(calls) == when:
            signal.raise_signal(getattr(signal, name))

    def end(number, frame):
        raise KeyboardInterrupt

    fill(tmp_path / "a", "old")
    before = signal.signal(getattr(signal, name), end)
    try:
        monkeypatch.setattr(os, "replace", interrupted)
        with pytest.raises(KeyboardInterrupt):
            fill(tmp_path / "a", "new")
    finally:
        signal.signal(getattr(signal, name), before)
    assert (tmp_path / "a" / "letter").read_text() in ("old", "new")
    assert names(tmp_path) == ["a"]


KILLED = """
import os, signal, sys
from pathlib import Path
from tilewright.files import exchange
from tilewright.files.atomic import whole_folder

rename, calls = os.replace, []

def killed(source, target):
    calls.append(target)
    if len(calls) == int(sys.argv[2]):
        os.kill(os.getpid(), signal.SIGKILL)
    rename(source, target)

exchange.exchange = lambda one, other: False
os.replace = killed
with whole_folder(Path(sys.argv[1]), lambda folder: "") as folder:
    (folder / "letter").write_text("new")
"""


@pytest.mark.skipif(os.name == "nt", reason="needs POSIX signals")
@pytest.mark.parametrize("when", [1, 2])
def test_the_next_run_mends_what_a_killed_one_left(tmp_path, when):
    fill(tmp_path / "a", "old")
    done = subprocess.run([sys.executable, "-c", KILLED, str(tmp_path / "a"), str(when)], timeout=60)
    assert done.returncode == -signal.SIGKILL
    assert len(names(tmp_path)) > 1
    leftovers.sweep.cache_clear()
    with pytest.warns(TilewrightWarning) as told:
        fill(tmp_path / "b", "other")
    said = " ".join(str(w.message) for w in told)
    assert "which a run that was killed had left" in said
    assert ("a is back" in said) == (when == 2)
    assert names(tmp_path) == ["a", "b"]
    assert (tmp_path / "a" / "letter").read_text() == "old"


def test_what_others_still_write_is_left_alone(tmp_path, monkeypatch):
    mine = leftovers.unfinished_file(tmp_path, ".png")
    monkeypatch.setattr(leftovers, "_machine", lambda: "00000000")
    far = leftovers.unfinished_folder(tmp_path)
    monkeypatch.undo()
    (tmp_path / ".unfinished-of-someone").mkdir()
    fill(tmp_path / "a", "x")
    assert mine.exists()
    assert far.exists()
    assert len(names(tmp_path)) == 4


def test_readers_always_meet_a_whole_folder(tmp_path):
    if not exchange_is_known(tmp_path):
        pytest.skip("this system cannot exchange names")
    fill(tmp_path / "a", "0")
    letter, met, over = tmp_path / "a" / "letter", [], threading.Event()

    def read():
        while not over.is_set():
            try:
                met.append(letter.read_text())
            except OSError as error:
                met.append(error)

    reader = threading.Thread(target=read)
    reader.start()
    for number in range(1, 60):
        fill(tmp_path / "a", str(number))
    over.set()
    reader.join()
    assert not [m for m in met if isinstance(m, OSError)]


def exchange_is_known(folder):
    (folder / "p").mkdir()
    (folder / "q").mkdir()
    known = exchange.exchange(folder / "p", folder / "q")
    (folder / "p").rmdir()
    (folder / "q").rmdir()
    return known


def test_two_writers_of_one_folder(tmp_path):
    failed = []

    def write():
        for number in range(40):
            try:
                fill(tmp_path / "a", str(number))
            except TilewrightError as error:
                failed.append(error)

    writers = [threading.Thread(target=write) for _ in range(2)]
    for writer in writers:
        writer.start()
    for writer in writers:
        writer.join()
    assert failed == []
    assert names(tmp_path) == ["a"]


def test_a_held_signal_comes_when_the_block_has_ended():
    seen = []
    before = signal.signal(signal.SIGINT, lambda number, frame: seen.append("handled"))
    try:
        with exchange.signals_held():
            signal.raise_signal(signal.SIGINT)
            time.sleep(0.01)
            seen.append("block")
        assert seen == ["block", "handled"]
        assert callable(signal.getsignal(signal.SIGINT))
    finally:
        signal.signal(signal.SIGINT, before)


def test_folders_above_are_made_and_go_again_where_the_work_fails(tmp_path):
    tw.write_image(tmp_path / "x" / "y" / "a.png", np.zeros((2, 2, 1), np.uint8))
    assert names(tmp_path / "x" / "y") == ["a.png"]
    with pytest.raises(RuntimeError), whole_file(tmp_path / "u" / "v" / "b.png"):
        raise RuntimeError
    assert names(tmp_path) == ["x"]
    with pytest.raises(TilewrightError, match=r"a\.png is not a folder"):
        fill(tmp_path / "x" / "y" / "a.png" / "deep" / "set", "")


def test_point_tiles_never_replace_texture_tiles(tmp_path, gravel):
    tw.save(tw.texture_tiles(gravel[:64, :64], tw.corner_tiles(1), tile_size=16), tmp_path / "set")
    before = sorted(tmp_path.rglob("*"))
    with pytest.raises(TilewrightError, match="holds tiles of signal 'texture'"):
        tw.save(tw.ready_tiles(), tmp_path / "set")
    assert sorted(tmp_path.rglob("*")) == before


def test_nothing_is_written_deep_inside_a_set(tmp_path):
    tw.save(tw.ready_tiles(), tmp_path / "set")
    deep = tmp_path / "set" / "a" / "b" / "y.png"
    with pytest.raises(TilewrightError, match="lies in the tile-set folder"):
        tw.write_image(deep, np.zeros((2, 2, 1), np.uint8))


@pytest.mark.skipif(sys.platform != "linux", reason="names are bytes on Linux")
def test_a_folder_above_that_is_no_utf8(tmp_path, monkeypatch):
    odd = os.path.join(os.fsencode(tmp_path), b"d\xff")
    os.mkdir(odd)
    monkeypatch.chdir(odd)
    with pytest.raises(TilewrightError, match="which is not a name in UTF-8"):
        tw.write_image("a.png", np.zeros((2, 2, 1), np.uint8))
