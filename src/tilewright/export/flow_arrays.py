"""The arrays of a flow as a file for other programs."""

from typing import Any

import numpy as np

from tilewright.checks import check_type
from tilewright.files.atomic import AnyPath, whole_file
from tilewright.flows import Flow

_ARRAYS = ("cells", "torus", "times", "positions", "ways", "departures", "born", "killed", "left")
_COLUMNS = ("ways", "speed", "emits", "kills")


def save_flow(path: AnyPath, flow: Flow) -> None:
    """Write all arrays of a flow to a .npz file.

    Parameters
    ----------
    path : str or path-like
        ``FILE.npz``; it appears whole or not at all.
    flow : Flow
        The arrays keep the names of its attributes; the tiles are the columns ``tile_ways``, ``tile_speed``,
        ``tile_emits`` and ``tile_kills``.

    Raises
    ------
    TilewrightTypeError
        ``flow`` is something else.
    TilewrightFileError
        The file cannot be written.
    """
    check_type("flow", flow, Flow, "a Flow")
    arrays: dict[str, Any] = {
        f"tile_{name}": np.array([getattr(tile, name) for tile in flow.tiles]) for name in _COLUMNS
    }
    arrays |= {name: np.asarray(getattr(flow, name)) for name in _ARRAYS}
    with whole_file(path) as unfinished:
        np.savez_compressed(unfinished, **arrays)
