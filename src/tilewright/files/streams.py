"""Pictures larger than memory, written band by band: tiled BigTIFF, PNG and EXR."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightFileError, TilewrightValueError
from tilewright.files.images import check_writable
from tilewright.files.whole import whole_file

BAND = 256
"""Rows rendered at a time, and the side of a TIFF tile."""
_LARGEST_PNG = 2**31 - 1

Render = Callable[[int, int], NDArray[Any]]
"""``render(first_row, count)``: rows of the picture, shape (count, width, channels)."""


def stream_image(
    path: str | Path, render: Render, height: int, width: int, channels: int, kind: np.dtype[Any]
) -> None:
    """Write a picture that is made a band of rows at a time.

    TIFF files are tiled (256 x 256, not compressed) and BigTIFF; PNG and EXR files are written by
    scanlines. At most a few bands are in memory. The file appears when it is complete.
    """
    path = Path(path)
    name = check_writable(path, kind)
    if max(height, width) > _LARGEST_PNG:
        raise TilewrightValueError(f"the picture is {width} x {height} pixels; at most 2^31 - 1 on a side")
    with whole_file(path) as unfinished:
        if path.suffix.lower() in (".tif", ".tiff"):
            _write_tiff(unfinished, render, height, width, channels, kind)
        else:
            _write_scanlines(path, unfinished, render, height, width, channels, name)


def _write_tiff(
    path: Path, render: Render, height: int, width: int, channels: int, kind: np.dtype[Any]
) -> None:
    import tifffile

    def tiles() -> Iterator[NDArray[Any]]:
        for top in range(0, height, BAND):
            band = render(top, min(BAND, height - top))
            for left in range(0, width, BAND):
                part = band[:, left : left + BAND]
                if part.shape[:2] != (BAND, BAND):
                    whole = np.zeros((BAND, BAND, channels), kind)
                    whole[: part.shape[0], : part.shape[1]] = part
                    part = whole
                yield np.ascontiguousarray(part if channels > 1 else part[..., 0])

    tifffile.imwrite(
        path,
        tiles(),
        shape=(height, width, channels) if channels > 1 else (height, width),
        dtype=kind,
        tile=(BAND, BAND),
        bigtiff=True,
        photometric="rgb" if channels > 2 else "minisblack",
        planarconfig="contig" if channels > 1 else None,
        extrasamples=("unassalpha",) if channels in (2, 4) else None,
        metadata=None,
    )


def _write_scanlines(
    path: Path, unfinished: Path, render: Render, height: int, width: int, channels: int, kind: str
) -> None:
    import OpenImageIO as oiio

    spec = oiio.ImageSpec(width, height, channels, kind)
    spec.attribute("oiio:UnassociatedAlpha", 1)
    spec.attribute("png:compressionLevel", 4)
    if path.suffix.lower() == ".exr":
        spec.attribute("compression", "zip")
    output = oiio.ImageOutput.create(str(unfinished))
    if output is None:
        raise TilewrightFileError(f"{path} could not be written ({' '.join(oiio.geterror().split())})")
    written = output.open(str(unfinished), spec)
    try:
        for top in range(0, height, BAND):
            if not written:
                break
            band = np.ascontiguousarray(render(top, min(BAND, height - top)))
            written = output.write_scanlines(top, top + len(band), 0, band)
        reason = " ".join(output.geterror().split())
    finally:
        closed = output.close()
    if not (written and closed and _ends_well(unfinished, height)):
        raise TilewrightFileError(f"{path} could not be written ({reason or 'is the disk full?'})")


def _ends_well(path: Path, height: int) -> bool:
    """Whether a file just written has its end; the library does not always say that a disk was full."""
    if path.suffix.lower() == ".png":
        with path.open("rb") as file:
            file.seek(-min(12, path.stat().st_size), 2)
            return file.read()[4:8] == b"IEND"
    import OpenImageIO as oiio

    source = oiio.ImageInput.open(str(path))
    if source is None:
        return False
    try:
        return source.read_scanlines(height - 1, height, 0, 0, source.spec().nchannels) is not None
    finally:
        source.close()
