"""One picture, repeated over the plane: the plain texture that fields are compared with."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice, shape_error
from tilewright.gpu.cameras import Camera, Sight
from tilewright.gpu.device import open_gpu
from tilewright.gpu.painter import Painter
from tilewright.gpu.pixels import PixelFormat
from tilewright.shaders.hashing import view_bytes
from tilewright.shaders.layouts import plain_layout
from tilewright.signals.textures.kinds import KINDS


class GpuPicture:
    """A picture repeated over the plane, drawn by the cameras of `GpuField`.

    Parameters
    ----------
    pixels : array, shape (side, side, channels), uint8, uint16 or float32
        A square; its side is best a power of two.
    kind : str, optional
        What it holds: ``"color"`` (default), ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` or
        ``"normal-dx"``.

    Raises
    ------
    TilewrightValueError
        An unknown kind, or pixels that are no square.
    GpuError
        There is no GPU or no wgpu, or the texture is too large.
    """

    def __init__(self, pixels: NDArray[Any], kind: str = "color") -> None:
        check_choice("kind", kind, KINDS)
        if not isinstance(pixels, np.ndarray) or pixels.ndim != 3 or pixels.shape[0] != pixels.shape[1]:
            raise shape_error("pixels", np.shape(pixels), "a square (side, side, channels)")
        self._side = len(pixels)
        form = PixelFormat.of(pixels, kind)
        self._painter = Painter(open_gpu(), plain_layout(pixels, kind), None, form)

    def render(self, camera: Camera) -> NDArray[Any]:
        """Draw what a camera sees.

        Parameters
        ----------
        camera : OrthographicCamera or PerspectiveCamera
            Where the plane is seen from, and the size of the picture.

        Returns
        -------
        array, shape (height, width, channels)
            Pixels of the picture's type, 0 in all channels where the camera sees the sky.

        Raises
        ------
        TilewrightTypeError
            Something else than one of the cameras.
        TilewrightValueError
            The camera sees cells that are too far out.
        """
        return self._painter.paint(camera, self._side, self._view)

    def _view(self, sight: Sight) -> bytes:
        return view_bytes(sight.rows, np.zeros((2, 4), np.uint32), (0, 0))
