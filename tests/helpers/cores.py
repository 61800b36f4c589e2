"""Any number of threads for parallel kernels, however short their work is."""

from collections.abc import Iterator
from contextlib import contextmanager
from unittest import mock

import numba

from tilewright.kernels import threads


@contextmanager
def cores(count: int) -> Iterator[None]:
    """Share every loop among ``count`` threads."""
    with (
        mock.patch.object(numba.config, "NUMBA_NUM_THREADS", count),
        mock.patch.multiple(threads, _WORTH=1e-12, _pool=None),
    ):
        yield
