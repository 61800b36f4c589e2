"""The maps of a scanned material: which file of a folder is which."""

import re
import warnings
from collections.abc import Mapping
from pathlib import Path

from tilewright.errors import TilewrightFileError, TilewrightWarning
from tilewright.files.atomic import AnyPath, as_path
from tilewright.files.map_names import MapName, material_of, name_maps, recognize_map
from tilewright.pixels import MAP_WORDS

_READ = (
    *(".png", ".jpg", ".jpeg", ".jfif", ".tif", ".tiff", ".exr", ".tga", ".bmp", ".hdr", ".webp"),
    *(".jp2", ".j2k", ".dds", ".avif", ".gif"),
)
_OTHERS = (
    *(".ktx", ".ktx2", ".psd", ".xcf", ".kra", ".heic", ".heif", ".jxl", ".svg"),
    *(".pgm", ".ppm", ".pfm", ".dng", ".pcx", ".sgi", ".pic"),
)
"""Suffixes of pictures that are not taken into a material, but named where their names are those of maps."""
_VIEWS = ("preview", "thumb", "thumbnail", "render", "sphere", "plane", "cube", "icon", "sample")
"""Words of pictures of a material that are none of its maps."""


def find_maps(folder: AnyPath) -> dict[str, Path]:
    """Find the maps of a material in a folder, albedo first, by the ends of their file names.

    Files of other names, and of formats that are not read here such as KTX, are left out, which is said in a
    warning. Where a material brings its normals both ways, OpenGL's are taken. Endings of one letter or two,
    as Unreal's ``_D`` and ``_N``, count where other files of the same words show what they mean. A map that
    holds several (``orm``, ``arm``, ``rma``, ``maskmap``) is one file here; `open_exemplar` takes it apart.

    Parameters
    ----------
    folder : str or path-like
        A folder with image files, such as ``Bricks_Color.png`` and ``Bricks_NormalGL.png``. Of several
        materials in a folder one is named by how its files begin, as ``folder/Bricks``.

    Returns
    -------
    dict of str to Path
        The file of each map, by the map's name.

    Raises
    ------
    TilewrightTypeError
        Something else than a path.
    TilewrightFileError
        No map was found, two files claim to be the same one, or the folder holds several materials, or more
        pictures that belong to none than maps.

    Warns
    -----
    TilewrightWarning
        A file's name does not say which map it is.
    """
    folder = as_path(folder)
    files = _pictures(folder) if folder.is_dir() else _named_material(folder) or _pictures(folder)
    told = dict(zip(files, name_maps([file.stem for file in files]), strict=True))
    read = {file: name for file, name in told.items() if file.suffix.lower() in _READ}
    claimed = {file: name for file, name in read.items() if name.map is not None}
    strangers = {file: name for file, name in read.items() if name.map is None}
    unread = [file for file, name in told.items() if file not in read and name.map is not None]
    if not claimed:
        raise _no_maps(folder, unread)
    _check_one_material(folder, claimed)
    _check_belonging(folder, claimed, strangers)
    found = _by_map(folder, claimed)
    _tell_left_out(list(strangers), "their names do not say which maps they are; name each with its file")
    _tell_left_out(unread, "such files are not read here; save them as PNG, TIFF or EXR")
    return found


def holds_maps(path: AnyPath) -> bool:
    """Whether a path is a folder, or how the files of one of several materials in a folder begin."""
    path = as_path(path)
    return path.is_dir() or bool(_named_material(path))


def check_color(folder: AnyPath, maps: Mapping[str, object]) -> None:
    """Raise unless a material that was found in a folder has a map of color.

    Parameters
    ----------
    folder : str or path-like
        Where its maps were found, for the message.
    maps : dict of str to anything
        The file of each map.

    Raises
    ------
    TilewrightFileError
        There is no albedo.
    """
    if "albedo" in maps:
        return
    files = {name: Path(str(file)).name for name, file in maps.items()}
    name, file = next(iter(files.items()))
    raise TilewrightFileError(
        f"{as_path(folder)} has no map of color by its file names: "
        + _listed([f"{file} is {name}" for name, file in files.items()]),
        value=folder,
        advice=f"give one by name too, as map albedo=FILE, or only what you want tiles of, as {name}={file}",
    )


def tell_green(file: Path) -> str | None:
    """What a file name says of its normals: ``"normal-gl"``, ``"normal-dx"``, or None."""
    if recognize_map(file.stem) == "normal-dx":
        return "normal-dx"
    told = re.search(r"(normal|nor|nrm)[^a-z]?(gl|ogl|opengl)([^a-z]|$)", file.stem, re.IGNORECASE)
    return "normal-gl" if told else None


