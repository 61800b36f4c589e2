"""A wall as a field: its color, relief and bricks at any pixel of an endless plane."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_type
from tilewright.errors import Progress, TilewrightValueError
from tilewright.fields.bricks.patterns import SIZE, BrickPattern, Bricks, RegionBricks, WangBricks
from tilewright.fields.bricks.relief import MARGIN, light
from tilewright.fields.plane import PixelField
from tilewright.fields.windows import PixelMap, PixelWindow
from tilewright.files.atomic import AnyPath, as_path, whole_folder
from tilewright.signals.bricks.painting import CHANCES, paint
from tilewright.signals.bricks.style import BrickStyle, tint_bricks
from tilewright.tilings import Domain, MixerHash, Tiling
from tilewright.tilings.bricks import BrickRegion
from tilewright.tilings.hashes import split_row
from tilewright.tilings.streams import BRICK_CLASSES, BRICK_EDGES, WALL_LAYER

MAPS = ("color", "height", "normal", "roughness", "mortar", "id")
"""The maps that a wall is painted with; two more are pictures of them, see `BrickField`."""
_FORMS = {
    "preview": PixelMap(np.dtype(np.uint8), 3, "color"),
    "color": PixelMap(np.dtype(np.uint8), 3, "color"),
    "height": PixelMap(np.dtype(np.uint16), 1, "height"),
    "normal": PixelMap(np.dtype(np.uint8), 3, "normal-gl"),
    "roughness": PixelMap(np.dtype(np.uint8), 1, "roughness"),
    "mortar": PixelMap(np.dtype(np.uint8), 1, "data"),
    "id": PixelMap(np.dtype(np.int64), 2, "data"),
    "id-color": PixelMap(np.dtype(np.uint8), 3, "data"),
}
_CUT = ("preview", "color")
"""Maps that have a channel more in walls with holes."""
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


class BrickField(PixelField):
    """A wall of bricks.

    Its maps are ``preview``, uint8, the wall in sunlight from the north-west; ``color``, uint8 sRGB, not lit;
    ``height``, uint16; ``normal``, uint8, green up, of those heights; ``roughness``, uint8;
    ``mortar``, uint8, 255 where mortar is; ``id``, int64, two channels: who the brick is whose part the pixel
    is, to the middle of the mortar, see `BrickPattern`; and ``id-color``, uint8, a color of its own for every
    brick, 0 in holes. In a wall with holes, ``preview`` and ``color`` have a fourth channel, 0 in holes and
    255 elsewhere, and ids are -1 in holes.

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
        self.reach = self.pattern.reach
        x, y = (0 if bound is None else bound[0] for bound in self.domain.bounds)
        self._has_holes = self.pattern.covers(x, y, 1, 1) is not None

    @property
    def domain(self) -> Domain:
        """Where there are pixels, and after how many of them they repeat, x first."""
        return self.pattern.pixels

    @property
    def maps(self) -> dict[str, PixelMap]:
        """The type, channels and kind of every map; the first is the main one."""
        more = _CUT if self._has_holes else ()
        return _FORMS | {name: _FORMS[name]._replace(channels=4) for name in more}

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
        path: AnyPath,
        x: int = 0,
        y: int = 0,
        width: int = 1024,
        height: int = 1024,
        *,
        map: str | None = None,
        scale: float = 1.0,
        progress: Progress | None = None,
    ) -> None:
        """Write a window to a picture, or all of its maps to a folder, a block at a time.

        Parameters
        ----------
        path : str or path-like
            ``.png``, ``.tif``: a picture of ``map``. Without a suffix: a folder of pictures, see `FILES`.
            Both are there whole or not at all.
        x, y : int, optional
            North-west pixel of the window; default (0, 0).
        width, height : int, optional
            Size of the window in pixels, 1 to 2^31 - 1; default 1024 each.
        map : str, optional
            For a single picture; by default ``"preview"``. Of ``"id"`` the colors are written.
        scale : float, optional
            Pixels of the picture for each of the window, as for `render`; default 1.
        progress : callable, optional
            Called as ``progress(done, total, what)``, counted in rows of each picture; raise `Cancelled` in
            it to stop.

        Raises
        ------
        TilewrightTypeError
            A number that is not an integer, something else than a path, or a map that files of this suffix
            do not hold.
        TilewrightValueError
            A window that does not lie in the wall, an unknown map, or another suffix.
        TilewrightFileError
            The files cannot be written, or the folder holds something else.
        """
        target = as_path(path)
        if target.suffix:
            super().save(target, x, y, width, height, map=map, scale=scale, progress=progress)
            return
        window = self._window(x, y, width, height)
        with whole_folder(target, _object) as folder:
            for name, file in FILES.items():
                super().save(folder / file, *window, map=name, scale=scale, progress=progress)

    @property
    def _usual(self) -> list[str]:
        return list(MAPS)

    def _pictured(self, map: str) -> str:
        return "id-color" if map == "id" else map

    def _paint(self, window: PixelWindow, outs: Mapping[str, NDArray[Any]]) -> None:
        pictures = {"preview": self._light, "id-color": self._color_ids}
        maps = {name: out for name, out in outs.items() if name not in pictures}
        if maps:
            self._paint_maps(window, maps)
        for name in outs.keys() & pictures:
            pictures[name](window, outs[name])

    def _light(self, window: PixelWindow, out: NDArray[Any]) -> None:
        """The wall in sunlight, with the shadows that bricks around the window throw into it."""
        around = window.grow(MARGIN)
        maps = {name: self._make_out(around, name) for name in ("color", "height", "normal")}
        self._paint_maps(around, maps)
        out[...] = light(maps, self.look.relief)

    def _color_ids(self, window: PixelWindow, out: NDArray[Any]) -> None:
        index, found = self.pattern.locate(*window)
        colors = np.zeros((len(found.ids) + 1, 3), np.uint8)  # the last is that of holes, -1
        colors[:-1] = self._chances(found)[:3].T * 256
        out[...] = colors[index]

    def _paint_maps(self, window: PixelWindow, outs: Mapping[str, NDArray[Any]]) -> None:
        """Painted in blocks: of rows, or of parts of rows where these are long."""
        columns = min(window.width, _BLOCK // 16)
        for piece, at in window.split(columns, max(16, _BLOCK // columns)):
            for name, pixels in self._paint_block(piece, tuple(outs)).items():
                outs[name][at] = pixels

    def _paint_block(self, window: PixelWindow, maps: Sequence[str]) -> dict[str, NDArray[Any]]:
        """A block, from the bricks of its pixels and one more around it, which normals need."""
        x, y, width, height = window.grow(1)
        index, found = self.pattern._locate(x, y, width, height)
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
        covered = self.pattern.covers(*window)
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
