"""Pixels as a file holds them, and what it states of them."""

from dataclasses import dataclass, field, replace
from typing import Any

from numpy.typing import NDArray

from tilewright.files.decoding.alpha import glows, to_straight
from tilewright.files.decoding.color_profiles import ProfileError, convert_profile
from tilewright.files.decoding.rgb_spaces import RgbSpace

PICTURE_CHANNELS = {1: ("Y",), 2: ("Y", "A"), 3: ("R", "G", "B"), 4: ("R", "G", "B", "A")}
"""Names of the channels of pictures, by how many there are."""


@dataclass(frozen=True)
class Decoded:
    """What came out of a file.

    Attributes
    ----------
    pixels : array, shape (height, width, channels)
        The numbers of the file.
    channels : tuple of str
        What each channel is: ``Y``, ``R``, ``G``, ``B``, ``A``, or another name.
    associated : bool
        Alpha is multiplied in.
    profile : bytes
        The ICC profile; empty where there is none.
    space : RgbSpace or None
        The color space, where the file states one otherwise.
    unheeded : str
        What it states of the colors that is not known here.
    orientation : int
        Which sides row 0 and column 0 show, as Exif has it, 1 to 8.
    notes : tuple of str
        What the file states and is not heeded.
    """

    pixels: NDArray[Any]
    channels: tuple[str, ...]
    associated: bool = False
    profile: bytes = b""
    space: RgbSpace | None = None
    unheeded: str = ""
    orientation: int = 1
    notes: tuple[str, ...] = field(default=())

    def noting(self, *notes: str) -> "Decoded":
        """The same with further notes."""
        return replace(self, notes=(*self.notes, *(note for note in notes if note)))

    def as_picture(self) -> "Decoded":
        """The same as a picture of light in sRGB (floats: linear) with straight alpha, or none."""
        return self._without_others()._with_straight_alpha()._in_srgb()

    @property
    def is_picture(self) -> bool:
        """Whether the channels are gray or color, and alpha."""
        return PICTURE_CHANNELS.get(len(self.channels)) == self.channels

    def _without_others(self) -> "Decoded":
        """The channels of a picture, without those that are neither color nor alpha."""
        if self.is_picture:
            return self
        fitting = [names for names in PICTURE_CHANNELS.values() if set(names) <= set(self.channels)]
        if not fitting:
            return self
        kept = max(fitting, key=len)
        places = [self.channels.index(name) for name in kept]
        left = [name for place, name in enumerate(self.channels) if place not in places]
        some = left[:5] + ["..."] * (len(left) > 5)
        return replace(self, pixels=self.pixels[..., places], channels=kept).noting(
            f"neither color nor alpha is in {'channel' if len(left) == 1 else 'channels'} {', '.join(some)}, "
            "which this picture does without"
        )

    def _with_straight_alpha(self) -> "Decoded":
        if not self.associated or self.channels[-1] != "A":
            return self
        note = "gives light where its alpha is 0, which stays as it is" if glows(self.pixels) else ""
        return replace(self, pixels=to_straight(self.pixels), associated=False).noting(note)

    def _in_srgb(self) -> "Decoded":
        alpha = len(self.channels) in (2, 4)
        colors = self.pixels[..., :-1] if alpha else self.pixels
        try:
            shown, done = self._convert(colors)
        except ProfileError as error:
            return self._taken_plainly(str(error))
        if self.unheeded:
            return self._taken_plainly(self.unheeded)
        if not done:
            return self
        pixels = self.pixels.copy() if alpha else shown
        if alpha:
            pixels[..., :-1] = shown
        return replace(self, pixels=pixels).noting(f"its colors were converted from {done}")

    def _taken_plainly(self, reason: str) -> "Decoded":
        return self.noting(f"{reason}; its numbers are taken as {self._plain}")

    @property
    def _plain(self) -> str:
        return "linear light of sRGB" if self.pixels.dtype.kind == "f" else "sRGB"

    def _convert(self, colors: NDArray[Any]) -> tuple[NDArray[Any], str]:
        """Colors in sRGB, and what was done, empty where nothing."""
        if self.profile:
            return convert_profile(colors, self.profile)
        if self.space is None or (self.space.is_linear if colors.dtype.kind == "f" else self.space.is_srgb):
            return colors, ""
        return self.space.to_srgb(colors), f"{self.space.name} to {self._plain}"
