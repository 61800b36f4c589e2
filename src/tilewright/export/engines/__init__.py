"""Materials for engines: folders with textures, a shader in the engine's dialect, and a scene."""

from tilewright.lazy import load_lazily

_HOME = {"TARGETS": "targets", "save_for_engine": "targets"}

__getattr__, __dir__ = load_lazily(__name__, _HOME)
__all__ = list(_HOME)
