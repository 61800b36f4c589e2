"""A wall as a field: its color, relief and bricks at any pixel of an endless plane."""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_choice, check_type
from tilewright.errors import Progress, TilewrightValueError
from tilewright.fields.bricks.patterns import SIZE, BrickPattern, Bricks, RegionBricks, WangBricks
from tilewright.fields.bricks.relief import MARGIN, light
from tilewright.files.atomic import as_path, whole_folder
from tilewright.files.image_streams import stream_image
from tilewright.files.images import check_writable
from tilewright.signals.bricks.painting import CHANCES, paint
from tilewright.signals.bricks.style import BrickStyle, tint_bricks
from tilewright.tilings import MixerHash, Tiling
from tilewright.tilings.bricks import BrickRegion
from tilewright.tilings.hashes import split_row
from tilewright.tilings.streams import BRICK_CLASSES, BRICK_EDGES, WALL_LAYER

MAPS = ("color", "height", "normal", "roughness", "mortar", "id")
FILES = {
    **{"color": "color.png", "height": "height.png", "normal": "normal_gl.png", "roughness": "roughness.png"},
    **{"mortar": "mortar.png", "id": "id.png", "preview": "preview.png"},
}
"""What `BrickField.save` calls the pictures in a folder."""
_HOLE = {"color": 0, "height": 0, "normal": (128, 128, 255), "roughness": 255, "mortar": 0, "id": -1}
"""What maps show where there is no wall."""
_NOTHING = Bricks(np.array([[0, 0, 8, 8]]), np.zeros((1, 2), np.int64))
"""A brick for windows without any, so that there is something to paint."""
_BLOCK = 2**20
"""Pixels painted at a time, which are few enough for coordinates to be exact in float32."""


