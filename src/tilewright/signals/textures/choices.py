"""What a person may ask of a synthesis, checked: a size, places of patches, and what it will cost."""

import warnings
from collections.abc import Mapping, Sequence

import numpy as np

from tilewright.checks import check_int, type_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError, TilewrightWarning
from tilewright.signals.textures.recipe import Spot
from tilewright.signals.textures.regularity import Regularity, misfit_of_size, suited_tile_size
from tilewright.signals.textures.sheet import Sheet
from tilewright.signals.textures.treatment import LARGEST_TILE, SMALLEST_TILE

MOST_PIXELS = 2**28
"""Of all tiles together: about 5 GB of memory while they are made."""
_SECONDS = 0.15
"""What a tile of 128 x 128 pixels takes on two cores."""
_DRAFTED = 0.35
"""Share of that for tiles whose places are found at a smaller scale."""


def check_choices(
    pick: Mapping[str, Spot] | None, reject: Mapping[str, Sequence[Spot]] | None
) -> tuple[Mapping[str, Spot], Mapping[str, Sequence[Spot]]]:
    """An artist's choices, well formed."""
    for what, given in (("pick", pick), ("reject", reject)):
        if given is not None and not isinstance(given, Mapping):
            raise type_error(what, given, "a dict by patch name")
    pick, reject = pick or {}, reject or {}
    spots = [(f"pick[{name!r}]", spot) for name, spot in pick.items()]
    for name, rejected in reject.items():
        if not isinstance(rejected, (list, tuple)):
            raise type_error(f"reject[{name!r}]", rejected, "a list of (source, y, x)")
        spots += [(f"reject[{name!r}]", spot) for spot in rejected]
    for what, spot in spots:
        if not isinstance(spot, (list, tuple)) or len(spot) != 3:
            raise TilewrightTypeError(
                f"must hold (source, y, x), not {spot!r}", argument=what, value=spot, allowed="(source, y, x)"
            )
    return pick, reject


def check_size(given: int | str | None) -> int | None:
    """A tile size, None where it is to be found."""
    if given is None or (isinstance(given, str) and given == "auto"):
        return None
    size = check_int("tile_size", given, SMALLEST_TILE, LARGEST_TILE)
    if size % 2:
        raise TilewrightValueError(
            f"is {size}; it must be even, for example {size + 1}",
            argument="tile_size",
            value=size,
            allowed=f"even, for example {size + 1}",
        )
    return size


def warn_of_clone(regularity: Regularity) -> None:
    """Say where the photograph holds itself twice."""
    if regularity.clone is not None:
        y, x = regularity.clone
        warnings.warn(
            f"the exemplar shows itself again {x} pixels to the right and {y} down (made seamless by "
            "offset?); crop it to one copy, or twins will be visible",
            TilewrightWarning,
            stacklevel=3,
        )


def warn_of_misfit(regularity: Regularity, size: int) -> None:
    """Say where tiles of a size are off the photograph's period."""
    off = misfit_of_size(regularity, size)
    if off > 2:
        better = suited_tile_size(regularity, size)
        warnings.warn(
            f"the exemplar repeats every {_periods(regularity)} pixels and tile_size {size} is {off:.0f} "
            f"pixels off; {better} fits",
            TilewrightWarning,
            stacklevel=3,
        )


def expected_seconds(count: int, size: int, drafted: bool) -> float:
    """About how long so many tiles of a size take on two cores."""
    return count * _SECONDS * (size / 128) ** 2 * (_DRAFTED if drafted and size > 128 else 1)


def check_cost(count: int, size: int, drafted: bool) -> None:
    """Refuse what cannot be held, and say what will take long."""
    if count * size * size > MOST_PIXELS:
        raise TilewrightValueError(
            f"{count} tiles of {size} x {size} pixels are {count * size * size} pixels; allowed are "
            f"{MOST_PIXELS}: choose fewer colors or a smaller tile size"
        )
    minutes = expected_seconds(count, size, drafted) / 60
    if minutes > 2:
        warnings.warn(
            f"{count} tiles of {size} x {size} pixels take about {minutes:.0f} minutes on two cores",
            TilewrightWarning,
            stacklevel=3,
        )


def _periods(regularity: Regularity) -> str:
    y, x = (f"{p:.1f}" if p else "-" for p in regularity.period)
    return f"{x} x {y}"


def to_sheet(sheet: Sheet, name: str, spot: Spot) -> tuple[int, int]:
    """Where a spot lies on the sheet."""
    source, y, x = (check_int(f"place of {name}", v, -(2**16), 2**16) for v in spot)
    check_int(f"source of {name}", source, 0, len(sheet.tops) - 1)
    return sheet.tops[source] + y, x


def to_source(sheet: Sheet, place: tuple[int, int]) -> Spot:
    """The spot at a place of the sheet."""
    source = int(np.searchsorted(np.array(sheet.tops), place[0], side="right")) - 1
    return source, int(place[0]) - sheet.tops[source], int(place[1])
