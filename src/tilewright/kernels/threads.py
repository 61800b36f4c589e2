"""Loops shared among threads: each runs a compiled kernel, without the GIL, over parts of one range.

numba's own ``parallel=True`` makes the same loops take two to four times as long to compile, and one of its
thread pools ends the process when two threads call it at once.
"""

import os
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from contextvars import ContextVar
from itertools import pairwise
from time import perf_counter
from typing import Any

import numba
import numpy as np

_WORTH = 250e-6
"""Seconds of work that are worth a part of their own: waking a thread takes 50 to 100 microseconds."""

_PARTS = 8
"""Most parts of a range for each thread, so that none waits long for the last."""

_FIRST = 64
"""One part in so many is done at first where the work seems short, to see how long the rest will take."""

_pool: ThreadPoolExecutor | None = None
_limit: ContextVar[int | None] = ContextVar("limit", default=None)


def count_threads() -> int:
    """How many threads kernels use: the cores open to the process, or NUMBA_NUM_THREADS, or `at_most`."""
    most = int(numba.config.NUMBA_NUM_THREADS)
    return min(most, _limit.get() or most)


@contextmanager
def at_most(count: int) -> Iterator[None]:
    """Let kernels that this thread calls use no more threads."""
    before = _limit.set(count)
    try:
        yield
    finally:
        _limit.reset(before)


class ParallelKernel:
    """Calls ``kernel(first, last, *arguments)`` for parts of range(count), on all cores.

    What one number of the range writes, no other may read or write: the result is that of one thread.
    """

    def __init__(self, kernel: Callable[..., None]) -> None:
        self.kernel = kernel
        self._pace = 0.0  # seconds a number took when last measured, which says when it pays to share

    def __call__(self, count: int, *arguments: Any) -> None:
        threads, done = min(count_threads(), count), 0
        if threads > 1 and self._pace * count < 2 * _WORTH:
            done = -(-count // _FIRST)
            self._pace = self._do(0, done, arguments) / done
        if done == count:
            return
        parts = min(threads * _PARTS, int(self._pace * (count - done) / _WORTH))
        if threads > 1 and parts > 1:
            self._share(threads, np.linspace(done, count, parts + 1).astype(int).tolist(), arguments)
        else:
            self._pace = self._do(done, count, arguments) / (count - done)

    def _do(self, first: int, last: int, arguments: tuple[Any, ...]) -> float:
        """One part; the seconds it took."""
        begun = perf_counter()
        self.kernel(first, last, *arguments)
        return perf_counter() - begun

    def _share(self, threads: int, bounds: list[int], arguments: tuple[Any, ...]) -> None:
        parts = [(a, b) for a, b in pairwise(bounds) if a < b][::-1]

        def work() -> None:
            while True:
                try:
                    first, last = parts.pop()
                except IndexError:
                    return
                self._pace = self._do(first, last, arguments) / (last - first)

        helpers: list[Future[None]] = []
        try:
            for _ in range(min(threads, len(parts)) - 1):
                helpers.append(_open_pool().submit(work))
        except RuntimeError:
            pass  # no thread can be started when Python ends, or beyond the system's limit
        try:
            work()
        finally:
            parts.clear()
            helpers = [helper for helper in helpers if not helper.cancel()]
            wait(helpers)  # they write into the caller's arrays
        for helper in helpers:
            helper.result()


def _open_pool() -> ThreadPoolExecutor:
    global _pool
    if _pool is None:
        _pool = ThreadPoolExecutor(max(1, count_threads() - 1), "tilewright")
    return _pool


def _forget_pool() -> None:
    global _pool
    _pool = None  # its threads stayed in the parent


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forget_pool)
