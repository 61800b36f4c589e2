"""Files and folders that stand whole or not at all: written under another name, then renamed."""

import os
import shutil
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from tilewright.errors import TilewrightFileError


@contextmanager
def _explained(path: Path) -> Iterator[None]:
    """Turn an operating system's refusal into one line that names ``path``."""
    try:
        yield
    except TilewrightFileError:
        raise
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise TilewrightFileError(f"{path} could not be written: {reason}") from None
    except ValueError as error:
        if "null byte" not in str(error):
            raise
        raise TilewrightFileError(f"{str(path)!r} could not be written: {error}") from None


def _real(path: Path) -> Path:
    """Where ``path`` leads, links followed; its parent must be there."""
    real = Path(os.path.realpath(path))
    if not real.parent.is_dir():
        raise TilewrightFileError(f"{path} could not be written: the folder {real.parent} does not exist")
    return real


@contextmanager
def whole_file(path: str | Path) -> Iterator[Path]:
    """Yield a name to write to; it becomes ``path`` when the block ends well, and is gone otherwise."""
    path = Path(path)
    with _explained(path):
        real = _real(path)
        if real.is_dir():
            raise TilewrightFileError(f"{path} is a folder; a file name is expected")
        if real.exists() and not real.is_file():
            raise TilewrightFileError(f"{path} is not a plain file; choose another name")
        handle, name = tempfile.mkstemp(prefix=".unfinished-", suffix=path.suffix, dir=real.parent)
        os.close(handle)
        unfinished = Path(name)
        try:
            yield unfinished
            os.chmod(unfinished, 0o666 & ~_umask())
            os.replace(unfinished, real)
        finally:
            unfinished.unlink(missing_ok=True)


@contextmanager
def whole_folder(path: str | Path, objection: Callable[[Path], str]) -> Iterator[Path]:
    """Yield a new folder to fill; it becomes ``path`` when the block ends well, and is gone otherwise.

    A folder that is there already and is not empty is replaced, unless there is an ``objection``.
    """
    path = Path(path)
    with _explained(path):
        real = _real(path)
        if real.exists() and not real.is_dir():
            raise TilewrightFileError(f"{path} is a file; a folder is expected")
        if real.is_dir() and any(real.iterdir()) and (reason := objection(real)):
            raise TilewrightFileError(f"{path} {reason}; choose a new folder")
        unfinished = Path(tempfile.mkdtemp(prefix=".unfinished-", dir=real.parent))
        try:
            yield unfinished
            os.chmod(unfinished, 0o777 & ~_umask())
            _put(unfinished, real)
        finally:
            shutil.rmtree(unfinished, ignore_errors=True)


def _put(new: Path, path: Path) -> None:
    """Give a folder its name; one that had the name is removed afterwards, or gets it back."""
    if not path.exists():
        os.replace(new, path)
        return
    old = Path(tempfile.mkdtemp(prefix=".replaced-", dir=path.parent))
    try:
        os.replace(path, old / path.name)
        try:
            os.replace(new, path)
        except BaseException:
            os.replace(old / path.name, path)
            raise
    finally:
        shutil.rmtree(old, ignore_errors=True)


def _umask() -> int:
    current = os.umask(0)
    os.umask(current)
    return current
