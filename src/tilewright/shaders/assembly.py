"""Shaders put together from the files beside this one."""

from tilewright.shaders.hashing import ShaderHash
from tilewright.shaders.templates import read_text

VERTEX = "triangle.vert"


def read_part(name: str) -> str:
    """Text of a shader file."""
    return read_text(__package__, f"field/{name}")


def assemble(hash: ShaderHash | None, layout: tuple[str, ...], main: str, defines: dict[str, str]) -> str:
    """The fragment shader of a layout's files, with the text ``main`` after them, compiled for some names."""
    defines = defines | (hash.defines | {"PLACES": f"{len(hash.table())}u"} if hash else {})
    lines = ["#version 450", *(f"#define {name} {value}".rstrip() for name, value in defines.items())]
    hash_parts = ("table.glsl", hash.part) if hash else ()
    return "\n".join([*lines, *(read_part(name) for name in ("view.glsl", *hash_parts, *layout)), main])
