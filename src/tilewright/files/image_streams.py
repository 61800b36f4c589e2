"""Pictures larger than memory, written block by block: tiled BigTIFF, PNG and EXR; JPEG and WebP too."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.files.atomic import AnyPath, as_path, whole_file
from tilewright.files.decoding.alpha import to_associated
from tilewright.files.decoding.png_chunks import read_chunks
from tilewright.files.images import (
    check_sides,
    image_spec,
    is_associated,
    unwritten_error,
)
from tilewright.files.picture_forms import Convert, picture_form
from tilewright.pixels import has_alpha

TILE = 256
"""Side of a TIFF tile, and the most rows rendered at a time."""
_BLOCK_BYTES = 16 << 20

Render = Callable[[int, int, int, int], NDArray[Any]]
"""``render(left, top, width, height)``: a block of the picture, shape (height, width, channels)."""


def stream_image(
    path: AnyPath,
    render: Render,
    height: int,
    width: int,
    channels: int,
    kind: np.dtype[Any],
    map_kind: str = "color",
) -> None:
    """Write a picture that is made a block at a time.

    ``map_kind`` says what the numbers mean, see `picture_form`.

    TIFF files are tiled (256 x 256, not compressed) and BigTIFF; PNG and EXR files are written by
    scanlines. One block of about 16 MB is in memory, however wide and high the picture. The file appears
    when it is complete. Colors are multiplied by alpha in EXR. JPEG and WebP are for looking at.
    """
    path = as_path(path)
    kind, channels, convert = picture_form(path, kind, channels, map_kind)
    check_sides(path, width, height)
    render = _converted(render, convert)
    if is_associated(path, channels, map_kind == "color"):
        render = _converted(render, to_associated)
    with whole_file(path) as unfinished:
        if path.suffix.lower() in (".tif", ".tiff"):
            _write_tiff(unfinished, render, height, width, channels, kind)
        else:
            _write_scanlines(path, unfinished, render, height, width, channels, kind)


def _converted(render: Render, convert: Convert) -> Render:
    return lambda left, top, width, height: convert(render(left, top, width, height))


def _write_tiff(
    path: Path, render: Render, height: int, width: int, channels: int, kind: np.dtype[Any]
) -> None:
    import tifffile

    tiles_at_once = max(1, _BLOCK_BYTES // (TILE * TILE * channels * kind.itemsize))

    def tiles() -> Iterator[NDArray[Any]]:
        for top in range(0, height, TILE):
            for left in range(0, width, tiles_at_once * TILE):
                rows, columns = min(TILE, height - top), min(tiles_at_once * TILE, width - left)
                whole = np.zeros((TILE, -(-columns // TILE) * TILE, channels), kind)
                whole[:rows, :columns] = render(left, top, columns, rows)
                for first in range(0, columns, TILE):
                    tile = whole[:, first : first + TILE]
                    yield np.ascontiguousarray(tile if channels > 1 else tile[..., 0])

    tifffile.imwrite(
        path,
        tiles(),
        shape=(height, width, channels) if channels > 1 else (height, width),
        dtype=kind,
        tile=(TILE, TILE),
        bigtiff=True,
        photometric="rgb" if channels > 2 else "minisblack",
        planarconfig="contig" if channels > 1 else None,
        extrasamples=("unassalpha",) if has_alpha(channels) else None,
        metadata=None,
    )


def _write_scanlines(
    path: Path,
    unfinished: Path,
    render: Render,
    height: int,
    width: int,
    channels: int,
    kind: np.dtype[Any],
) -> None:
    import OpenImageIO as oiio

    spec = image_spec(path, width, height, channels, kind)
    output = oiio.ImageOutput.create(str(unfinished))
    if output is None:
        raise unwritten_error(path)
    written = output.open(str(unfinished), spec)
    try:
        rows = min(TILE, max(1, _BLOCK_BYTES // (width * channels * kind.itemsize)))
        for top in range(0, height, rows):
            if not written:
                break
            band = np.ascontiguousarray(render(0, top, width, min(rows, height - top)))
            written = output.write_scanlines(top, top + len(band), 0, band)
    finally:
        closed = output.close()
    if not (written and closed and _is_whole(unfinished, height)):
        raise unwritten_error(path)


def _is_whole(path: Path, height: int) -> bool:
    """Whether a file just written is all there; the library does not always say that a disk was full."""
    if path.suffix.lower() == ".png":
        return path.stat().st_size > 0 and not read_chunks(path).fault
    import OpenImageIO as oiio

    source = oiio.ImageInput.open(str(path))
    if source is None:
        return False
    try:
        return source.read_scanlines(height - 1, height, 0, 0, source.spec().nchannels) is not None
    finally:
        source.close()
