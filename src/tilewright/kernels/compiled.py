"""How kernels are compiled and where the machine code is kept.

numba's on-disk cache does not notice when a function in another file changes, so the cache folder is
keyed by a digest of every kernel source: an edited kernel never meets stale machine code.
"""

import hashlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
from numba.core import event as events
from numba.core.types import unliteral
from platformdirs import user_cache_path

from tilewright.kernels.compiling import Compiling
from tilewright.kernels.threads import ParallelKernel


def _cache_folder() -> Path:
    digest = hashlib.sha256(numba.__version__.encode())
    for source in sorted(Path(__file__).parent.glob("*.py")):
        digest.update(source.name.encode() + source.read_bytes())
    return user_cache_path("tilewright") / "kernels" / digest.hexdigest()[:16]


_FOLDER = str(_cache_folder())


class _Listener(events.Listener):
    """Passes on when numba compiles what was not on disk."""

    def on_start(self, event: Any) -> None:
        Compiling.begin()

    def on_end(self, event: Any) -> None:
        Compiling.end()


events.register("numba:compile", _Listener())


def kernel(*, parallel: bool = False, inline: bool = False) -> Callable[..., Any]:
    """Compile a function on first call, without the GIL, cached in the folder of these sources.

    The first two parameters of a parallel one are the part of a range that it does; callers give the length
    of the range in their place (see `ParallelKernel`).

    numba reads its cache folder when a function is decorated; the setting is put back at once, so
    that other users of numba in the process keep theirs.
    """

    def decorate(function: Callable[..., Any]) -> Any:
        before = numba.config.CACHE_DIR
        numba.config.CACHE_DIR = _FOLDER
        try:
            compiled = numba.njit(
                cache=True, nogil=True, error_model="numpy", inline="always" if inline else "never"
            )(function)
        finally:
            numba.config.CACHE_DIR = before
        _take_literals_as_numbers(compiled)
        return ParallelKernel(compiled) if parallel else compiled

    return decorate


def _take_literals_as_numbers(compiled: Any) -> None:
    """Let kernels call this one with 0 and with 1 without compiling it for each."""
    resolve = getattr(compiled, "get_call_template", None)
    if resolve is not None:  # there is none where numba is switched off
        compiled.get_call_template = lambda args, kws: resolve([unliteral(a) for a in args], kws)
