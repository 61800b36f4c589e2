"""Files and folders that stand whole or not at all: written under another name, then renamed."""

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from tilewright.checks import check_type
from tilewright.errors import TilewrightFileError, TilewrightValueError
from tilewright.files.exchange import put_folder
from tilewright.files.leftovers import (
    name_for_replaced,
    remove,
    sweep,
    unfinished_file,
    unfinished_folder,
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
        if "embedded null" not in str(error):  # called a byte or a character
            raise
        raise TilewrightFileError(f"{str(path)!r} could not be written: {error}", value=path) from None


def _real(path: Path) -> Path:
    """Where ``path`` leads, links followed; the nearest folder above that is there can be written in."""
    real = Path(os.path.realpath(path))
    above = next(folder for folder in real.parents if os.path.lexists(folder))
    if not above.is_dir():
        raise TilewrightFileError(f"{path} could not be written: {above} is not a folder", value=path)
    if not os.access(above, os.W_OK | os.X_OK):
        raise TilewrightFileError(f"{path} could not be written: no permission in {above}", value=path)
    try:
        str(real).encode()
    except UnicodeEncodeError:
        raise TilewrightFileError(
            f"{path} could not be written: it lies in {str(real.parent)!r}, which is not a name in UTF-8",
            value=path,
            advice="rename that folder",
        ) from None
    return real


@contextmanager
def _parents(folder: Path) -> Iterator[None]:
    """The folder with all those above it; what was made is gone again where the block fails."""
    missing = [above for above in (folder, *folder.parents) if not above.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        yield
    except BaseException:
        for above in missing:
            with suppress(OSError):
                above.rmdir()
        raise


@contextmanager
def whole_file(path: AnyPath) -> Iterator[Path]:
    """Yield a name to write to; it becomes ``path`` when the block ends well, and is gone otherwise.

    Folders above that are missing are made.
    """
    path = as_path(path)
    with _explained(path):
        real = check_file(path)
        with _parents(real.parent):
            sweep(real.parent)
            unfinished = unfinished_file(real.parent, path.suffix)
            try:
                yield unfinished
                os.chmod(unfinished, 0o666 & ~_umask())
                os.replace(unfinished, real)
            except TilewrightFileError as error:
                raise _renamed(error, unfinished, path) from None
            finally:
                unfinished.unlink(missing_ok=True)


def check_file(path: Path) -> Path:
    """Where a file may be written that leads to ``path``, links followed; an error where it may not."""
    real = _real(path)
    if real.is_dir():
        raise TilewrightFileError(f"{path} is a folder; a file name is expected", value=path)
    if real.exists() and not real.is_file():
        raise TilewrightFileError(f"{path} is not a plain file", value=path, advice="choose another name")
    check_outside(path, real)
    return real


def check_outside(path: Path, real: Path) -> None:
    """Raise where something is to be written within a tile-set folder."""
    for folder in real.parents:
        if (folder / MANIFEST).exists():
            raise TilewrightFileError(
                f"{path} lies in the tile-set folder {folder}", value=path, advice="choose a place outside it"
            )


@contextmanager
def whole_folder(path: AnyPath, objection: Callable[[Path], str]) -> Iterator[Path]:
    """Yield a new folder to fill; it becomes ``path`` when the block ends well, and is gone otherwise.

    A folder that is there already and is not empty is replaced, unless there is an ``objection``; there is
    no moment in which neither has the name, where the system can exchange names. Folders above that are
    missing are made.
    """
    path = as_path(path)
    with _explained(path):
        real = check_folder(path, objection)
        with _parents(real.parent):
            sweep(real.parent)
            unfinished = unfinished_folder(real.parent)
            replaced = name_for_replaced(unfinished)
            try:
                yield unfinished
                os.chmod(unfinished, 0o777 & ~_umask())
                check_folder(path, objection)  # others may have put something there meanwhile
                put_folder(unfinished, real, replaced)
            except TilewrightFileError as error:
                raise _renamed(error, unfinished, path) from None
            finally:
                remove(unfinished)
                remove(replaced)


def _renamed(error: TilewrightFileError, unfinished: Path, path: Path) -> TilewrightFileError:
    """An error that names what the user named."""
    return TilewrightFileError(str(error).replace(str(unfinished), str(path)), value=path)


def check_folder(path: Path, objection: Callable[[Path], str]) -> Path:
    """Where a folder may be written that leads to ``path``, links followed; an error where it may not."""
    with _explained(path):
        real = _real(path)
        if real.exists() and not real.is_dir():
            raise TilewrightFileError(f"{path} is a file; a folder is expected", value=path)
        check_outside(path, real)
        if real.is_dir() and any(real.iterdir()) and (reason := objection(real)):
            raise TilewrightFileError(f"{path} {reason}", value=path, advice="choose a new folder")
    return real


def _umask() -> int:
    current = os.umask(0)
    os.umask(current)
    return current
