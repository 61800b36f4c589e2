"""What a sample costs on any GPU: counted in the SPIR-V that the shaders compile to.

The claim of Lagae & Dutré 2006, section 6.4 - half the memory of Wei's method, one texture unit less, fewer
instructions - is checked with this; ``docs/gpu.md`` has the table.
"""

import re
import subprocess
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from shutil import which

from tilewright.checks import check_choice, check_int
from tilewright.errors import GpuError
from tilewright.shaders.assembly import assemble
from tilewright.shaders.hashing import shader_hash
from tilewright.shaders.layouts import WEI_PARTS, array_defines, atlas_parts, corner_defines, wang_defines
from tilewright.shaders.mipmaps import layer_gutter
from tilewright.tiles import TileSet, classed_corner_tiles, corner_tiles, wang_tiles
from tilewright.tilings import MixerHash, PermutationHash

_MAIN = Path(__file__).with_name("cost.frag")
METHODS = ("plain", "array", "atlas", "wei", "classed", "tone")
_TOOLS = ("glslangValidator", "spirv-opt", "spirv-dis")
# What names a place or a value and is nothing that runs.
_SILENT = ("Label", "SelectionMerge", "Phi", "Branch", "Return", "Variable", "FunctionEnd")
# What moves numbers and calculates nothing.
_MOVES = (
    "Load",
    "Store",
    "AccessChain",
    "CompositeExtract",
    "CompositeConstruct",
    "CompositeInsert",
    "VectorShuffle",
    "CopyObject",
    "SampledImage",
    "Bitcast",
    "BranchConditional",
)


@dataclass(frozen=True)
class Cost:
    """What one sample costs.

    Attributes
    ----------
    method : str
        ``"plain"`` (a repeated picture), ``"array"`` or ``"atlas"`` (corner tiles), ``"wei"`` (Wang tiles),
        ``"classed"`` (an array of corner tiles in five classes), ``"tone"`` (the same under tone).
    hash : str
        ``"mixer"`` or ``"permutation"``; empty for a plain texture.
    texels : int
        Of level 0 of all textures; mip levels add a third to each.
    textures : int
        Texture units taken.
    fetches : int
        Texture fetches that are executed.
    table_reads : int
        Reads of the permutation table, on which the place of the fetch depends.
    dependent : int
        The longest chain of those reads in which each needs the one before.
    instructions : tuple of int
        On the shortest and on the longest way through the entry function; see `count_cost`.
    operations : tuple of int
        The same, calculations only, each counted for every number it makes: a vector of four counts four.
    """

    method: str
    hash: str
    texels: int
    textures: int
    fetches: int
    table_reads: int
    dependent: int
    instructions: tuple[int, int]
    operations: tuple[int, int]


def count_cost(method: str, *, hash: str = "mixer", colors: int = 2, tile_size: int = 128) -> Cost:
    """Count what one sample costs.

    Parameters
    ----------
    method : {"plain", "array", "atlas", "wei", "classed", "tone"}
    hash : {"mixer", "permutation"}
        The table has 256 entries, or fewer where that is no multiple of the colors. Tone needs the mixer.
    colors : int
        1 to 8.
    tile_size : int
        Pixels.

    Returns
    -------
    Cost

    Raises
    ------
    GpuError
        glslangValidator, spirv-opt or spirv-dis is missing (Debian: glslang-tools, spirv-tools).

    Notes
    -----
    The shaders that `GpuField` runs, with the position as an interpolated input, are compiled by
    glslangValidator and optimized by ``spirv-opt -O``, which inlines everything into the entry function.
    Counted is every instruction on a way through it, but labels, merge declarations, phi, branches without a
    condition and returns.
    """
    check_choice("method", method, METHODS)
    check_choice("hash", hash, ("mixer", "permutation"))
    colors = check_int("colors", colors, 1, 8)
    tile_size = check_int("tile_size", tile_size, 16, 1024)
    program = _Program(_compile(_source(method, hash, colors, tile_size)))
    return Cost(
        method,
        hash if method != "plain" else "",
        _texels(method, colors, tile_size),
        program.textures,
        program.ways(lambda step: step.op.startswith("ImageSample"))[1],
        program.ways(lambda step: step.reads_table)[1],
        program.reads_before_fetch(),
        program.ways(lambda step: step.op not in _SILENT),
        program.ways(lambda step: step.size * (step.op not in _SILENT + _MOVES)),
    )


def cost_table(tile_size: int = 128, colors: int = 2) -> list[Cost]:
    """Costs of all methods, with both hashes; see `count_cost`."""
    hashed = [(method, "mixer") for method in METHODS[1:]]
    hashed += [(method, "permutation") for method in METHODS[1:4]]
    return [
        count_cost(method, hash=hash, colors=colors, tile_size=tile_size)
        for method, hash in [("plain", "mixer"), *hashed]
    ]


def missing_tools() -> list[str]:
    """Programs that counting needs and that are not installed."""
    return [tool for tool in _TOOLS if which(tool) is None]


