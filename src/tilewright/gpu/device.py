"""The GPU: opening it, pictures and programs on it, and drawing. The only module that knows wgpu."""

import os
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import GpuError
from tilewright.extras import need_package

_LIMITS = ("max-texture-array-layers", "max-texture-dimension-2d")
_FILTERABLE = "float32-filterable"
_ANISOTROPY = 8


class Gpu:
    """An opened GPU."""

    def __init__(self, wgpu: Any, adapter: Any) -> None:
        self._wgpu = wgpu
        self.name: str = adapter.info["device"] or adapter.info["description"]
        self.filters_floats = _FILTERABLE in adapter.features
        # Mesa's software filter blurs where anisotropy is allowed, even footprints that are round.
        self._anisotropy = 1 if adapter.info["adapter_type"] == "CPU" else _ANISOTROPY
        self.most_layers, self.longest_side = (int(adapter.limits[limit]) for limit in _LIMITS)
        with _told("the GPU could not be opened"):
            self._device = adapter.request_device_sync(
                required_features=[_FILTERABLE] if self.filters_floats else [],
                required_limits={limit: adapter.limits[limit] for limit in _LIMITS},
            )

    def texture(self, levels: Sequence[NDArray[Any]], kind: str, *, layered: bool) -> Any:
        """A view of a texture of the format ``kind``; levels of shape (layers, rows, columns, channels)."""
        layers, rows, columns, _ = levels[0].shape
        usage = self._wgpu.TextureUsage
        with _told("the texture does not fit on the GPU"):
            texture = self._device.create_texture(
                size=(columns, rows, layers),
                format=kind,
                mip_level_count=len(levels),
                usage=usage.TEXTURE_BINDING | usage.COPY_DST,
            )
            for number, level in enumerate(levels):
                self._write(texture, number, np.ascontiguousarray(level))
            return texture.create_view(dimension="2d-array" if layered else "2d")

    def _write(self, texture: Any, number: int, level: NDArray[Any]) -> None:
        layers, rows, columns, channels = level.shape
        row = columns * channels * level.itemsize
        for first in range(layers):
            self._device.queue.write_texture(
                {"texture": texture, "mip_level": number, "origin": (0, 0, first)},
                level[first],
                {"bytes_per_row": row, "rows_per_image": rows},
                (columns, rows, 1),
            )

    def sampler(self, address: str, filtering: str) -> Any:
        """How a texture is read: ``"nearest"`` texel of level 0, ``"trilinear"`` or ``"anisotropic"``."""
        word = "nearest" if filtering == "nearest" else "linear"
        return self._device.create_sampler(
            address_mode_u=address,
            address_mode_v=address,
            mag_filter=word,
            min_filter=word,
            mipmap_filter=word,
            max_anisotropy=self._anisotropy if filtering == "anisotropic" else 1,
        )

    def buffer(self, data: bytes, *, uniform: bool) -> Any:
        """Bytes for a shader: the view, or a table."""
        usage = self._wgpu.BufferUsage
        return self._device.create_buffer_with_data(
            data=data, usage=usage.COPY_DST | (usage.UNIFORM if uniform else usage.STORAGE)
        )

    def program(self, vertex: str, fragment: str, target: str) -> Any:
        """Compile GLSL; the compiler's log is in the error where it fails."""
        with _told("the shader could not be compiled; the compiler says:\n"):
            modules = [
                self._device.create_shader_module(label=stage, code=code)
                for stage, code in (("vertex", vertex), ("fragment", fragment))
            ]
            return self._device.create_render_pipeline(
                layout="auto",
                vertex={"module": modules[0], "entry_point": "main"},
                primitive={"topology": "triangle-list"},
                fragment={"module": modules[1], "entry_point": "main", "targets": [{"format": target}]},
            )

    def bind(self, program: Any, resources: dict[int, Any]) -> Any:
        """Resources by the binding the shader gives them."""
        return self._device.create_bind_group(
            layout=program.get_bind_group_layout(0),
            entries=[{"binding": number, "resource": thing} for number, thing in resources.items()],
        )

    def update(self, buffer: Any, data: bytes) -> None:
        """New bytes for a buffer."""
        self._device.queue.write_buffer(buffer, 0, data)

    def canvas(self, width: int, height: int, target: str) -> Any:
        """A texture to draw into."""
        usage = self._wgpu.TextureUsage
        with _told("the picture does not fit on the GPU"):
            return self._device.create_texture(
                size=(width, height, 1), format=target, usage=usage.RENDER_ATTACHMENT | usage.COPY_SRC
            )

    def draw(self, program: Any, group: Any, canvas: Any) -> None:
        """Fill the canvas."""
        encoder = self._device.create_command_encoder()
        drawing = encoder.begin_render_pass(
            color_attachments=[
                {
                    "view": canvas.create_view(),
                    "clear_value": (0, 0, 0, 0),
                    "load_op": "clear",
                    "store_op": "store",
                }
            ]
        )
        drawing.set_pipeline(program)
        drawing.set_bind_group(0, group)
        drawing.draw(3)
        drawing.end()
        self._device.queue.submit([encoder.finish()])

    def read(self, canvas: Any, width: int, height: int, dtype: np.dtype[Any]) -> NDArray[Any]:
        """Pixels of the north-west of a canvas with four channels; waits until they are drawn."""
        row = width * 4 * dtype.itemsize
        with _told("the picture could not be read back"):
            data = self._device.queue.read_texture(
                {"texture": canvas}, {"bytes_per_row": row, "rows_per_image": height}, (width, height, 1)
            )
        return np.frombuffer(data, dtype).reshape(height, width, 4)


@cache
def open_gpu() -> Gpu:
    """The GPU of this machine, a hardware one where there are several; opened once."""
    need_package("wgpu", "drawing on a GPU", GpuError)
    import wgpu

    with _runtime_folder():
        try:
            adapter = wgpu.gpu.request_adapter_sync(power_preference="high-performance")
        except RuntimeError:
            adapter = None
    if adapter is None:
        raise GpuError(
            "no GPU was found",
            advice="install its Vulkan driver, or Mesa's software one: apt-get install mesa-vulkan-drivers",
        )
    return Gpu(wgpu, adapter)


@contextmanager
def _told(what: str) -> Iterator[None]:
    """Errors of wgpu as a `GpuError`."""
    import wgpu

    try:
        yield
    except (wgpu.GPUError, wgpu.GPUPipelineError) as error:
        joint = "" if what.endswith("\n") else ": "
        raise GpuError(f"{what}{joint}{str(error).strip()}") from None


@contextmanager
def _runtime_folder() -> Iterator[None]:
    """Drivers complain on stderr where this variable is not set, as in services and containers."""
    if "XDG_RUNTIME_DIR" in os.environ:
        yield
        return
    os.environ["XDG_RUNTIME_DIR"] = tempfile.gettempdir()
    try:
        yield
    finally:
        del os.environ["XDG_RUNTIME_DIR"]
