"""Numbers from files that other programs wrote: NPY, NPZ, CSV; one clear line for anything else."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightFileError
from tilewright.files.archives import read_archive
from tilewright.files.atomic import AnyPath, as_path

Read = TypeVar("Read")


def read_table(path: AnyPath, what: str) -> NDArray[Any]:
    """The array of a .npy file, or the whole numbers of a .csv file, shape (rows, columns).

    ``what`` says what is expected, for the error: "a row of colors for every tile".
    """
    target = as_path(path)
    if target.suffix.lower() == ".npy":
        return _read(target, what, lambda: np.asarray(np.load(target, allow_pickle=False)))
    # Spreadsheets begin a file with a byte-order mark.
    return _read(
        target,
        what,
        lambda: np.loadtxt(target, dtype=np.int64, delimiter=",", ndmin=2, encoding="utf-8-sig"),
    )


def read_arrays(path: AnyPath, names: Sequence[str], what: str) -> dict[str, NDArray[Any]]:
    """The arrays of the given names in a .npz file."""
    target = as_path(path)
    return _read(target, what, lambda: read_archive(target, lambda there: names))


def _read(path: Path, what: str, read: Callable[[], Read]) -> Read:
    if path.is_dir():
        raise TilewrightFileError(f"{path} is a folder; expected {what}", value=path)
    if not path.exists():
        raise TilewrightFileError(f"{path} does not exist", value=path)
    if not path.stat().st_size:
        raise TilewrightFileError(f"{path} is empty; expected {what}", value=path)
    try:
        return read()
    except (OSError, ValueError, KeyError, TypeError, AttributeError, EOFError, MemoryError):
        raise TilewrightFileError(f"{path} does not hold {what}", value=path) from None
