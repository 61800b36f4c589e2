"""Arrays of NPZ files, which are ZIP archives that anybody may have written or damaged."""

import zipfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightError, TilewrightFileError, brief_text

_LARGE = 2**30
"""Bytes that may be unpacked whatever they were packed into."""
_DENSEST = 200
"""Beyond that, how many times as large as packed: numbers that say something pack 2 to 20 times."""

Choose = Callable[[list[str]], Sequence[str]]
"""From the names of an archive's arrays to those that are wanted."""


def read_archive(path: Path, choose: Choose) -> dict[str, NDArray[Any]]:
    """Those arrays of an archive that are wanted; one clear line for anything that goes wrong."""
    try:
        with zipfile.ZipFile(path) as archive:
            names = [name.removesuffix(".npy") for name in archive.namelist()]
            wanted = list(choose(names))
            if missing := [name for name in wanted if name not in names]:
                there, lacking = list_briefly(names), list_briefly(missing)
                raise TilewrightFileError(
                    f"{path} does not hold the arrays {lacking}; it holds {there}", value=path
                )
            _check_sizes(path, [info for info in archive.infolist() if _plain(info) in wanted])
        with np.load(path, allow_pickle=False) as stored:
            return {name: np.asarray(stored[name]) for name in wanted}
    except TilewrightError:
        raise
    except Exception as error:  # of zipfile, of four packers and of numpy, which say it in a dozen kinds
        reason = brief_text(str(error)) or type(error).__name__
        raise TilewrightFileError(
            f"{path} is damaged or not what its name says: {reason}", value=path
        ) from None


def list_briefly(names: Sequence[str]) -> str:
    """Names for a message, however many there are."""
    return brief_text(", ".join(names[:20])) or "nothing"


def _plain(info: zipfile.ZipInfo) -> str:
    return info.filename.removesuffix(".npy")


def _check_sizes(path: Path, members: list[zipfile.ZipInfo]) -> None:
    """Refuse what would fill the memory with next to nothing; zipfile unpacks no more than it says."""
    unpacked, packed = sum(m.file_size for m in members), sum(m.compress_size for m in members)
    if unpacked > max(_LARGE, _DENSEST * packed):
        raise TilewrightFileError(
            f"{path} unpacks from {packed / 1e6:.3g} MB to {unpacked / 1e9:.3g} GB; it is damaged or made to "
            "fill the memory",
            value=path,
        )
