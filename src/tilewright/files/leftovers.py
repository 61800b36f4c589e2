"""Names of what is not finished, and what becomes of it when the program that made it is dead."""

import os
import platform
import re
import shutil
import tempfile
import warnings
import zlib
from functools import cache
from pathlib import Path

from tilewright.errors import TilewrightWarning
from tilewright.files.exchange import signals_held

_NAME = re.compile(r"\.(unfinished|replaced)-([0-9a-f]{8})-(\d+)-\w+(\.\w+)?")


def _prefix(kind: str) -> str:
    """What tells whose a name is: this machine and this process."""
    return f".{kind}-{_machine()}-{os.getpid()}-"


@cache
def _machine() -> str:
    """Tell this machine from those that share a folder with it, whose processes are not known here."""
    return f"{zlib.crc32(platform.node().encode()):08x}"


def unfinished_file(folder: Path, suffix: str) -> Path:
    """A new empty file for what is to become a file of this folder."""
    handle, name = tempfile.mkstemp(prefix=_prefix("unfinished"), suffix=suffix, dir=folder)
    os.close(handle)
    return Path(name)


def unfinished_folder(folder: Path) -> Path:
    """A new empty folder for what is to become a folder in this one."""
    return Path(tempfile.mkdtemp(prefix=_prefix("unfinished"), dir=folder))


def name_for_replaced(unfinished: Path) -> Path:
    """Where an old folder goes whose name the unfinished one gets."""
    return unfinished.with_name(unfinished.name.replace("unfinished", "replaced", 1))


def remove(path: Path) -> None:
    """Remove a file or a folder with all it holds; what cannot be removed is told."""
    with signals_held():
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path, ignore_errors=True)
        else:
            path.unlink(missing_ok=True)
    if os.path.lexists(path):
        warnings.warn(
            f"parts of what was replaced could not be removed; they are in {path}",
            TilewrightWarning,
            stacklevel=5,
        )


@cache
def sweep(folder: Path) -> None:
    """Put back or remove what programs that were killed have left in a folder; once for each folder.

    Only what processes of this machine left that run no more.
    """
    for path in folder.iterdir():
        told = _NAME.fullmatch(path.name)
        if not told or told[2] != _machine() or _is_alive(int(told[3])):
            continue
        for old in path.iterdir() if told[1] == "replaced" else ():
            if not os.path.lexists(folder / old.name):
                os.replace(old, folder / old.name)
                _tell(f"{folder / old.name} is back: a run that was killed had moved it to {path.name}")
        remove(path)
        _tell(f"removed {path}, which a run that was killed had left")


def _is_alive(process: int) -> bool:
    """Whether a process of this number runs; where that cannot be asked without harm, it is said to."""
    if os.name != "posix":
        return True
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:
        return True
    return True


def _tell(message: str) -> None:
    warnings.warn(message, TilewrightWarning, stacklevel=6)
