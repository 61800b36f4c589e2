"""Flows as pictures: animations of dots with fading trails, and heat maps of where particles are."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice, check_int, check_progress, check_real, check_type
from tilewright.errors import Progress
from tilewright.export.drawing.videos import check_videos, write_video
from tilewright.files.atomic import AnyPath, as_path, whole_file
from tilewright.flows.flow import Flow
from tilewright.pixels import read_hex

SUFFIXES = (".gif", ".webp", ".mp4")
_MOST_PIXELS = 2**24
_MOST_ANIMATED = 2**29
_MOST_DOTS = 2**24
_GROUND, _LINE, _SOURCE, _SINK = "#10131c", "#343b52", "#3d8f68", "#a04540"
_HUES = {
    # North, east, south, west: opposite ways differ for the color-blind too.
    "direction": ("#2fd8c0", "#ffc24b", "#ff5f9e", "#5aa2ff"),
    "particle": ("#ffc24b", "#5aa2ff", "#ff5f9e", "#2fd8c0", "#b58cff", "#ff8a50"),
}
_HEAT = ("#10131c", "#2b1b52", "#6f1d72", "#b6305f", "#ea5f3c", "#fba83a", "#fdf3b4")
_RAMP, _LEVELS = 8, 16
"""Palette entries of each color of the tiles, and of each hue of the particles."""
_TRAIL_LEVEL = 0.75
_FADE = 12
"""Frames in which particles come up at the start and go at the end, so that repeating does not jump."""


def save_animation(
    path: AnyPath,
    flow: Flow,
    *,
    size: int | None = None,
    color: str = "direction",
    trail: float = 8.0,
    rate: int = 25,
    progress: Progress | None = None,
) -> None:
    """Write a flow as an animated GIF or WebP, repeated for ever, or as an MP4: a picture for each frame.

    Parameters
    ----------
    path : str or path-like
        ``FILE.gif``: one palette for all frames, so that nothing flickers; ``FILE.webp``; or
        ``FILE.mp4`` (H.264), which needs the package imageio-ffmpeg.
    flow : Flow
        Up to 2^24 particles times frames. Trails look best where particles go half a cell or less from
        frame to frame.
    size : int, optional
        Pixels along a cell, 4 to 128; by default one that makes the longer side about 640. A frame holds up
        to 2^24 pixels, all frames 2^29.
    color : str, optional
        ``"direction"``, the default: where a particle goes. ``"particle"``: which one it is.
    trail : float, optional
        Frames after which a trail has half its light, 0 for no trails, up to 1000; default 8.
    rate : int, optional
        Frames per second, 1 to 50; default 25. GIF rounds to hundredths of a second.
    progress : callable, optional
        Called as ``progress(done, total, what)`` during the work; raise `Cancelled` from it to stop.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        The file has another ending, a number is out of range, or there are too many pixels or particles.
    TilewrightFileError
        The file cannot be written.

    Notes
    -----
    Kaji et al. 2016, section 5, shows such dots.
    """
    path = as_path(path)
    suffix = check_choice("the ending of the file", path.suffix.lower(), SUFFIXES)
    check_int("rate", rate, 1, 50)
    check_progress(progress)
    _check_flow(flow)
    if suffix == ".mp4":
        check_videos()
    count = len(flow.times)
    painter = _Painter(flow, fit_size(flow.cells.shape, size, count), color, trail)
    fade = np.minimum(1, (np.minimum(np.arange(count), np.arange(count)[::-1]) + 1) / min(_FADE, count))

    def pictures() -> Iterator[Any]:
        for frame in range(count):
            if progress is not None:
                progress(frame, count, "painting")
            painter.advance(frame)
            picture = painter.picture(float(fade[frame]))
            yield picture if suffix == ".gif" else picture.convert("RGB")

    if suffix == ".mp4":
        with whole_file(path) as unfinished:
            write_video(unfinished, map(np.asarray, pictures()), painter.base.shape, rate)
        return
    rest = pictures()
    first = next(rest)
    # What has not changed since the last frame is written as transparent.
    options: dict[str, Any] = {
        "duration": max(20, round(100 / rate) * 10),
        "optimize": True,
        "palette": painter.palette,
        "transparency": painter.transparent,
    }
    if suffix == ".webp":
        options = {"duration": round(1000 / rate), "lossless": True, "quality": 30, "method": 2}
    with whole_file(path) as unfinished:
        first.save(unfinished, save_all=True, append_images=rest, loop=0, **options)


def draw_trails(
    flow: Flow, *, frame: int = -1, size: int | None = None, color: str = "direction", trail: float = 8.0
) -> NDArray[np.uint8]:
    """Paint one frame of the animation that `save_animation` writes.

    Parameters
    ----------
    flow : Flow
        Up to 2^24 particles times frames.
    frame : int, optional
        Number of the frame, from 0 on; default -1, the last.
    size : int, optional
        Pixels along a cell, 4 to 128; by default one that makes the longer side about 640.
    color : str, optional
        ``"direction"``, the default: where a particle goes. ``"particle"``: which one it is.
    trail : float, optional
        Frames after which a trail has half its light, 0 for no trails, up to 1000; default 8.

    Returns
    -------
    uint8 array, shape (height * size, width * size, 3)
        sRGB colors.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range, or there are too many pixels or particles.
    """
    _check_flow(flow)
    count = len(flow.times)
    last = check_int("frame", frame, -count, count - 1) % count
    painter = _Painter(flow, fit_size(flow.cells.shape, size), color, trail)
    for earlier in range(last + 1):
        painter.advance(earlier)
    return np.array(painter.picture().convert("RGB"))


def draw_density(flow: Flow, *, size: int = 8, most: float | None = None) -> NDArray[np.uint8]:
    """Paint where particles are, as a heat map: dark where none comes, light where many are.

    Parameters
    ----------
    flow : Flow
        The flow.
    size : int, optional
        Pixels along a cell, 1 to 64; default 8. From 4 on, lanes show, from centers to edges (`Flow.arms`),
        the busier ones on top where they cross; below, cells (`Flow.density`). Colors go by the square root.
    most : float, optional
        Particles on a lane, or in a cell, that are shown lightest, as are more: give it to compare flows. By
        default the number that only 1 in 500 of those that are not empty exceed.

    Returns
    -------
    uint8 array, shape (height * size, width * size, 3)
        sRGB colors.

    Raises
    ------
    TilewrightTypeError
        An argument of a wrong type.
    TilewrightValueError
        A number is out of range, or there are too many pixels.
    """
    _check_flow(flow)
    check_int("size", size, 1, 64)
    check_int("pixels", flow.cells.size * size**2, 1, _MOST_PIXELS, "take a smaller size")
    heat = flow.arms() if size >= 4 else flow.density()
    if most is not None:
        check_real("most", most, 1e-12, 1e12)
    else:
        most = float(np.quantile(heat[heat > 0], 0.998)) if heat.any() else 1.0
    light = np.sqrt(np.minimum(heat / most, 1))
    shown = _lanes(light, size) if size >= 4 else light.repeat(size, axis=0).repeat(size, axis=1)
    anchors = np.array([read_hex(color) for color in _HEAT], float)
    at = np.linspace(0, 1, len(anchors))
    return np.stack([np.rint(np.interp(shown, at, band)) for band in anchors.T], axis=-1).astype(np.uint8)


def fit_size(extent: tuple[int, ...], size: int | None, frames: int = 1) -> int:
    """Pixels along a cell of frames of (height, width) cells; by default the longer side has about 640.

    Frames that would be too large are refused.
    """
    least, cells = 4, extent[0] * extent[1]
    chosen = max(least, min(48, 640 // max(extent))) if size is None else check_int("size", size, least, 128)
    advice = "take a smaller size" if chosen > least else "take fewer cells, or draw_density"
    check_int("the number of pixels of a frame", cells * chosen**2, 1, _MOST_PIXELS, advice)
    if frames > 1:
        advice = "take a smaller size, or record fewer frames"
        check_int("frames times pixels", frames * cells * chosen**2, 1, _MOST_ANIMATED, advice)
    return chosen


def _lanes(arms: NDArray[np.float64], size: int) -> NDArray[np.float64]:
    """What arms (h, w, 4) hold, as lanes half a cell wide."""
    height, width, ways = arms.shape
    shown = np.zeros((height, size, width, size))
    low, high = size // 4, size - size // 4
    middle = slice(low, high)
    rows = (slice(0, high), middle, slice(low, size), middle)
    columns = (middle, slice(low, size), middle, slice(0, high))
    for way in range(ways):
        lane = shown[:, rows[way], :, columns[way]]
        np.maximum(lane, arms[:, np.newaxis, :, np.newaxis, way], out=lane)
    return shown.reshape(height * size, width * size)


def _check_flow(flow: Flow) -> None:
    check_type("flow", flow, Flow, "a Flow")


class _Painter:
    """A canvas on which light fades: frames are painted on it one after the other."""

    def __init__(self, flow: Flow, size: int, color: str, trail: float) -> None:
        self._flow, self._size = flow, size
        self._hues = _HUES[check_choice("color", color, tuple(_HUES))]
        self._by_direction = color == "direction"
        check_real("trail", trail, 0, 1000)
        self._decay = 0.5 ** (1 / trail) if trail > 0 else 0.0
        check_int("particles times frames", flow.ways.size, 0, _MOST_DOTS, "record fewer frames")
        self.base = _paint_tiles(flow, self._size)
        self._levels = np.zeros(self.base.shape, np.float32)
        self._colors = np.zeros(self.base.shape, np.uint8)
        self._frame = 0
        self.palette = _palette(self._hues)
        self.transparent = len(self.palette) // 3 - 1

    def advance(self, frame: int) -> None:
        """Let the light fade and add the way to a frame."""
        from tilewright.kernels.flow_drawing import paint_trails

        flow, before = self._flow, max(frame - 1, 0)
        self._frame = frame
        self._levels *= self._decay
        if frame and self._decay:
            paint_trails(
                flow.positions[before],
                flow.positions[frame],
                flow.ways[before],
                flow.ways[frame],
                self._hue_of(frame),
                float(self._size),
                self._size * 0.055,
                _TRAIL_LEVEL,
                flow.torus,
                self._levels,
                self._colors,
            )

    def _hue_of(self, frame: int) -> NDArray[np.uint8]:
        if self._by_direction:
            return self._flow.ways[frame]
        return (np.arange(self._flow.ways.shape[1]) % len(self._hues)).astype(np.uint8)

    def picture(self, light: float = 1.0) -> Any:
        """The frame with its dots on top, as a palette image; particles have this much light."""
        from PIL import Image

        from tilewright.kernels.flow_drawing import paint_dots

        flow, frame = self._flow, self._frame
        levels, colors = self._levels.copy(), self._colors.copy()
        radius = max(1.2, self._size * 0.16)
        paint_dots(
            flow.positions[frame],
            flow.ways[frame],
            self._hue_of(frame),
            float(self._size),
            radius,
            flow.torus,
            levels,
            colors,
        )
        shade = np.rint(levels * light * _LEVELS).astype(np.uint8)
        # Lines of tiles lie on top of trails that are darker than they.
        below = np.where(self.base > 0, (self.base - 1.0) % _RAMP + 1, 0)
        shown = (shade > 0) & (shade * _RAMP >= below * 0.3 * _LEVELS)
        index = np.where(shown, 3 * _RAMP + colors * _LEVELS + shade, self.base).astype(np.uint8)
        image = Image.fromarray(index, "P")
        image.putpalette(self.palette)
        return image


def _palette(hues: tuple[str, ...]) -> bytes:
    """Ground; from there on to line, source and sink; on to each hue; one that is not shown."""
    ground = np.array(read_hex(_GROUND))
    colors = [ground]
    for color, count in ((_LINE, _RAMP), (_SOURCE, _RAMP), (_SINK, _RAMP), *((hue, _LEVELS) for hue in hues)):
        colors += [ground + (np.array(read_hex(color)) - ground) * (k + 1) / count for k in range(count)]
    colors.append(np.array([255, 0, 255]))
    return np.rint(colors).astype(np.uint8).tobytes()


def _paint_tiles(flow: Flow, size: int) -> NDArray[np.uint8]:
    """Palette indices of the tiling: a stroke for each way, with marks where particles are born or die."""
    speeds = np.array([tile.speed for tile in flow.tiles])
    usual = float(np.median(speeds[flow.cells]))
    faces = np.stack([_paint_tile(tile, usual, size) for tile in flow.tiles])
    height, width = flow.cells.shape
    return faces[flow.cells].transpose(0, 2, 1, 3).reshape(height * size, width * size)


def _paint_tile(tile: Any, usual: float, size: int) -> NDArray[np.uint8]:
    """The face of a tile: fast cells have double strokes, slow ones dotted strokes."""
    down, across = (np.indices((size, size)) + 0.5) / size - 0.5
    covered = np.zeros((size, size))
    for way, along, aside in (("-", across, down), ("|", down, across)):
        if tile.ways not in (way, "+"):
            continue
        if tile.speed > 1.2 * usual:
            line = np.hypot(np.maximum(np.abs(along) - 0.3, 0), np.abs(aside) - 0.11)
        elif tile.speed < usual / 1.2:
            line = np.hypot(along - np.clip(np.rint(along / 0.24), -1, 1) * 0.24, aside)
        else:
            line = np.hypot(np.maximum(np.abs(along) - 0.3, 0), aside)
        covered = np.maximum(covered, np.clip(0.5 + (0.045 - line) * size, 0, 1))
    index = np.rint(covered * _RAMP).astype(np.uint8)
    around = np.hypot(across, down)
    if tile.emits > 0:
        _mark(index, np.clip(0.5 + (0.06 - np.abs(around - 0.26)) * size, 0, 1), 1)
    if tile.kills > 0:
        cross = np.minimum(np.abs(across - down), np.abs(across + down)) / np.sqrt(2)
        _mark(index, np.clip(0.5 + (0.05 - cross) * size, 0, 1) * (around < 0.32), 2)
    return index


def _mark(index: NDArray[np.uint8], covered: NDArray[np.float64], ramp: int) -> None:
    level = np.rint(covered * _RAMP).astype(np.uint8)
    index[level > 0] = ramp * _RAMP + level[level > 0]
