"""Pictures after each other as MP4: H.264 that every player shows, by the ffmpeg of imageio-ffmpeg."""

import subprocess
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import TilewrightFileError
from tilewright.extras import need_package

_QUALITY = 18
"""Constant rate factor of x264: differences are hardly seen."""
_THREADS = 4
"""Always as many, since x264 writes other bytes with other numbers of them."""


def check_videos() -> None:
    """Refuse to begin where ffmpeg is missing."""
    need_package("imageio_ffmpeg", "an MP4")


def write_video(path: Path, frames: Iterator[NDArray[np.uint8]], size: tuple[int, int], rate: int) -> None:
    """Write frames of (height, width, 3) and of a size, sRGB, at a rate per second.

    Sides that are odd grow by a pixel, since H.264 halves the colors along both.
    """
    import imageio_ffmpeg

    height, width = size
    even = "pad=ceil(iw/2)*2:ceil(ih/2)*2:0:0:black,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
    words = [
        imageio_ffmpeg.get_ffmpeg_exe(), "-y", "-loglevel", "error",
        "-f", "rawvideo", "-pix_fmt", "rgb24", "-s", f"{width}x{height}", "-r", str(rate), "-i", "-",
        "-vf", even, "-c:v", "libx264", "-crf", str(_QUALITY), "-preset", "medium",
        "-threads", str(_THREADS), "-x264-params", "colorprim=bt709:transfer=bt709:colormatrix=bt709",
        "-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact", "-movflags", "+faststart",
        "-f", "mp4", str(path),
    ]  # fmt: skip
    with subprocess.Popen(words, stdin=subprocess.PIPE, stderr=subprocess.PIPE) as program:
        assert program.stdin is not None
        assert program.stderr is not None
        try:
            for frame in frames:
                program.stdin.write(np.ascontiguousarray(frame).tobytes())
        except BrokenPipeError:
            pass  # it says why, below
        except BaseException:
            program.kill()
            raise
        with suppress(BrokenPipeError):
            program.stdin.close()
        said = program.stderr.read().decode(errors="replace").split("\n")
    if program.returncode:
        raise TilewrightFileError(f"{path} could not be written: ffmpeg says: {said[0]}", value=path)
