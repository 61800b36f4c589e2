"""Drawing a camera's picture block by block, with one compiled shader and its textures."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_type
from tilewright.errors import GpuError
from tilewright.gpu.cameras import Camera, Sight
from tilewright.gpu.device import Gpu
from tilewright.gpu.pixels import PixelFormat
from tilewright.shaders.assembly import VERTEX, assemble, read_part
from tilewright.shaders.hashing import VIEW_BYTES, ShaderHash
from tilewright.shaders.layouts import Layout

TONE = 5
"""Binding of the picture of tone; its sampler comes after it."""
BLOCK = 1024
"""Side of the blocks that a picture is drawn in: their coordinates are exact enough in 32-bit floats."""


class Painter:
    """A compiled shader with its textures, and a canvas of one block."""

    def __init__(
        self,
        gpu: Gpu,
        layout: Layout,
        hash: ShaderHash | None,
        pixels: PixelFormat,
        tone: Sequence[NDArray[np.float16]] = (),
    ) -> None:
        check_fits(layout, gpu)
        if pixels.target_dtype == np.float32 and not gpu.filters_floats:
            raise GpuError(
                f"{gpu.name} cannot filter 32-bit floats, which {pixels.dtype} maps need",
                advice="make them uint8",
            )
        self._gpu, self._pixels = gpu, pixels
        fragment = assemble(hash, layout.parts, read_part("field.frag"), layout.defines)
        self._program = gpu.program(read_part(VERTEX), fragment, pixels.target)
        self._view = gpu.buffer(bytes(VIEW_BYTES), uniform=True)
        resources: dict[int, Any] = {0: self._view}
        tables = np.concatenate([*([hash.table()] if hash else []), layout.places])
        if len(tables):
            resources[2] = gpu.buffer(tables.tobytes(), uniform=False)
        for binding, mips in enumerate(layout.textures, 3):
            levels = [pixels.upload(level) for level in mips.levels]
            resources[binding] = gpu.texture(levels, pixels.texture, layered=layout.layered)
        if tone:
            levels = [level[np.newaxis] for level in tone]
            resources[TONE] = gpu.texture(levels, "rgba16float", layered=False)
            resources[TONE + 1] = gpu.sampler("mirror-repeat", "trilinear")
        self._groups = {
            filtering: gpu.bind(self._program, resources | {1: gpu.sampler(layout.address, filtering)})
            for filtering in ("nearest", "trilinear", "anisotropic")
        }
        self._canvas = gpu.canvas(BLOCK, BLOCK, pixels.target)

    def paint(self, camera: Camera, tile_size: int, view: Callable[[Sight], bytes]) -> NDArray[Any]:
        """The picture of a camera; ``view`` makes the shader's view of what a block sees."""
        check_type("camera", camera, Camera, "an OrthographicCamera or a PerspectiveCamera")
        picture = np.empty((camera.height, camera.width, self._pixels.channels), self._pixels.dtype)
        for top in range(0, camera.height, BLOCK):
            for left in range(0, camera.width, BLOCK):
                height, width = min(BLOCK, camera.height - top), min(BLOCK, camera.width - left)
                seen = view(camera.sight(left, top, width, height, tile_size))
                self.draw(seen, camera.filtering)
                picture[top : top + height, left : left + width] = self.read(width, height)
        return picture

    def draw(self, view: bytes, filtering: str) -> None:
        """Draw a block; what is drawn stays on the GPU."""
        self._gpu.update(self._view, view)
        self._gpu.draw(self._program, self._groups[filtering], self._canvas)

    def read(self, width: int, height: int) -> NDArray[Any]:
        """The north-west of the block that was drawn last, in the type of the map."""
        return self._pixels.download(self._gpu.read(self._canvas, width, height, self._pixels.target_dtype))


def check_fits(layout: Layout, gpu: Gpu) -> None:
    """Raise where a GPU has no textures of a layout's size."""
    for mips in layout.textures:
        layers, *sides, _ = mips.levels[0].shape
        if max(sides) > gpu.longest_side:
            raise GpuError(
                f"the {layout.name} is {sides[1]} x {sides[0]} texels, {gpu.name} takes "
                f"{gpu.longest_side} along a side",
                advice="use fewer colors or smaller tiles",
            )
        if layers > gpu.most_layers:
            raise GpuError(
                f"the array has {layers} layers, {gpu.name} takes {gpu.most_layers}",
                advice="use layout='atlas'",
            )
