"""The maps of a scanned material: which file of a folder is which."""

import re
import warnings
from pathlib import Path

from tilewright.errors import TilewrightFileError, TilewrightWarning
from tilewright.files.atomic import AnyPath, as_path
from tilewright.pixels import MAP_WORDS

_SUFFIXES = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".tga", ".bmp", ".hdr", ".webp")
_SIZE = re.compile(r"\d+k|\d{3,5}(x\d{3,5})?|png|jpg|exr|tif|lod\d|\d+bit")


def find_maps(folder: AnyPath) -> dict[str, Path]:
    """Find the maps of a material in a folder, albedo first, by the ends of their file names.

    Files of other names are left out, which is said in a warning. Where a material brings its normals both
    ways, OpenGL's are taken.

    Parameters
    ----------
    folder : str or path-like
        A folder with image files, such as ``Bricks_Color.png`` and ``Bricks_NormalGL.png``.

    Returns
    -------
    dict of str to Path
        The file of each map, by the map's name.

    Raises
    ------
    TilewrightTypeError
        Something else than a path.
    TilewrightFileError
        No map was found, or two files claim to be the same one.

    Warns
    -----
    TilewrightWarning
        A file's name does not say which map it is.
    """
    folder = as_path(folder)
    try:
        files = sorted(p for p in folder.iterdir() if p.suffix.lower() in _SUFFIXES)
    except OSError as error:
        raise TilewrightFileError(
            f"{folder} cannot be read: {(error.strerror or '').lower()}", value=folder
        ) from None
    found: dict[str, Path] = {}
    left_out = []
    for file in files:
        name = recognize_map(file.stem)
        if name is None:
            left_out.append(file.name)
            continue
        if name in found:
            raise TilewrightFileError(
                f"{folder} has two files for {name}, {found[name].name} and {file.name}",
                value=folder,
                advice="name each map you want with its file",
            )
        found[name] = file
    if "normal-dx" in found:
        directx = found.pop("normal-dx")
        found.setdefault("normal", directx)
    if not found:
        raise TilewrightFileError(
            f"{folder} has no maps that can be told by name; their files end in _Color, _NormalGL, "
            "_Roughness, _diff_2k or the like",
            value=folder,
            advice="name each map with its file",
        )
    if left_out:
        shown = ", ".join(left_out[:4]) + (f" and {len(left_out) - 4} more" if len(left_out) > 4 else "")
        warnings.warn(
            f"left out {shown}: their names do not say which maps they are; name each with its file",
            TilewrightWarning,
            stacklevel=2,
        )
    return {name: found[name] for name in MAP_WORDS if name in found}


def tell_green(file: Path) -> str | None:
    """What a file name says of its normals: ``"normal-gl"``, ``"normal-dx"``, or None."""
    if recognize_map(file.stem) == "normal-dx":
        return "normal-dx"
    told = re.search(r"(normal|nor|nrm)[^a-z]?(gl|ogl|opengl)([^a-z]|$)", file.stem, re.IGNORECASE)
    return "normal-gl" if told else None


def recognize_map(stem: str) -> str | None:
    """Which map a file of this name is, None where it does not say: ``Moss002_2K-PNG_NormalGL``."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", stem)
    words = [w for w in re.split(r"[^a-z0-9]+", spaced.lower()) if w]
    while words and _SIZE.fullmatch(words[-1]):
        words.pop()
    for length in (3, 2, 1):
        ending = words[-length:]
        for name, known in MAP_WORDS.items():
            if len(ending) == length and {"_".join(ending), "".join(ending)} & set(known.endings):
                return name
    return None
