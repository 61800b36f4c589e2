"""Pictures to print, put into a drawing whole."""

import base64
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

from tilewright.errors import TilewrightFileError
from tilewright.export.drawing.svg import element
from tilewright.files.atomic import AnyPath, as_path
from tilewright.files.images import read_image, write_image

_SIGNATURES = {b"\x89PNG\r\n\x1a\n": "png", b"\xff\xd8\xff": "jpeg"}
_ORIENTATION = 0x0112
"""Tag of Exif 2.32, table 4: which sides row 0 and column 0 show."""


def print_of(path: AnyPath | None, width: float, height: float) -> Iterator[str]:
    """The image element of a PNG or JPEG file that fills a sheet; nothing where there is no file.

    It holds the file's bytes, or those of an upright PNG where the file says that it is turned: not every
    program that reads SVG looks into an image for that.
    """
    if path is None:
        return
    given = as_path(path)
    try:
        content = given.read_bytes()
    except OSError as error:
        raise TilewrightFileError(
            f"{given} cannot be read: {(error.strerror or '').lower()}", value=given
        ) from None
    kind = next((k for start, k in _SIGNATURES.items() if content.startswith(start)), None)
    if kind is None:
        raise TilewrightFileError(f"{given} is no PNG or JPEG file; expected one of these", value=given)
    read_image(given, color=False)  # refuses one that is damaged
    if _is_turned(given):
        with TemporaryDirectory() as folder:
            upright = Path(folder) / "upright.png"
            write_image(upright, read_image(given))
            kind, content = "png", upright.read_bytes()
    yield element(
        "image",
        href=f"data:image/{kind};base64,{base64.b64encode(content).decode()}",
        width=width,
        height=height,
        preserveAspectRatio="xMidYMid slice",
    )


def _is_turned(path: Path) -> bool:
    from PIL import Image

    with Image.open(path) as image:
        return image.getexif().get(_ORIENTATION, 1) != 1
