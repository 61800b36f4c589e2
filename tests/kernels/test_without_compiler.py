"""Kernels mean the same as plain Python: small work with and without numba's compiler."""

import json
import os
import subprocess
import sys

import pytest

import small_kernels

# What needs more work than plain Python should do: long searches, balancing, sets of many points.
NOT_REACHED = {
    *("bricks.add_base", "bricks.lay_heights"),
    *("candidates.drop_cells", "candidates.find_corner", "candidates.measure_cells"),
    *("dappling.visit_blocks", "dappling.visit_any", "flow.walk_in_parallel"),
    *("growth.crosses", "growth.mark_kind", "growth.move_frame", "growth.move_interiors"),
    *("packing_search.count_tiles", "packing_search.draw_line", "packing_search.find_bases"),
    *("packing_search.redraw_lines", "packing_search.weigh_line"),
}


@pytest.fixture(scope="module")
def plain():
    """What plain Python gives, and the kernels it did not call."""
    done = subprocess.run(
        [sys.executable, small_kernels.__file__],
        env=os.environ | {"NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(done.stdout)


def test_plain_python_gives_the_same(plain):
    compiled = small_kernels.work()
    assert {name for name in compiled if plain[0].get(name) != compiled[name]} == set()
    assert len(compiled) > 40


def test_every_kernel_is_called(plain):
    assert set(plain[1]) - NOT_REACHED == set()