def _source(method: str, hash: str, colors: int, tile_size: int) -> str:
    tiles = _tiles(method, colors)
    given = MixerHash() if hash == "mixer" else PermutationHash(size=256 // colors * colors)
    counts = (colors,) if tiles.family == "classed" else tiles.colors
    lookup = shader_hash(given, counts, tone=method == "tone")
    parts = {"plain": ("plain.glsl",), "wei": WEI_PARTS, "tone": ("array.glsl", "tone.glsl")}
    parts |= dict.fromkeys(("array", "classed"), ("array.glsl",))
    defines = {"SIDES": f"vec2({colors**2}.0)"} | array_defines(tile_size, layer_gutter(tile_size))
    defines |= wang_defines(tiles, tile_size) if method == "wei" else corner_defines(tiles)
    if method == "tone":
        defines |= {"SPAN": "1.0", "TONE_TEXELS": "16.0", "TONE_OF_COLOR": "1", "TONE_MEAN": "vec3(0.5)"}
    hash_or_none = None if method == "plain" else lookup
    return assemble(
        hash_or_none, parts.get(method) or atlas_parts(tiles), _MAIN.read_text(encoding="utf-8"), defines
    )


def _tiles(method: str, colors: int) -> TileSet:
    if method == "wei":
        return wang_tiles(colors)
    return classed_corner_tiles(colors, 5) if method in ("classed", "tone") else corner_tiles(colors)


def _texels(method: str, colors: int, tile_size: int) -> int:
    """Texels of level 0; the plain picture is as large as an atlas, and tone 64 texels wide."""
    layered = method in ("array", "classed", "tone")
    side = tile_size + 2 * layer_gutter(tile_size) if layered else tile_size
    return len(_tiles(method, colors)) * side**2 * (2 if method == "wei" else 1) + 64**2 * (method == "tone")


@cache
def _compile(source: str) -> str:
    """The optimized SPIR-V of a fragment shader, in words."""
    if missing := missing_tools():
        raise GpuError(f"counting needs {', '.join(missing)}; apt-get install glslang-tools spirv-tools")
    with tempfile.TemporaryDirectory() as folder:
        glsl, raw, best = (Path(folder) / name for name in ("cost.frag", "raw.spv", "best.spv"))
        glsl.write_text(source, encoding="utf-8")
        _run("glslangValidator", "-V", str(glsl), "-o", str(raw))
        _run("spirv-opt", "-O", str(raw), "-o", str(best))
        return _run("spirv-dis", "--no-color", str(best))


def _run(*command: str) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        log = (done.stdout + done.stderr).strip()
        raise GpuError(f"{command[0]} refused the shader; it says:\n{log}")
    return done.stdout


@dataclass(frozen=True)
class _Step:
    """An instruction."""

    op: str
    result: str
    operands: tuple[str, ...]
    size: int
    reads_table: bool


class _Program:
    """The entry function of a SPIR-V listing, by blocks."""

    def __init__(self, listing: str) -> None:
        lines = re.findall(r"^ *(?:(%\S+) = )?Op(\w+) ?(.*)$", listing, re.MULTILINE)
        types = {result: (op, words.split()) for result, op, words in lines if op.startswith("Type")}
        images = {f"{result}" for result, (op, _) in types.items() if op == "TypeImage"}
        pointers = {
            result for result, (op, words) in types.items() if op == "TypePointer" and words[1] in images
        }
        self.textures = sum(op == "Variable" and words.split()[0] in pointers for _, op, words in lines)
        self.blocks: dict[str, list[_Step]] = {}
        entries: set[str] = set()
        inside = ""
        for result, op, words in lines:
            if op == "Label":
                inside = result
                self.blocks[inside] = []
            if not inside:
                continue
            operands = tuple(words.split())
            if op == "AccessChain" and operands[1] == "%table":
                entries.add(result)
            kind, parts = types.get(operands[0], ("", [])) if operands else ("", [])
            size = int(parts[1]) if kind == "TypeVector" else 1
            reads = op == "Load" and operands[1] in entries
            self.blocks[inside].append(_Step(op, result, operands, size, reads))

    def ways(self, weight: Callable[[_Step], int]) -> tuple[int, int]:
        """Least and most total weight on a way from the first block to a return."""

        @cache
        def from_block(label: str) -> tuple[int, int]:
            steps = self.blocks[label]
            own = sum(int(weight(step)) for step in steps)
            last = steps[-1]
            ahead = [from_block(word) for word in last.operands if word in self.blocks]
            if not ahead:
                return own, own
            return own + min(low for low, _ in ahead), own + max(high for _, high in ahead)

        return from_block(next(iter(self.blocks)))

    def reads_before_fetch(self) -> int:
        """The longest chain of table reads that a texture fetch waits for."""
        depth: dict[str, int] = {}
        fetches = [0]
        for steps in self.blocks.values():
            for step in steps:
                depth[step.result] = step.reads_table + max(
                    (depth.get(o, 0) for o in step.operands), default=0
                )
                if step.op.startswith("ImageSample"):
                    fetches.append(depth[step.result])
        return max(fetches)