class BrickField:
    """A wall of bricks.

    Parameters
    ----------
    pattern : Tiling, BrickRegion or BrickPattern
        A tiling of brick Wang tiles (Kaji et al. 2016, section 4), a region of them, or where bricks lie
        otherwise, such as `BondBricks`.
    style : BrickStyle, optional
        How the wall looks; by default ``BrickStyle()``.
    size : (int, int), optional
        Width and height in pixels of a cell of a tiling; default (144, 48). A pattern has a size of its own.
    seed : int, optional
        How a brick looks depends on its id and this seed only; 0 to 2^64 - 1, default 0.

    Attributes
    ----------
    pattern : BrickPattern
        Where the bricks lie.
    style : BrickStyle
        How the wall looks.
    look : Look
        Mortar, bevel and other lengths in pixels. Heights of 65535 stand ``look.relief`` pixels above 0.
    hash : MixerHash
        Chance for each brick.

    Raises
    ------
    TilewrightTypeError
        A pattern or style of another type.
    TilewrightValueError
        A size beside a pattern that has its own, or a style with too much mortar for bricks of this size.

    Notes
    -----
    Pixel (0, 0) is the north-west pixel of cell (0, 0); x grows east and y grows south.

    Examples
    --------
    >>> import tilewright as tw
    >>> wall = tw.BrickField(tw.endless_brick_tiling(seed=1), tw.BrickStyle("red"), size=(24, 8), seed=1)
    >>> bricks = wall.bricks(x=-100, y=0, width=60, height=40)
    >>> wall.tones(bricks).shape == (len(bricks.ids), 3)
    True
    """

    def __init__(
        self,
        pattern: Tiling | BrickRegion | BrickPattern,
        style: BrickStyle | None = None,
        *,
        size: tuple[int, int] | None = None,
        seed: int = 0,
    ) -> None:
        check_type("style", style, (BrickStyle, type(None)), "a BrickStyle")
        if isinstance(pattern, BrickPattern) and size is not None:
            raise TilewrightValueError("is for tilings; this pattern has a size of its own", argument="size")
        size = SIZE if size is None else size
        if isinstance(pattern, BrickRegion):
            self.pattern: BrickPattern = RegionBricks(pattern, size)
        else:
            self.pattern = pattern if isinstance(pattern, BrickPattern) else WangBricks(pattern, size)
        self.style = style or BrickStyle()
        self.look = self.style.fit(self.pattern.course, self.pattern.thinnest)
        self.hash = MixerHash(seed)

    def render(
        self,
        x: int = 0,
        y: int = 0,
        width: int = 1024,
        height: int = 1024,
        *,
        maps: Sequence[str] = MAPS,
    ) -> dict[str, NDArray[Any]]:
        """Maps of a window of pixels, equal to the same pixels of any other window.

        Parameters
        ----------
        x, y : int
            North-west pixel.
        width, height : int
            Pixels.
        maps : sequence of str
            Which of `MAPS`.

        Returns
        -------
        dict of str to array, shape (height, width, channels)
            ``color`` uint8 sRGB, not lit; ``height`` uint16; ``normal`` uint8, green up, of those heights;
            ``roughness`` uint8; ``mortar`` uint8, 255 where mortar is; ``id`` int64, two channels: who the
            brick is whose part the pixel is, to the middle of the mortar, see `BrickPattern`. In a wall
            with holes, ``color`` has a fourth channel, 0 in holes and 255 elsewhere, and ids are -1 in holes.
        """
        maps = tuple(check_choice("maps", name, MAPS) for name in maps)
        x, y, width, height = self.pattern.check_window(x, y, width, height)
        return self._render(x, y, width, height, maps)

    def preview(self, x: int = 0, y: int = 0, width: int = 1024, height: int = 1024) -> NDArray[np.uint8]:
        """The wall in sunlight from the north-west, uint8 sRGB, shape (height, width, 3).

        A wall with holes has a fourth channel, as in `render`.
        """
        x, y, width, height = self.pattern.check_window(x, y, width, height)
        return self._preview(x, y, width, height)

    def bricks(self, x: int, y: int, width: int, height: int) -> Bricks:
        """Find all bricks that touch a window of pixels.

        Parameters
        ----------
        x, y : int
            North-west pixel of the window.
        width, height : int
            Size of the window in pixels, 1 to 2^31 - 1.

        Returns
        -------
        Bricks
            ``sides``, int64, shape (n, 4): west, north, east and south side of each brick, to the middle of
            the mortar, in pixels from the north-west of the window; ``ids``, int64, shape (n, 2), the same in
            every window.

        Raises
        ------
        TilewrightTypeError
            A number that is not an integer.
        TilewrightValueError
            The window does not lie in the wall.
        """
        return self.pattern.bricks(x, y, width, height)

    def tones(self, bricks: Bricks) -> NDArray[np.uint8]:
        """Tell the mean color of each brick.

        Parameters
        ----------
        bricks : Bricks
            n bricks that `BrickField.bricks` found.

        Returns
        -------
        uint8 array, shape (n, 3)
            Colors in sRGB.
        """
        both = tint_bricks(self.style, self._chances(bricks)[1:6])
        return np.rint(255 * (0.5 * (both[:, :3] + both[:, 3:])).clip(0, 1)).astype(np.uint8)

    def save(
        self,
        path: str | os.PathLike[str],
        x: int = 0,
        y: int = 0,
        width: int = 1024,
        height: int = 1024,
        *,
        map: str = "preview",
        progress: Progress | None = None,
    ) -> None:
        """Write a window to a picture, or all of its maps to a folder, a block at a time.

        Parameters
        ----------
        path : str or Path
            ``.png``, ``.tif``: a picture of ``map``. Without a suffix: a folder of pictures, see `FILES`, in
            which each brick has a color of its own for its id. Both are there whole or not at all.
        map : str
            ``"preview"`` or one of `MAPS`, for a single picture.
        """
        target = as_path(path)
        x, y, width, height = self.pattern.check_window(x, y, width, height)
        if target.suffix:
            check_choice("map", map, ("preview", *MAPS))
            self._stream(target, map, (x, y, width, height), progress)
            return
        with whole_folder(target, _object) as folder:
            for name, file in FILES.items():
                self._stream(folder / file, name, (x, y, width, height), progress)

    def _stream(
        self, path: Path, name: str, window: tuple[int, int, int, int], progress: Progress | None
    ) -> None:
        x, y, width, height = window
        sample = self._picture(name, x, y, 1, 1)
        check_writable(path, sample.dtype)

        def block(left: int, top: int, columns: int, rows: int) -> NDArray[Any]:
            if progress is not None:
                progress(top, height, f"painting {path.name}")
            return self._picture(name, x + left, y + top, columns, rows)

        stream_image(path, block, height, width, sample.shape[2], sample.dtype)
        if progress is not None:
            progress(height, height, f"painting {path.name}")

    def _picture(self, name: str, x: int, y: int, width: int, height: int) -> NDArray[Any]:
        if name == "preview":
            return self._preview(x, y, width, height)
        if name == "id":
            index, found = self.pattern.locate(x, y, width, height)
            colors = np.zeros((len(found.ids) + 1, 3), np.uint8)  # the last is that of holes, -1
            colors[:-1] = self._chances(found)[:3].T * 256
            return colors[index]
        return self._render(x, y, width, height, (name,))[name]

    def _preview(self, x: int, y: int, width: int, height: int) -> NDArray[np.uint8]:
        around = self._render(
            x - MARGIN, y - MARGIN, width + 2 * MARGIN, height + 2 * MARGIN, ("color", "height", "normal")
        )
        return light(around, self.look.relief)

    def _render(
        self, x: int, y: int, width: int, height: int, maps: Sequence[str]
    ) -> dict[str, NDArray[Any]]:
        """Painted in blocks: of rows, or of parts of rows where these are long."""
        columns = min(width, _BLOCK // 16)
        rows = max(16, _BLOCK // columns)
        out: dict[str, NDArray[Any]] = {}
        for top in range(0, height, rows):
            for left in range(0, width, columns):
                block = slice(top, min(top + rows, height)), slice(left, min(left + columns, width))
                painted = self._paint(x + left, y + top, block[1].stop - left, block[0].stop - top, maps)
                for name, pixels in painted.items():
                    if name not in out:
                        out[name] = np.empty((height, width, pixels.shape[2]), pixels.dtype)
                    out[name][block] = pixels
        return out

    def _paint(self, x: int, y: int, width: int, height: int, maps: Sequence[str]) -> dict[str, NDArray[Any]]:
        """A block, from the bricks of its pixels and one more around it, which normals need."""
        x, y = x - 1, y - 1
        index, found = self.pattern._locate(x, y, width + 2, height + 2)
        units = x // self.pattern.unit[0], y // self.pattern.unit[1]
        start = x % self.pattern.unit[0], y % self.pattern.unit[1]

        def words(octave: int, points: tuple[int, int], at: tuple[int, int, int, int]) -> NDArray[np.uint32]:
            return self._words(octave, points, units, at)

        if not len(found.ids):
            found = _NOTHING
        painted: dict[str, NDArray[Any]] = {}
        if set(maps) - {"id"}:
            chances = self._chances(found)
            painted = paint(
                index.clip(0), found.sides, chances, words, self.style, self.look, self.pattern.unit, start
            )
        if "id" in maps:
            painted["id"] = found.ids[index[1:-1, 1:-1]]
        covered = self.pattern.covers(x + 1, y + 1, width, height)
        return {name: _cut(name, painted[name], covered) for name in maps}

    def _chances(self, found: Bricks) -> NDArray[np.float64]:
        """Numbers of [0, 1) for each brick, shape (CHANCES, n)."""
        layers = WALL_LAYER + np.arange(CHANCES)[:, np.newaxis]
        return self.hash.words(BRICK_CLASSES, found.ids[:, 0], found.ids[:, 1], layers) / 2.0**32

    def _words(
        self,
        octave: int,
        points: tuple[int, int],
        units: tuple[int, int],
        at: tuple[int, int, int, int],
    ) -> NDArray[np.uint32]:
        """Lattice words of the plane, which repeat as the wall does."""
        from tilewright.kernels.brick_drawing import fill_lattice_words

        x, y = (
            _lattice_axis(units[a], points[a], at[a], at[a + 2], self.pattern.domain.periods[a])
            for a in (0, 1)
        )
        out = np.empty((len(y), len(x)), np.uint32)
        fill_lattice_words(*split_row(x), y, WALL_LAYER + octave, BRICK_EDGES, self.hash.seed, out)
        return out


def _cut(name: str, pixels: NDArray[Any], covered: NDArray[np.bool_] | None) -> NDArray[Any]:
    """A map with holes."""
    if covered is None:
        return pixels
    pixels = np.where(covered[..., np.newaxis], pixels, np.array(_HOLE[name], pixels.dtype))
    if name == "color":
        pixels = np.concatenate([pixels, covered[..., np.newaxis] * np.uint8(255)], axis=2)
    return pixels


def _lattice_axis(unit: int, points: int, first: int, count: int, period: int | None) -> NDArray[np.int64]:
    """Lattice coordinates; without a period modulo 2^64, as far units have more points than int64 holds."""
    if period is not None:
        return (unit % period * points + first + np.arange(count, dtype=np.int64)) % (period * points)
    start = (unit * points + first + 2**63) % 2**64 - 2**63
    return np.int64(start) + np.arange(count, dtype=np.int64)


def _object(folder: Path) -> str:
    """Why a folder must not be replaced by maps of a wall; nothing where it may."""
    others = sorted(entry.name for entry in folder.iterdir() if entry.name not in FILES.values())
    return f"holds {others[0]}, which is no map of a wall" if others else ""
