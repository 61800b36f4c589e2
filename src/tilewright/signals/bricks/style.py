"""How a wall looks: colors, mortar, edges, and how much its bricks differ."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import check_int, check_real, range_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.pixels import read_hex

Color = tuple[int, int, int]

PALETTES = {
    "red": ("975646 a36250 8a4a3f ad705b 79443d 935e50 6c423e", "aea89d"),
    "yellow": ("be9e6c b08f60 cbae7e a0805a b89670 8e7456 c4a684", "b6b0a2"),
    "sandstone": ("bca684 b09876 c8b496 a68c6c b69c7c c2aa86 9e886e", "a69c8a"),
    "gray": ("848482 767878 94928c 686a6c 8a847c 7c8084 606060", "a4a098"),
}
"""Colors of bricks, and of the mortar between them, in sRGB."""
FINISH = {
    # Heights, as shares of the relief. Noise of edges, stains and sand is about -1 to 1.
    "ragged": 0.35,  # how much sand adds to the wobble of edges
    "joint": 0.30,  # mean height of mortar
    "joint_edge": 0.10,  # how uneven it is: its long waves
    "joint_sand": 0.16,  # and its sand
    "joint_hollow": 0.12,  # how much deeper it is in the middle between two bricks
    "pit_slope": 3.0,  # pits are where sand is high: 1 / width of the change, in units of the noise,
    "pit_onset": 1.65,  # and where it begins, times the slope: from sand of 0.55 on
    "pit_depth": 0.16,
    "face_sand": 0.07,  # how sandy the face of a brick is
    "face_stain": 0.05,  # how wavy it is
    "rim": 0.50,  # height of a brick at its edge
    "rim_edge": 0.10,  # how uneven that is
    # Colors: stains run from one color of the clay to the other.
    "stain_middle": 0.5,  # share of the second color where the noise is 0
    "stain_contrast": 0.9,  # how fast the colors change
    # Mortar smeared over edges.
    "smear_sand": 0.5,  # how ragged its border is
    "smear_onset": 0.05,  # the greater, the less is smeared
    "smear_reach": 0.45,  # how fast it ends, away from the edge, for each bevel
    "smear_slope": 1.6,  # how sharp its border is
    # Shades, as factors of the color.
    "clay_sand": 0.14,
    "clay_speck": 0.05,  # grain of single pixels
    "clay_pit": 0.35,  # how dark pits are
    "clay_rim": 0.9,  # at the edge of a brick
    "clay_rise": 0.1,  # and how much lighter on its face
    "lime": 0.80,  # mortar, at the brick
    "lime_sand": 0.20,
    "lime_stain": 0.10,
    "lime_speck": 0.08,
    "lime_hollow": 0.20,  # how much lighter in the middle between bricks
    "rough_sand": 0.06,  # how much sand changes the roughness of bricks
}
"""The look of the surfaces of bricks and mortar: what noise does to heights, colors and roughness."""
_MOST_PIXELS = 1024


@dataclass(frozen=True)
class BrickStyle:
    """How a wall of bricks looks.

    Parameters
    ----------
    colors : str or sequence of (red, green, blue), optional
        ``"red"`` (default), ``"yellow"``, ``"sandstone"`` or ``"gray"``, or colors of your own: a text such
        as ``"#aa3333,#884422"``, or whole numbers 0 to 255 in sRGB; each brick gets one of them or a mixture
        of two.
    mortar_color : (red, green, blue) or None, optional
        Whole numbers 0 to 255 in sRGB; by default the palette's own.
    mortar : int or None, optional
        Width of the mortar between bricks in pixels, 1 to 1,024; by default an eighth of a course, less where
        bricks are thin.
    bevel : float or None, optional
        Pixels over which a brick rises from its edge to its face, 0 to 1,024; by default 0.8 times the
        mortar.
    relief : float or None, optional
        Pixels from the deepest to the highest place that a height map can tell, 0 to 1,024; by default as
        deep as the mortar is wide.
    variation : float, optional
        How much bricks differ in color, height and tilt, 0 to 1; default 1.
    wear : float, optional
        How uneven edges are and how much mortar is smeared over them, 0 to 1; default 1.
    grain : float, optional
        How sandy the surfaces of brick and mortar are, 0 to 1; default 1.

    Raises
    ------
    TilewrightTypeError
        A color that is not three whole numbers, or another setting that is no number.
    TilewrightValueError
        An unknown palette, or a number out of range.

    Examples
    --------
    >>> import tilewright as tw
    >>> style = tw.BrickStyle("sandstone", wear=0.2)
    >>> style.palette.shape
    (7, 3)
    """

    colors: str | Sequence[Color] = "red"
    mortar_color: Color | None = None
    mortar: int | None = None
    bevel: float | None = None
    relief: float | None = None
    variation: float = 1.0
    wear: float = 1.0
    grain: float = 1.0

    def __post_init__(self) -> None:
        if isinstance(self.colors, str) and self.colors.startswith("#"):
            named = (read_hex(word.strip()) for word in self.colors.split(","))
            object.__setattr__(self, "colors", tuple(named))
        elif isinstance(self.colors, str):
            if self.colors not in PALETTES:
                allowed = f"{', '.join(PALETTES)}, or colors as '#aa3333,#884422'"
                raise TilewrightValueError(argument="colors", value=self.colors, allowed=allowed)
        else:
            object.__setattr__(self, "colors", _check_colors("colors", self.colors))
        if self.mortar_color is not None:
            object.__setattr__(self, "mortar_color", _check_colors("mortar_color", (self.mortar_color,))[0])
        if self.mortar is not None:
            check_int("mortar", self.mortar, 1, _MOST_PIXELS)
        for name in ("bevel", "relief"):
            if getattr(self, name) is not None:
                check_real(name, getattr(self, name), 0, _MOST_PIXELS)
        for name in ("variation", "wear", "grain"):
            check_real(name, getattr(self, name), 0, 1)

    @property
    def palette(self) -> NDArray[np.float64]:
        """Colors of bricks, float64, shape (n, 3), sRGB from 0 to 1."""
        colors = _read(PALETTES[self.colors][0]) if isinstance(self.colors, str) else self.colors
        return np.array(colors, np.float64) / 255

    @property
    def lime(self) -> NDArray[np.float64]:
        """The color of mortar, float64, shape (3,), sRGB from 0 to 1."""
        usual = PALETTES[self.colors if isinstance(self.colors, str) else "red"][1]
        return np.array(self.mortar_color or _read(usual)[0], np.float64) / 255

    def fit(self, course: int, thinnest: int) -> "Look":
        """Find the lengths of the style for bricks of a certain size.

        Parameters
        ----------
        course : int
            Usual height of a brick in pixels, with half the mortar around it.
        thinnest : int
            The least width or height of any brick in pixels, with half the mortar around it.

        Returns
        -------
        Look
            Widths of mortar, bevel and other lengths in pixels.

        Raises
        ------
        TilewrightValueError
            The thinnest brick would vanish in the mortar.
        """
        mortar = self.mortar or max(1, min(round(course / 8), round(thinnest / 4)))
        if mortar + 2 > thinnest:
            raise TilewrightValueError(
                f"is {mortar} pixels, and the thinnest brick {thinnest} with half of it on either side; "
                f"allowed are up to {max(thinnest - 2, 0)}: or take a larger size, or fewer positions",
                argument="mortar",
                value=mortar,
                allowed=f"up to {max(thinnest - 2, 0)}",
            )
        room = (thinnest - mortar) / 2
        bevel = min(0.8 * mortar if self.bevel is None else float(self.bevel), room)
        return Look(
            mortar=mortar,
            bevel=max(bevel, 0.5),
            rounding=min(0.65 * mortar, room),
            wobble=self.wear * max(0.0, min(0.27 * mortar, mortar / 3.2 - 0.3)),
            relief=float(mortar) if self.relief is None else float(self.relief),
        )


@dataclass(frozen=True)
class Look:
    """Lengths of a style in pixels, for bricks of a certain size.

    Attributes
    ----------
    mortar : whole pixels between bricks.
    bevel, rounding : of the edges and corners of bricks.
    wobble : how far edges leave their line.
    relief : from the lowest to the highest height, 0 to 1.
    """

    mortar: int
    bevel: float
    rounding: float
    wobble: float
    relief: float

    @property
    def insets(self) -> NDArray[np.int64]:
        """From the sides of a brick with half the mortar around it to its own: whole pixels."""
        half = self.mortar // 2
        return np.array([half, half, half - self.mortar, half - self.mortar])


def tint_bricks(style: BrickStyle, chances: NDArray[np.float64]) -> NDArray[np.float64]:
    """Two colors for each brick, between which its stains run; chances : (5, n), 0 to 1. Shape (n, 6)."""
    palette = style.palette
    first, second, third, amount, light = chances
    mean = palette.mean(axis=0)
    mixed = mean + style.variation * (
        _blend(_pick(palette, first), _pick(palette, second), 0.6 * amount) - mean
    )
    stained = _blend(mixed, mean + style.variation * (_pick(palette, third) - mean), 0.35)
    bright = 1 + 0.2 * style.variation * (2 * light - 1)[:, np.newaxis]
    return np.concatenate([mixed * bright, 0.86 * stained * bright], axis=1)


def _read(written: str) -> list[Color]:
    """Colors written in hexadecimal digits."""
    return [read_hex(f"#{word}") for word in written.split()]


def _pick(palette: NDArray[np.float64], chance: NDArray[np.float64]) -> NDArray[np.float64]:
    return palette[np.minimum((chance * len(palette)).astype(int), len(palette) - 1)]


def _blend(
    one: NDArray[np.float64], other: NDArray[np.float64], amount: NDArray[np.float64] | float
) -> NDArray[np.float64]:
    share = np.broadcast_to(amount, len(one))[:, np.newaxis]
    return one + share * (other - one)


def _check_colors(name: str, given: Any) -> tuple[Color, ...]:
    """Colors as tuples of whole numbers."""
    try:
        colors = np.asarray(given)
    except ValueError:
        colors = np.empty(0, object)
    if colors.ndim != 2 or colors.shape[1] != 3 or not len(colors) or colors.dtype.kind not in "iu":
        raise TilewrightTypeError(
            f"must hold whole numbers (red, green, blue), not {given!r}",
            argument=name,
            value=given,
            allowed="whole numbers (red, green, blue)",
        )
    if colors.min() < 0 or colors.max() > 255:
        raise range_error(name, colors, "0 to 255")
    return tuple((int(red), int(green), int(blue)) for red, green, blue in colors)
