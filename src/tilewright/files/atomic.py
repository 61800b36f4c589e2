"""Files and folders that stand whole or not at all: written under another name, then renamed."""

import os
import shutil
import tempfile
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from tilewright.checks import check_type
from tilewright.errors import (
    TilewrightFileError,
    TilewrightValueError,
    TilewrightWarning,
)

AnyPath = str | os.PathLike[str]
"""A name of a file or folder."""
MANIFEST = "tileset.json"
"""The file that makes a folder a tile-set folder."""


def as_path(given: AnyPath) -> Path:
    """A path, or one clear line where it is of another type or cannot be written out as text."""
    check_type("path", given, (str, os.PathLike), "a str or a Path")
    path = Path(given)
    if not str(given):
        raise TilewrightValueError("is empty; a file or folder name is expected", argument="path")
    try:
        str(path).encode()
    except UnicodeEncodeError:
        raise TilewrightValueError(
            f"{str(path)!r} is not a name in UTF-8", value=path, advice="rename the file or folder"
        ) from None
    return path


@contextmanager
def _explained(path: Path) -> Iterator[None]:
    """Turn an operating system's refusal into one line that names ``path``."""
    try:
        yield
    except TilewrightFileError:
        raise
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise TilewrightFileError(f"{path} could not be written: {reason}", value=path) from None
    except ValueError as error:
        if "null byte" not in str(error):
            raise
        raise TilewrightFileError(f"{str(path)!r} could not be written: {error}", value=path) from None


def _real(path: Path) -> Path:
    """Where ``path`` leads, links followed; its parent must be there."""
    real = Path(os.path.realpath(path))
    if not real.parent.is_dir():
        raise TilewrightFileError(
            f"{path} could not be written: the folder {real.parent} does not exist", value=path
        )
    return real


@contextmanager
def whole_file(path: AnyPath) -> Iterator[Path]:
    """Yield a name to write to; it becomes ``path`` when the block ends well, and is gone otherwise."""
    path = as_path(path)
    with _explained(path):
        real = check_file(path)
        handle, name = tempfile.mkstemp(prefix=".unfinished-", suffix=path.suffix, dir=real.parent)
        os.close(handle)
        unfinished = Path(name)
        try:
            yield unfinished
            os.chmod(unfinished, 0o666 & ~_umask())
            os.replace(unfinished, real)
        except TilewrightFileError as error:
            raise TilewrightFileError(str(error).replace(str(unfinished), str(path)), value=path) from None
        finally:
            unfinished.unlink(missing_ok=True)


def check_file(path: Path) -> Path:
    """Where a file may be written that leads to ``path``, links followed; an error where it may not."""
    real = _real(path)
    if real.is_dir():
        raise TilewrightFileError(f"{path} is a folder; a file name is expected", value=path)
    if real.exists() and not real.is_file():
        raise TilewrightFileError(f"{path} is not a plain file", value=path, advice="choose another name")
    _check_outside(path, real)
    return real


def _check_outside(path: Path, real: Path) -> None:
    for folder in real.parents[:2]:
        if (folder / MANIFEST).exists():
            raise TilewrightFileError(
                f"{path} lies in the tile-set folder {folder}", value=path, advice="choose a place outside it"
            )


@contextmanager
def whole_folder(path: AnyPath, objection: Callable[[Path], str]) -> Iterator[Path]:
    """Yield a new folder to fill; it becomes ``path`` when the block ends well, and is gone otherwise.

    A folder that is there already and is not empty is replaced, unless there is an ``objection``.
    """
    path = as_path(path)
    with _explained(path):
        real = check_folder(path, objection)
        unfinished = Path(tempfile.mkdtemp(prefix=".unfinished-", dir=real.parent))
        try:
            yield unfinished
            os.chmod(unfinished, 0o777 & ~_umask())
            _put(unfinished, real)
        except TilewrightFileError as error:
            raise TilewrightFileError(str(error).replace(str(unfinished), str(path)), value=path) from None
        finally:
            shutil.rmtree(unfinished, ignore_errors=True)


def check_folder(path: Path, objection: Callable[[Path], str]) -> Path:
    """Where a folder may be written that leads to ``path``, links followed; an error where it may not."""
    with _explained(path):
        real = _real(path)
        if real.exists() and not real.is_dir():
            raise TilewrightFileError(f"{path} is a file; a folder is expected", value=path)
        _check_outside(path, real)
        if real.is_dir() and any(real.iterdir()) and (reason := objection(real)):
            raise TilewrightFileError(f"{path} {reason}", value=path, advice="choose a new folder")
        if not os.access(real.parent, os.W_OK):
            raise TilewrightFileError(
                f"{path} could not be written: no permission in {real.parent}", value=path
            )
    return real


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
        if old.exists():
            warnings.warn(
                f"parts of the old set could not be removed; they are in {old}",
                TilewrightWarning,
                stacklevel=4,
            )


def _umask() -> int:
    current = os.umask(0)
    os.umask(current)
    return current
