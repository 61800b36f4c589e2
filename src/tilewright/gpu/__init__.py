"""A field on a GPU, through wgpu (the extra ``gpu``); nothing here imports wgpu before a field is made."""

from tilewright.lazy import load_lazily

_HOME = {
    "GpuField": "field",
    "GpuPicture": "picture",
    "OrthographicCamera": "cameras",
    "PerspectiveCamera": "cameras",
    "Cost": "costs",
    "count_cost": "costs",
    "cost_table": "costs",
}

__all__ = list(_HOME)
__getattr__, __dir__ = load_lazily(__name__, _HOME)
