"""Read meshes: which reader a file needs, and what its troubles are called."""

import warnings
from collections.abc import Callable
from pathlib import Path

from tilewright.domains import Mesh
from tilewright.errors import TilewrightError, TilewrightFileError, TilewrightWarning
from tilewright.files.atomic import AnyPath, as_path
from tilewright.files.meshes.obj import read_obj
from tilewright.files.meshes.off import read_off
from tilewright.files.meshes.ply import read_ply_mesh

_READERS: dict[str, Callable[[Path], tuple[Mesh, list[str]]]] = {
    ".obj": read_obj,
    ".off": read_off,
    ".ply": read_ply_mesh,
}


def read_mesh(path: AnyPath) -> Mesh:
    """Read a mesh from a file; quads and larger faces stay what they are.

    Parameters
    ----------
    path : str or path-like
        ``.obj`` (vertices, faces and texture coordinates), ``.off``, or ``.ply`` (text or binary). What else
        the file holds is passed over, and said in a warning.

    Returns
    -------
    Mesh
        Vertices and faces in their order.

    Raises
    ------
    TilewrightTypeError
        Something else than a path.
    TilewrightFileError
        No such file, one of another kind, a damaged one, or one without faces.

    Examples
    --------
    >>> import tempfile
    >>> from pathlib import Path
    >>> import tilewright as tw
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "square.off")
    ...     _ = file.write_bytes(b"OFF 4 1 0  0 0 0  1 0 0  1 1 0  0 1 0  4 0 1 2 3")
    ...     tw.read_mesh(file)
    <Mesh: 4 vertices, 1 face, of 4 corners>
    """
    source = as_path(path)
    suffix = source.suffix.lower()
    if suffix not in _READERS:
        raise TilewrightFileError(
            f"{source} is not a mesh that can be read; {', '.join(_READERS)} can", value=source
        )
    if not source.is_file():
        raise TilewrightFileError(f"{source} is not a file", value=source)
    try:
        mesh, passed = _READERS[suffix](source)
    except TilewrightError as error:
        raise TilewrightFileError(f"{source}: {error}", value=source) from None
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        raise TilewrightFileError(f"{source} cannot be read: {reason}", value=source) from None
    except (ValueError, IndexError, OverflowError) as error:
        raise TilewrightFileError(
            f"{source} is damaged or not what its name says: {error}", value=source
        ) from None
    if passed:
        warnings.warn(
            f"of {source.name} was passed over: {', '.join(passed)}", TilewrightWarning, stacklevel=2
        )
    return mesh