def _pictures(folder: Path) -> list[Path]:
    """Pictures of a folder by name; not those hidden, as what macOS puts beside files on other disks."""
    try:
        return sorted(
            p
            for p in folder.iterdir()
            if p.suffix.lower() in (*_READ, *_OTHERS) and not p.name.startswith(".")
        )
    except OSError as error:
        raise TilewrightFileError(
            f"{folder} cannot be read: {(error.strerror or '').lower()}", value=folder
        ) from None


def _named_material(path: Path) -> list[Path]:
    """Files of the material that a path names in its folder; none where it names a file, or nothing."""
    material = material_of(path.name)
    is_file = path.exists() or path.suffix.lower() in (*_READ, *_OTHERS)
    if is_file or not material or not path.parent.is_dir():
        return []
    files = _pictures(path.parent)
    names = name_maps([file.stem for file in files])
    return [f for f, name in zip(files, names, strict=True) if name.map and name.material == material]


def _no_maps(folder: Path, unread: list[Path]) -> TilewrightFileError:
    others = f"; {_listed([file.name for file in unread])} are not read here" if unread else ""
    return TilewrightFileError(
        f"{folder} has no maps that can be told by name; their files end in _Color, _NormalGL, "
        f"_Roughness, _diff_2k or the like{others}",
        value=folder,
        advice="name each map with its file",
    )


def _check_one_material(folder: Path, claimed: Mapping[Path, MapName]) -> None:
    """Raise where maps are those of several materials."""
    materials: dict[str, list[str]] = {}
    for file, name in claimed.items():
        materials.setdefault(name.material, []).append(file.name)
    if len(materials) == 1 or (len(materials) == 2 and "" in materials and not _twice(claimed)):
        return
    shown = [f"{name or 'one without a name'} ({files[0]})" for name, files in materials.items()]
    twice = _twice(claimed)
    raise TilewrightFileError(
        f"{folder} has maps of {len(materials)} materials, {_listed(shown)}"
        + (f"; {_said_twice(*twice)}" if twice else ""),
        value=folder,
        advice="name one by how its files begin, as FOLDER/NAME, or each map with its file",
    )


def _twice(claimed: Mapping[Path, MapName]) -> tuple[str, Path, Path] | None:
    """A map that two files claim to be, and these."""
    found: dict[str, Path] = {}
    for file, name in claimed.items():
        map = str(name.map)
        if map in found:
            return map, found[map], file
        found[map] = file
    return None


def _said_twice(map: str, first: Path, second: Path) -> str:
    return f"two files for {map}, {first.name} and {second.name}"


def _check_belonging(
    folder: Path, claimed: Mapping[Path, MapName], strangers: Mapping[Path, MapName]
) -> None:
    """Raise where a few maps lie among other photographs: whoever gave the folder meant something else."""
    material = next(iter(claimed.values())).material
    foreign = [
        file
        for file, name in strangers.items()
        if not (material and name.material.startswith(material))
        and not any(word in name.material.split() for word in _VIEWS)
    ]
    if len(foreign) > len(claimed):
        raise TilewrightFileError(
            f"{folder} has {len(claimed)} maps ({_listed([file.name for file in claimed])}) among "
            f"{len(foreign)} pictures that are none by their names ({_listed([f.name for f in foreign])})",
            value=folder,
            advice="give one photograph, each map with its file, or the material by how its files begin, as "
            "FOLDER/NAME",
        )


def _by_map(folder: Path, claimed: Mapping[Path, MapName]) -> dict[str, Path]:
    """The file of each map, in the order of a stack."""
    twice = _twice(claimed)
    if twice:
        raise TilewrightFileError(
            f"{folder} has {_said_twice(*twice)}",
            value=folder,
            advice="name each map you want with its file",
        )
    found = {str(name.map): file for file, name in claimed.items()}
    if "normal-dx" in found:
        directx = found.pop("normal-dx")
        found.setdefault("normal", directx)
    return {name: found[name] for name in MAP_WORDS if name in found}


def _tell_left_out(files: list[Path], reason: str) -> None:
    if files:
        shown = _listed([file.name for file in files])
        warnings.warn(f"left out {shown}: {reason}", TilewrightWarning, stacklevel=3)


def _listed(names: list[str]) -> str:
    """The first names, and how many more there are."""
    return ", ".join(names[:4]) + (f" and {len(names) - 4} more" if len(names) > 4 else "")
