"""The targets of `save_for_engine`."""

from collections.abc import Callable
from importlib import import_module
from pathlib import Path

from tilewright.checks import check_choice, check_type
from tilewright.export.engines.folder import find_objection
from tilewright.export.engines.kit import Kit, prepare
from tilewright.files.atomic import AnyPath, whole_folder
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


def save_for_engine(material: TextureTiles, folder: AnyPath, to: str, *, seed: int = 0) -> None:
    """Write a folder that shows an endless texture in an engine or another program.

    It holds the textures with their mip levels in the form that the target takes, the shader in its
    dialect, a material or an example scene, ``tilewright.json`` with all numbers, and a README of ten lines.

    Parameters
    ----------
    material : TextureTiles
        Texture tiles over a complete corner set of 1 to 8 colors, or one in classes, with as many variants of
        every tile, drawn alike, up to 256. Tone outside the tiles goes along as a small picture, which the
        shader lays.
    folder : str or path-like
        Made whole or not at all. A folder of an earlier export is replaced, another one that is not empty
        refused.
    to : str
        ``"threejs"``, ``"godot"``, ``"unity"``, ``"unreal"`` or ``"blender"``; ``"glsl"`` (with a WebGL 2
        page), ``"hlsl"``, ``"wgsl"`` or ``"osl"``: an include file and how to use it; ``"ktx2"``: texture
        arrays; ``"atlas"``: pictures.
    seed : int, optional
        Seed of the tiling, 0 to 2^64 - 1, built into the shader; default 0. Cells within 32 bits have the
        tiles of ``direct(material.tiles, seed)``, and the variants that it draws.

    Raises
    ------
    TilewrightTypeError
        Something else than texture tiles, a path or an integer.
    TilewrightValueError
        No such target, or the tiles are neither a complete corner set nor one in classes, or have other
        variants.
    TilewrightFileError
        The folder holds other things, or cannot be written.

    Examples
    --------
    >>> import os
    >>> import tempfile
    >>> import numpy as np
    >>> import tilewright as tw
    >>> photo = np.random.default_rng(1).integers(0, 256, (64, 64, 3), np.uint8)
    >>> material = tw.texture_tiles(photo, tw.corner_tiles(2), tile_size=16)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     tw.save_for_engine(material, f"{folder}/glsl", "glsl", seed=7)
    ...     print("README.md" in os.listdir(f"{folder}/glsl"))
    True
    """
    check_type("material", material, TextureTiles, "TextureTiles")
    check_choice("to", to, TARGETS)
    seed = check_seed(seed)
    kit = prepare(material, seed, atlas=to in _ATLAS, green="dx" if to in _GREEN_DOWN else "gl")
    write: Callable[[Path, Kit], None] = import_module(f"tilewright.export.engines.{to}").write
    with whole_folder(folder, find_objection) as unfinished:
        write(unfinished, kit)
