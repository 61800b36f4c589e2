"""Shaders put together from the files beside this one."""

from importlib.resources import files

from tilewright.gpu.hashing import ShaderHash

VERTEX = "triangle.vert"


def read_part(name: str) -> str:
    """Text of a shader file."""
    return (files(__package__) / name).read_text(encoding="utf-8")


def assemble(hash: ShaderHash | None, layout: tuple[str, ...], main: str, defines: dict[str, str]) -> str:
    """The fragment shader of a layout's files, with ``main`` as its last file, compiled for some names."""
    defines = defines | (hash.defines | {"PLACES": f"{len(hash.table())}u"} if hash else {})
    lines = ["#version 450", *(f"#define {name} {value}".rstrip() for name, value in defines.items())]
    hash_parts = ("table.glsl", hash.part) if hash else ()
    return "\n".join([*lines, *(read_part(name) for name in ("view.glsl", *hash_parts, *layout, main))])
