"""Brick walls: from dappled tilings, in regions with a given boundary, and endless ones."""

from tilewright.lazy import load_lazily

_HOME = {
    "BrickRegion": "boundary",
    "EndlessBricks": "endless",
    "brick_region": "boundary",
    "brick_tiling": "from_dappled",
    "endless_bricks": "endless",
}

__all__ = list(_HOME)
__getattr__, __dir__ = load_lazily(__name__, _HOME)
