"""Meshes in files that other programs wrote, each kind by its own reader."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tilewright.domains import Mesh
from tilewright.errors import TilewrightError, TilewrightFileError, TilewrightWarning, brief
from tilewright.extras import need_package
from tilewright.files.atomic import AnyPath, as_path
from tilewright.files.meshes.obj import read_obj
from tilewright.files.meshes.off import read_off
from tilewright.files.meshes.ply import read_ply, read_ply_property
from tilewright.files.meshes.raw import RawMesh

_READERS = {".obj": read_obj, ".off": read_off, ".ply": read_ply}
_FOREIGN = (".stl", ".glb", ".gltf", ".3mf", ".dae")
"""Some of what trimesh reads, for the messages."""


def read_mesh(path: AnyPath) -> Mesh:
    r"""Read a polygon mesh from a file, its faces as they are.

    OBJ, OFF and PLY are read here and keep triangles, quads and larger faces. Other kinds are read through
    the package trimesh, which cuts all faces into triangles; several geometries are joined into one mesh.
    Normals, colors, groups and materials are passed over. What else a file holds and a mesh does not, such
    as lines and curves, is told in one warning.

    Parameters
    ----------
    path : str or path-like
        ``.obj``, ``.off`` or ``.ply``; with trimesh also ``.stl``, ``.glb``, ``.gltf``, ``.3mf`` and others.

    Returns
    -------
    Mesh
        Vertices in the units and axes of the file, faces, and texture coordinates where every face has them.

    Raises
    ------
    TilewrightTypeError
        Something else than a path.
    TilewrightFileError
        No such file, one of another kind, damaged, without faces; a face that cannot be one, as of two
        corners or of vertices that are not there; coordinates that are not finite.
    MissingExtra
        Another kind than OBJ, OFF and PLY without the package trimesh.

    Warns
    -----
    TilewrightWarning
        The file holds something that was passed over and may have been meant.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> import tilewright as tw
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder, "square.off")
    ...     _ = file.write_bytes(b"OFF 4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n")
    ...     tw.read_mesh(file)
    <Mesh: 4 vertices, 1 face, of 4 corners>
    """
    source = as_path(path)
    check_mesh_file(source)
    with _told(source):
        raw = _read(source)
        mesh = Mesh(raw.vertices, raw.corners, raw.starts, raw.texcoords)
    if raw.notes:
        warnings.warn(f"{source}: not taken from it: {'; '.join(raw.notes)}", TilewrightWarning, stacklevel=2)
    return mesh


def read_mesh_property(path: AnyPath, name: str) -> NDArray[np.float64]:
    """A number that every vertex of a PLY mesh has, or else every face, by its name in the file."""
    source = as_path(path)
    check_mesh_file(source)
    if source.suffix.lower() != ".ply":
        raise TilewrightFileError(
            f"{source} holds no property {brief(name)}; of meshes only .ply name properties", value=source
        )
    with _told(source):
        return read_ply_property(source.read_bytes(), name)


@contextmanager
def _told(source: Path) -> Iterator[None]:
    """Whatever goes wrong with a file, as one line that names it."""
    try:
        yield
    except TilewrightError as error:
        raise TilewrightFileError(f"{source}: {error}", value=source) from None
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise TilewrightFileError(f"{source} cannot be read: {reason}", value=source) from None
    except Exception as error:  # of parsers of other libraries
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise TilewrightFileError(
            f"{source} is damaged or not what its name says: {reason}", value=source
        ) from None


def check_mesh_file(source: Path) -> None:
    """Refuse what cannot be a mesh before any of it is read."""
    if source.is_dir():
        raise TilewrightFileError(f"{source} is a folder; a mesh file is expected", value=source)
    if not source.is_file():
        raise TilewrightFileError(f"{source} is not a file", value=source)
    if not source.stat().st_size:
        raise TilewrightFileError(f"{source} is empty", value=source)
    if not source.suffix:
        known = ", ".join((*_READERS, *_FOREIGN))
        raise TilewrightFileError(
            f"{source} has no suffix that says what it is; {known} can be read", value=source
        )
    if source.suffix.lower() not in _READERS:
        need_package("trimesh", f"a {source.suffix.lower()} mesh")


def _read(source: Path) -> RawMesh:
    reader = _READERS.get(source.suffix.lower())
    if reader is not None:
        return reader(source.read_bytes())
    from tilewright.files.meshes.foreign import read_foreign

    return read_foreign(source)
