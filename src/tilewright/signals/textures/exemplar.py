"""What a texture is made from: photographs, their maps, and what may be copied from them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.checks import as_array, check_choice, check_real, shape_error, type_error
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.pixels import as_pixels, as_texels
from tilewright.showing import describe
from tilewright.signals.textures.kinds import KINDS, guess_kind, is_normal
from tilewright.signals.textures.naming import check_map_names

Maps = dict[str, NDArray[Any]]

SMALLEST_SIDE = 32
LARGEST_SIDE = 32768
LARGEST_VALUE = 1e12
"""Of float maps: what still has a square and a variance in float32."""
WEIGHTS = {kind: 1.0 if kind == "color" else 0.1 for kind in KINDS}
"""What a map of each kind counts: cuts are seen in color first, and are closed in normals and heights."""


@dataclass(frozen=True, eq=False)
class Exemplar:
    """One or more photographs that share a list of maps: what a texture is made from.

    Parameters
    ----------
    sources : sequence of dict of str to array, shape (h, w, channels) or (h, w)
        The maps of each source: uint8, uint16 or float32, 1 to 4 channels, 32 to 32,768 pixels on each side.
        Other floats become float32, bool becomes uint8 (0 or 255), and other integers become uint8 where all
        lie from 0 to 255, else uint16 up to 65,535.
        All maps of a source have one size; all sources have the same maps, with the same type and channels.
    masks : sequence of bool array, shape (h, w), or None, optional
        For each source, the pixels that may be copied; by default all of them.
    weights : dict of str to float, optional
        How much each map counts when patches are matched and cut, 0 to 1,000,000; by default 1 for maps of
        color and 0.1 for others.
    kinds : dict of str to str, optional
        What each map holds: ``"color"``, ``"data"``, ``"roughness"``, ``"height"``, ``"normal-gl"`` (green
        points up) or ``"normal-dx"`` (green points down); by default guessed from the map's name.

    Attributes
    ----------
    sources : tuple of dict of str to array, shape (h, w, channels)
        The maps as they were given, each with an axis of channels.
    masks : tuple of bool array, shape (h, w)
        For each source, the pixels that may be copied.
    weights : dict of str to float
        The weight of every map.
    kinds : dict of str to str
        The kind of every map.

    Raises
    ------
    TilewrightTypeError
        Something that is not a sequence of dicts of arrays, or a map of another type.
    TilewrightValueError
        Maps that differ in size or number of channels, NaN or infinity, or a mask that leaves nothing.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> photo = np.random.default_rng(1).integers(0, 256, (64, 64, 3), np.uint8)
    >>> exemplar = tw.Exemplar([{"albedo": photo, "height": photo[..., 0]}])
    >>> exemplar.kinds
    {'albedo': 'color', 'height': 'height'}
    """

    sources: tuple[Maps, ...]
    masks: tuple[NDArray[np.bool_], ...]
    weights: dict[str, float]
    kinds: dict[str, str]

    def __repr__(self) -> str:
        sizes = (f"{m.shape[1]} x {m.shape[0]}" for m in (next(iter(s.values())) for s in self.sources))
        return describe(self, f"{' and '.join(sizes)} pixels", *(f"{n} ({k})" for n, k in self.kinds.items()))

    def __init__(
        self,
        sources: Sequence[Maps],
        masks: Sequence[NDArray[np.bool_] | None] | None = None,
        weights: dict[str, float] | None = None,
        kinds: dict[str, str] | None = None,
    ) -> None:
        if not isinstance(sources, Sequence) or not all(isinstance(s, Mapping) for s in sources):
            raise TilewrightTypeError(
                "must be a sequence of dicts of map name to array",
                argument="sources",
                allowed="a sequence of dicts of map name to array",
            )
        if not sources or not sources[0]:
            raise TilewrightValueError("an exemplar needs at least one source with at least one map")
        checked = tuple(_check_source(n, source) for n, source in enumerate(sources))
        _check_alike(checked)
        # All in the order of the first: features of a map stand at the same place for each source.
        checked = tuple({name: source[name] for name in checked[0]} for source in checked)
        given = list(masks) if masks is not None else [None] * len(checked)
        if len(given) != len(checked):
            raise TilewrightValueError(f"{len(given)} masks were given for {len(checked)} sources")
        object.__setattr__(self, "sources", checked)
        usable = tuple(_check_mask(n, m, s) for n, (m, s) in enumerate(zip(given, checked, strict=True)))
        object.__setattr__(self, "masks", usable)
        object.__setattr__(self, "kinds", check_kinds(kinds, checked[0]))
        object.__setattr__(self, "weights", _check_weights(weights, self.kinds))


def check_kinds(given: Any, maps: Mapping[str, NDArray[Any]]) -> dict[str, str]:
    """What each map holds: as given, else guessed."""
    if given is not None and not isinstance(given, Mapping):
        raise type_error("kinds", given, "a dict of map name to kind")
    check_map_names(maps)
    kinds = {name: guess_kind(name) for name in maps}
    for name, kind in (given or {}).items():
        check_choice("a map of kinds", name, tuple(maps))
        kinds[name] = check_choice(f"kind of map {name!r}", kind, KINDS)
    for name, kind in kinds.items():
        if is_normal(kind) and maps[name].shape[-1] == 1:
            raise TilewrightValueError(
                "has one channel and holds no normals",
                argument=f"map {name!r}",
                advice=f"name its kind, one of {', '.join(KINDS)}",
            )
    return kinds


def _check_weights(given: Any, kinds: dict[str, str]) -> dict[str, float]:
    if given is not None and not isinstance(given, Mapping):
        raise type_error("weights", given, "a dict of map name to number")
    weights = {name: WEIGHTS[kind] for name, kind in kinds.items()}
    for name, weight in (given or {}).items():
        check_choice("a map of weights", name, tuple(kinds))
        weights[name] = check_real(f"weight of map {name!r}", weight, 0, 1e6)
    if not any(weights.values()):
        raise TilewrightValueError(
            f"is {weights}; at least one map must count", argument="weights", value=weights
        )
    return weights


def _check_source(number: int, source: Maps) -> Maps:
    checked = {}
    sizes = {}
    for name, given in source.items():
        checked[name] = check_map(f"map {name!r} of source {number}", given)
        sizes[name] = checked[name].shape[:2]
    if len(set(sizes.values())) > 1:
        listing = ", ".join(f"{name} {w} x {h}" for name, (h, w) in sizes.items())
        raise TilewrightValueError(f"the maps of source {number} differ in size: {listing}")
    return checked


def check_map(what: str, given: Any) -> NDArray[Any]:
    """Pixels a texture can be made from, shape (h, w, channels); ``what`` they are, for messages."""
    pixels = as_texels(what, as_array(what, as_pixels(what, given)))
    if pixels.ndim == 2:
        pixels = pixels[..., np.newaxis]
    if pixels.ndim != 3 or not 1 <= pixels.shape[2] <= 4:
        raise shape_error(
            what, np.shape(given), "(height, width) or (height, width, channels) with 1 to 4 channels"
        )
    if min(pixels.shape[:2]) < SMALLEST_SIDE or max(pixels.shape[:2]) > LARGEST_SIDE:
        raise TilewrightValueError(
            f"is {pixels.shape[1]} x {pixels.shape[0]} pixels; allowed are {SMALLEST_SIDE} to "
            f"{LARGEST_SIDE} on each side",
            argument=what,
            allowed=f"{SMALLEST_SIDE} to {LARGEST_SIDE} on each side",
        )
    if pixels.dtype == np.float32 and not np.isfinite(pixels).all():
        y, x = (int(v[0]) for v in (~np.isfinite(pixels).all(axis=2)).nonzero())
        raise TilewrightValueError(
            f"is not finite at x={x}, y={y}; NaN and infinity are not allowed", argument=what
        )
    if pixels.dtype == np.float32 and np.abs(pixels).max() > LARGEST_VALUE:
        raise TilewrightValueError(
            f"holds {np.abs(pixels).max():.3g}; allowed are -{LARGEST_VALUE:g} to {LARGEST_VALUE:g}",
            argument=what,
            value=np.abs(pixels).max(),
            allowed=f"-{LARGEST_VALUE:g} to {LARGEST_VALUE:g}",
        )
    return np.ascontiguousarray(pixels)


def _check_alike(sources: tuple[Maps, ...]) -> None:
    first = {name: (m.dtype, m.shape[2]) for name, m in sources[0].items()}
    for number, source in enumerate(sources[1:], 1):
        here = {name: (m.dtype, m.shape[2]) for name, m in source.items()}
        if here != first:
            raise TilewrightValueError(
                f"has maps {_listing(here)}; source 0 has {_listing(first)}: they must agree",
                argument=f"source {number}",
            )


def _listing(kinds: dict[str, tuple[Any, int]]) -> str:
    return ", ".join(f"{name} ({kind}, {channels} channels)" for name, (kind, channels) in kinds.items())


def _check_mask(number: int, mask: Any, source: Maps) -> NDArray[np.bool_]:
    size = next(iter(source.values())).shape[:2]
    if mask is None:
        return np.ones(size, bool)
    usable = np.asarray(mask)
    if usable.shape != size:
        raise TilewrightValueError(
            f"has shape {usable.shape}; its source has {size}",
            argument=f"the mask of source {number}",
            value=usable.shape,
        )
    if usable.dtype.kind not in "buif" or (usable.dtype.kind == "f" and not np.isfinite(usable).all()):
        raise TilewrightTypeError(
            f"holds {usable.dtype}",
            argument=f"the mask of source {number}",
            value=usable.dtype,
            advice="use bool, without NaN",
        )
    usable = usable.astype(bool)
    if not usable.any():
        raise TilewrightValueError("leaves no pixel to copy", argument=f"the mask of source {number}")
    return usable
