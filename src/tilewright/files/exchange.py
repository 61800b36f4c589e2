"""A new folder takes the name of an old one in one step, where the system can; else in two, and back."""

import ctypes
import errno
import os
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

_EXCHANGE = 2
"""RENAME_EXCHANGE of Linux's renameat2 and RENAME_SWAP of macOS's renamex_np: the same number."""
_HERE = -100
"""AT_FDCWD of Linux: names are meant from the current folder."""
_CANNOT = (errno.EINVAL, errno.ENOSYS, errno.ENOTSUP, errno.EPERM)
"""What systems and file systems answer that do not know it."""
_TAKEN = (errno.ENOTEMPTY, errno.EEXIST, errno.EACCES)
_ENDING = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))


def put_folder(new: Path, path: Path, spare: Path) -> None:
    """Give a folder its name; one that has the name then lies where the new one was, or in ``spare``.

    Parameters
    ----------
    new : Path
        The folder that is whole.
    path : Path
        Its name to be; nothing is there, or a folder.
    spare : Path
        A folder that is not there yet, to keep the old one in where names cannot be exchanged in one step.
    """
    if not path.exists():
        try:
            os.replace(new, path)
            return
        except OSError as error:
            if error.errno not in _TAKEN or not path.is_dir():
                raise
    if not exchange(new, path):
        _replace_in_two_steps(new, path, spare)


def exchange(one: Path, other: Path) -> bool:
    """Exchange the names of two folders in one step; False where the system cannot."""
    names = os.fsencode(one), os.fsencode(other)
    call = _exchanger()
    if call is None:
        return False
    if call(*names) == 0:
        return True
    number = ctypes.get_errno()
    if number in _CANNOT:
        return False
    raise OSError(number, os.strerror(number), str(other))


def _exchanger() -> Callable[[bytes, bytes], int] | None:
    """The system's own call, if it has one."""
    if os.name != "posix":
        return None
    library: Any = ctypes.CDLL(None, use_errno=True)
    if sys.platform == "darwin" and hasattr(library, "renamex_np"):
        return lambda one, other: int(library.renamex_np(one, other, _EXCHANGE))
    if sys.platform.startswith("linux") and hasattr(library, "renameat2"):
        return lambda one, other: int(library.renameat2(_HERE, one, _HERE, other, _EXCHANGE))
    return None


def _replace_in_two_steps(new: Path, path: Path, spare: Path) -> None:
    """Move the old folder away and the new one in; whatever happens, one of them has the name then."""
    kept = spare / path.name
    with signals_held():
        spare.mkdir(mode=0o700)
        try:
            os.replace(path, kept)
            os.replace(new, path)
        finally:
            if kept.exists() and not path.exists():
                os.replace(kept, path)


@contextmanager
def signals_held() -> Iterator[None]:
    """Let a signal that asks the program to end wait until the block has ended.

    Only handlers written in Python are held, and only the main thread ever runs those.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    met: list[tuple[int, Any]] = []
    before: dict[int, Any] = {}
    try:
        for number in _ENDING:
            if callable(handler := signal.getsignal(number)):
                before[number] = handler
                signal.signal(number, lambda number, frame: met.append((number, frame)))
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        if met:
            before[met[0][0]](*met[0])
