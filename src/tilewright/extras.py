"""Extras: packages that not everybody needs, asked for before the work that needs them."""

from importlib.util import find_spec

from tilewright.errors import TilewrightError

EXTRAS = {
    "pyarrow": ("points", "pyarrow"),
    "finufft": ("points", "finufft"),
    "matplotlib": ("plots", "matplotlib"),
    "pysat": ("solve", "python-sat"),
    "wgpu": ("gpu", "wgpu"),
    "imageio_ffmpeg": ("video", "imageio-ffmpeg"),
    "trimesh": ("meshes", "trimesh"),
    "pandas": ("", "pandas"),
}
"""What is imported: the extra of tilewright that brings it, if one does, and the name to install it by."""


class MissingExtra(TilewrightError, ImportError):
    """Something needs a package that is not installed; the message names the extra that brings it."""


def has_package(module: str) -> bool:
    """Whether a module of `EXTRAS` can be imported."""
    try:
        return find_spec(module) is not None
    except ImportError:  # something keeps it from being imported
        return False
    except ValueError:  # a module that was put in its place and says nothing of itself
        return True


def need_package(module: str, what: str, kind: type[TilewrightError] = MissingExtra) -> None:
    """Refuse to begin ``what`` where the module of `EXTRAS` that it needs is missing, in one line."""
    if has_package(module):
        return
    extra, package = EXTRAS[module]
    install = f'pip install "tilewright[{extra}]"' if extra else f"pip install {package}"
    raise kind(f"{what} needs the package {package}", value=package, advice=f"install it with: {install}")
