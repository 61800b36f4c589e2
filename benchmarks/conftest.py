"""Benchmarks record their ratios; when all have run, these are compared with the stored ones."""

from pathlib import Path

import pytest

from ratios import STORED, compare_ratios, read_ratios, store_ratios

FOUND = pytest.StashKey()
PHOTOGRAPHS = Path(__file__).parents[2] / "shared" / "data" / "textures"


def pytest_addoption(parser):
    parser.addoption("--update-ratios", action="store_true", help=f"write the ratios to {STORED.name}")


def pytest_configure(config):
    config.stash[FOUND] = {}


@pytest.fixture
def record_ratio(request):
    """Call it with a name and the least seconds of a peer and of ours, before anything is judged.

    The least, since what else runs on the machine only adds to a time.
    """

    def record(name, peer, ours):
        request.config.stash[FOUND][name] = peer / ours

    return record


def pytest_terminal_summary(terminalreporter, config):
    found = config.stash[FOUND]
    if not found:
        return
    lines = compare_ratios(read_ratios(), found)
    terminalreporter.section(f"{len(found)} ratios")
    for line in lines:
        terminalreporter.line(line)
    if config.getoption("--update-ratios"):
        store_ratios(found)
        terminalreporter.line(f"written to {STORED.name}")
    elif not lines:
        terminalreporter.line("none fell by more than a third")
