"""Wavefront OBJ: v, vt and f; what else it holds is counted by its keyword."""

from collections import Counter
from pathlib import Path

import numpy as np

from tilewright.domains import Mesh

_SILENT = {"vn", "g", "o", "s", "usemtl", "mtllib"}
"""What a mesh has no use for, and nobody misses: normals, names and materials."""


def read_obj(path: Path) -> tuple[Mesh, list[str]]:
    """The mesh, and what was passed over."""
    vertices: list[list[float]] = []
    texcoords: list[list[float]] = []
    corners: list[int] = []
    uses: list[int] = []
    sizes: list[int] = []
    others: Counter[str] = Counter()
    text = path.read_bytes().decode("utf-8", "replace").replace("\\\r\n", " ").replace("\\\n", " ")
    for number, line in enumerate(text.splitlines(), 1):
        words = line.partition("#")[0].split()
        if not words:
            continue
        key = words[0]
        try:
            if key == "v":
                vertices.append([float(word) for word in words[1:4]])
            elif key == "f":
                for word in words[1:]:
                    vertex, _, rest = word.partition("/")
                    corners.append(_resolve(vertex, len(vertices)))
                    use = rest.partition("/")[0]
                    uses.append(_resolve(use, len(texcoords)) if use else -1)
                sizes.append(len(words) - 1)
            elif key == "vt":
                texcoords.append([float(words[1]), float(words[2]) if len(words) > 2 else 0.0])
            elif key not in _SILENT:
                others[key] += 1
        except (ValueError, IndexError):
            raise ValueError(f"line {number} is {line.strip()[:60]!r}") from None
    if not vertices and not sizes:
        raise ValueError("it holds neither vertices nor faces")
    if any(len(place) != 3 for place in vertices):
        raise ValueError("a vertex has fewer than three coordinates")
    return (
        Mesh(
            np.array(vertices, np.float64).reshape(-1, 3),
            np.array(corners, np.int64),
            np.concatenate([[0], np.cumsum(sizes, dtype=np.int64)]),
            _spread(texcoords, uses),
        ),
        [f"{count} of {key}" for key, count in sorted(others.items())],
    )


def _resolve(word: str, count: int) -> int:
    """An index from 0 on: they begin at 1, and below 0 they count back from the last one so far."""
    number = int(word)
    if number == 0:
        raise ValueError("numbers begin at 1")
    if number > 0:
        return number - 1
    if count + number < 0:
        raise ValueError("counts back beyond the first")
    return count + number


def _spread(texcoords: list[list[float]], uses: list[int]) -> np.ndarray | None:
    """Texture coordinates of all corners, where all of them have some."""
    if not texcoords or not uses or min(uses) < 0:
        return None
    if max(uses) >= len(texcoords):
        raise ValueError(f"a face names texture coordinate {max(uses) + 1} of {len(texcoords)}")
    spread: np.ndarray = np.array(texcoords, np.float64)[uses]
    return spread
