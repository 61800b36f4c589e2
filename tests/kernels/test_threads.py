"""Loops shared among threads: every number once, and what goes wrong in one thread comes out."""

import os
import subprocess
import sys
import threading
import time
from unittest import mock

import numpy as np
import pytest

from cores import cores
from tilewright.kernels import threads
from tilewright.kernels.threads import ParallelKernel, at_most


def count_up(first, last, out):
    assert last > first
    for i in range(first, last):
        out[i] += 1


@pytest.mark.parametrize("most", [1, 2, 7])
def test_every_number_is_done_once(most):
    kernel = ParallelKernel(count_up)
    with cores(most):
        for count in (0, 1, 2, 63, 64, 65, 1000):
            for _ in range(2):  # the second time it is known to be long
                out = np.zeros(count, int)
                kernel(count, out)
                assert (out == 1).all()


def test_short_work_stays_in_one_thread():
    seen = set()
    kernel = ParallelKernel(lambda first, last: seen.add(threading.get_ident()))
    with mock.patch.object(threads, "_WORTH", 1.0):
        for _ in range(5):
            kernel(1000)
    assert seen == {threading.get_ident()}


def test_long_work_is_shared():
    seen = set()

    def meet(first, last, both):
        if len(seen) < 2:
            seen.add(threading.get_ident())
            both.wait(10)  # which nobody gets past alone

    with cores(2):
        kernel = ParallelKernel(count_up)
        kernel(1000, np.zeros(1000))
        kernel.kernel = meet
        kernel(1000, threading.Barrier(2))
    assert len(seen) == 2


@pytest.mark.parametrize("bad", [0, 500, 999])
def test_an_error_in_any_part_comes_out(bad):
    def fail(first, last):
        if first <= bad < last:
            raise IndexError(bad)

    with cores(3), pytest.raises(IndexError, match=str(bad)):
        ParallelKernel(fail)(1000)


def test_many_callers_at_once():
    kernel, outs = ParallelKernel(count_up), [np.zeros(500, int) for _ in range(8)]
    with cores(3):
        callers = [threading.Thread(target=kernel, args=(500, out)) for out in outs]
        for caller in callers:
            caller.start()
        for caller in callers:
            caller.join(10)
    assert all((out == 1).all() for out in outs)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="only some systems fork")
@pytest.mark.filterwarnings("ignore:.*multi-threaded.*fork:DeprecationWarning")
def test_a_forked_child_has_its_own_threads():
    kernel = ParallelKernel(count_up)
    with cores(3):
        kernel(100, np.zeros(100, int))
        child = os.fork()
        if child == 0:
            out = np.zeros(100, int)
            kernel(100, out)
            os._exit(0 if (out == 1).all() else 1)
        assert os.waitpid(child, 0)[1] == 0


def test_no_thread_writes_on_when_an_error_is_out():
    done = []

    def fail_late(first, last):
        if first > 500:
            raise ValueError(first)
        time.sleep(0.01)
        done.append(first)

    with cores(3):
        kernel = ParallelKernel(fail_late)
        with pytest.raises(ValueError, match=r"\d+"):
            kernel(1000)
        there = len(done)
        time.sleep(0.1)
        assert len(done) == there


def test_kernels_work_where_no_thread_can_be_started():
    out = np.zeros(1000, int)
    with cores(3), mock.patch.object(threads, "_open_pool", side_effect=RuntimeError):
        ParallelKernel(count_up)(1000, out)
    assert (out == 1).all()


def test_a_thread_that_outlives_the_main_one_still_renders():
    code = (
        "import threading, time, numpy as np\n"
        "from tilewright.kernels import threads\n"
        "threads._WORTH = 1e-12\n"
        "def fill(first, last, out): out[first:last] = 1\n"
        "def late():\n"
        "    time.sleep(0.3)\n"
        "    out = np.zeros(1000); threads.ParallelKernel(fill)(1000, out); print(out.sum())\n"
        "threading.Thread(target=late).start()\n"
    )
    ran = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == "1000.0", ran.stderr


def test_a_limit_holds_for_the_thread_that_set_it():
    seen = set()
    kernel = ParallelKernel(lambda first, last: seen.add(threading.get_ident()))
    with cores(3), at_most(1):
        assert threads.count_threads() == 1
        kernel(1000)
    assert seen == {threading.get_ident()}
    with cores(3):
        assert threads.count_threads() == 3
