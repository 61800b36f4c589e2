"""The targets of `save_for_engine`."""

from collections.abc import Callable
from importlib import import_module
from pathlib import Path

from tilewright.checks import check_choice
from tilewright.errors import TilewrightTypeError
from tilewright.export.engines.folder import Kit, find_objection, prepare
from tilewright.files.atomic import whole_folder
from tilewright.seeds import check_seed
from tilewright.signals.textures import TextureTiles

_ATLAS, _GREEN_DOWN = ("atlas", "unreal", "blender", "osl"), ("unreal",)
TARGETS = (
    "threejs",
    "godot",
    "unity",
    "unreal",
    "blender",
    "glsl",
    "hlsl",
    "wgsl",
    "osl",
    "ktx2",
    "atlas",
)
"""What `save_for_engine` writes for."""


def save_for_engine(material: TextureTiles, folder: str | Path, to: str, *, seed: int = 0) -> None:
    """Write a folder that shows an endless texture in an engine or another program.

    It holds the textures with their mip levels in the form that the target takes, the shader in its
    dialect, a material or an example scene, ``tilewright.json`` with all numbers, and a README of ten lines.

    Parameters
    ----------
    material : TextureTiles
        Over a complete corner set of 1 to 8 colors, with as many variants of every tile, drawn alike, up to
        256.
    folder : str or Path
        Made whole or not at all. A folder of an earlier export is replaced, another one that is not empty
        refused.
    to : str
        One of `TARGETS`: ``threejs``, ``godot``, ``unity``, ``unreal``, ``blender``; ``glsl`` (with a WebGL 2
        page), ``hlsl``, ``wgsl``, ``osl``: an include file and how to use it; ``ktx2``: texture arrays;
        ``atlas``: pictures.
    seed : int
        Seed of the tiling, 0 to 2^64 - 1, built into the shader. Cells within 32 bits have the tiles of
        ``direct(material.tiles, seed)``, and the variants that it draws.

    Raises
    ------
    TilewrightValueError
        No such target, or the tiles are not a complete corner set or have other variants.
    TilewrightFileError
        The folder holds other things, or cannot be written.
    """
    if not isinstance(material, TextureTiles):
        raise TilewrightTypeError(f"material must be TextureTiles, not {type(material).__name__}")
    check_choice("to", to, TARGETS)
    check_seed(seed)
    kit = prepare(material, seed, atlas=to in _ATLAS, green="dx" if to in _GREEN_DOWN else "gl")
    write: Callable[[Path, Kit], None] = import_module(f"tilewright.export.engines.{to}").write
    with whole_folder(folder, find_objection) as unfinished:
        write(unfinished, kit)
