"""Files and folders that stand whole or not at all: written under another name, then renamed."""

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from tilewright.errors import TilewrightFileError


def explain(path: Path, error: OSError) -> TilewrightFileError:
    """One line for an operating system's refusal."""
    return TilewrightFileError(f"{path} could not be written: {(error.strerror or str(error)).lower()}")


def _parent(path: Path) -> Path:
    parent = path.absolute().parent
    if not parent.is_dir():
        raise TilewrightFileError(f"{path} could not be written: the folder {parent} does not exist")
    return parent


@contextmanager
def whole_file(path: str | Path) -> Iterator[Path]:
    """Yield a name to write to; it becomes ``path`` when the block ends well, and is gone otherwise."""
    path = Path(path)
    if path.is_dir():
        raise TilewrightFileError(f"{path} is a folder; a file name is expected")
    try:
        handle, name = tempfile.mkstemp(prefix=".unfinished-", suffix=path.suffix, dir=_parent(path))
        os.close(handle)
    except OSError as error:
        if isinstance(error, TilewrightFileError):
            raise
        raise explain(path, error) from None
    unfinished = Path(name)
    try:
        yield unfinished
        os.chmod(unfinished, 0o666 & ~_umask())
        os.replace(unfinished, path)
    except TilewrightFileError:
        raise
    except OSError as error:
        raise explain(path, error) from None
    finally:
        unfinished.unlink(missing_ok=True)


@contextmanager
def whole_folder(path: str | Path, mark: str) -> Iterator[Path]:
    """Yield a new folder to fill; it becomes ``path`` when the block ends well, and is gone otherwise.

    A folder that is there already is replaced only if it is empty or holds a file called ``mark``.
    """
    path = Path(path)
    if path.exists() and not path.is_dir():
        raise TilewrightFileError(f"{path} is a file; a folder is expected")
    if path.is_dir() and any(path.iterdir()) and not (path / mark).is_file():
        raise TilewrightFileError(f"{path} holds other things and no {mark}; choose a new folder")
    try:
        unfinished = Path(tempfile.mkdtemp(prefix=".unfinished-", dir=_parent(path)))
    except OSError as error:
        if isinstance(error, TilewrightFileError):
            raise
        raise explain(path, error) from None
    try:
        yield unfinished
        os.chmod(unfinished, 0o777 & ~_umask())
        if path.exists():
            old = Path(tempfile.mkdtemp(prefix=".replaced-", dir=path.absolute().parent)) / "old"
            os.replace(path, old)
            os.replace(unfinished, path)
            shutil.rmtree(old.parent, ignore_errors=True)
        else:
            os.replace(unfinished, path)
    except TilewrightFileError:
        raise
    except OSError as error:
        raise explain(path, error) from None
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)


def _umask() -> int:
    current = os.umask(0)
    os.umask(current)
    return current
