"""Loops shared among threads: every number once, and what goes wrong in one thread comes out."""

import os
import threading

import numpy as np
import pytest

from cores import cores
from tilewright.kernels.threads import ParallelKernel


def count_up(first, last, out):
    assert last > first
    for i in range(first, last):
        out[i] += 1


@pytest.mark.parametrize("threads", [1, 2, 7])
def test_every_number_is_done_once(threads):
    kernel = ParallelKernel(count_up)
    with cores(threads):
        for count in (0, 1, 2, 63, 64, 65, 1000):
            for _ in range(2):  # the second time it is known to be long
                out = np.zeros(count, int)
                kernel(count, out)
                assert (out == 1).all()


def test_short_work_stays_in_one_thread():
    seen = set()
    kernel = ParallelKernel(lambda first, last: seen.add(threading.get_ident()))
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
