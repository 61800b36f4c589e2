"""Which of the pictures of a TIFF file is read, and what the file states of its channels.

TIFF 6.0, sections 8 and 18; Adobe DNG specification 1.7, chapter 4.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

_REDUCED, _MASK = 1, 4
_RAW_PHOTOMETRICS = (32803, 34892)
"""A mosaic of filters, and linear light of a sensor."""
_DNG_VERSION = 50706
_PALETTE, _LAB, _OTHER_LABS = 3, 8, (9, 10)
_LOG = (32844, 32845)
_UNSPECIFIED, _ASSOCIATED, _STRAIGHT = 0, 1, 2


@dataclass(frozen=True)
class TiffPages:
    """What the directories of a TIFF file say.

    Attributes
    ----------
    is_raw : bool
        A camera's raw file.
    page : int or None
        The first picture in full size; None where there are only smaller ones.
    others : int
        How many further full pictures there are.
    color_channels : int
        Channels of gray or color of that picture.
    extra : tuple of int
        What its further channels are, by ExtraSamples.
    photometric : int
        How its colors are written.
    bits : int
        Bits of a channel.
    """

    is_raw: bool = False
    page: int | None = 0
    others: int = 0
    color_channels: int = 0
    extra: tuple[int, ...] = ()
    photometric: int = 0
    bits: int = 8

    @property
    def is_lab(self) -> bool:
        """CIE L*a*b*, as Pillow reads it."""
        return self.photometric == _LAB and self.bits == 8

    @property
    def is_palette(self) -> bool:
        """Numbers of colors in a table."""
        return self.photometric == _PALETTE and self.bits <= 8

    @property
    def refused_colors(self) -> str:
        """The name of a way to write colors that is not read; empty where it is."""
        if self.photometric in _OTHER_LABS or (self.photometric == _LAB and self.bits != 8):
            return f"{self.bits}-bit L*a*b*"
        return "logarithmic LUV" if self.photometric in _LOG else ""

    @property
    def associated(self) -> bool:
        """Whether alpha is multiplied in."""
        return self.extra[:1] == (_ASSOCIATED,)

    @property
    def has_alpha(self) -> bool:
        """Whether the first further channel is alpha."""
        return self.extra[:1] in ((_ASSOCIATED,), (_STRAIGHT,))


def read_pages(path: Path) -> TiffPages | None:
    """What a TIFF file says of its pictures; None where its directories cannot be read."""
    import tifffile

    log = tifffile.logger()
    disabled, log.disabled = log.disabled, True  # what is damaged is said once, by the decoder
    try:
        with tifffile.TiffFile(path) as file:
            return _describe([page.aspage() for page in file.pages])
    except Exception:  # whatever a damaged directory makes of tifffile
        return None
    finally:
        log.disabled = disabled


def _describe(pages: list[Any]) -> TiffPages | None:
    if not pages:
        return None
    everything = [*pages, *(inner for page in pages for inner in (page.pages or ()))]
    inner = [page.aspage() for page in everything]
    if any(int(p.photometric) in _RAW_PHOTOMETRICS or _DNG_VERSION in p.tags for p in inner):
        return TiffPages(is_raw=True)
    full = [number for number, page in enumerate(pages) if not page.subfiletype & (_REDUCED | _MASK)]
    if not full:
        return TiffPages(page=None)
    page = pages[full[0]]
    extra = tuple(int(kind) for kind in page.extrasamples)
    return TiffPages(
        page=full[0],
        others=len(full) - 1,
        color_channels=page.samplesperpixel - len(extra),
        extra=extra,
        photometric=int(page.photometric),
        bits=page.bitspersample,
    )
