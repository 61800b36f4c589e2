"""That kernels are being compiled, and how long it took; free of numba, so that a command can ask at once."""

import time
from collections.abc import Callable


class Compiling:
    """What this process has compiled.

    Attributes
    ----------
    seconds : float
        How long it took.
    announce : callable or None
        Called when the first kernel is compiled that was not on disk.
    """

    seconds = 0.0
    announce: Callable[[], None] | None = None
    _depth = 0
    _began = 0.0

    @classmethod
    def begin(cls) -> None:
        """Note that a kernel is compiled now, perhaps within another that calls it."""
        if cls._depth == 0:
            cls._began = time.perf_counter()
            if cls.seconds == 0 and cls.announce is not None:
                cls.announce()
        cls._depth += 1

    @classmethod
    def end(cls) -> None:
        """Note that it is compiled."""
        cls._depth -= 1
        if cls._depth == 0:
            cls.seconds += time.perf_counter() - cls._began


class Clock:
    """Seconds of work since it was made, without those in which kernels were compiled."""

    def __init__(self) -> None:
        self._began = self._now()

    @staticmethod
    def _now() -> float:
        return time.perf_counter() - Compiling.seconds

    @property
    def seconds(self) -> float:
        """Seconds up to now."""
        return self._now() - self._began
