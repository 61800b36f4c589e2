"""Places of the patches of large tiles, found where several pixels are seen as one.

A tile of 512 pixels shows no more than one of 128 seen closer: which places go together is decided by what is
as large as a few pixels of the small one. Only the cuts are made at full size.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tilewright.errors import Progress, TilewrightValueError
from tilewright.signals.textures.corners import check_picked_corner
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.manner import Manner
from tilewright.signals.textures.methods import Lay
from tilewright.signals.textures.nested import corner_reach
from tilewright.signals.textures.search import DRAFTED_AT, Ledger, PatchSearch, Place
from tilewright.signals.textures.sheet import Sheet, reduce_blocks, reduce_pixels


def draft_step(exemplar: Exemplar, size: int) -> int:
    """Pixels along the squares that are seen as one: a tile is an even number of them, 128 at the least.

    1 where the photograph is less than two tiles wide: the border that squares lose counts there, and there
    is little to search.
    """
    ample = min(min(mask.shape) for mask in exemplar.masks) >= 2 * size
    most = max(1, size // DRAFTED_AT) if ample else 1
    return next(step for step in range(most, 0, -1) if size % (2 * step) == 0)


def know_places(search: PatchSearch, manner: Manner, seen: Sheet, step: int, lay: Lay) -> None:
    """Find the places of all patches by a search at a smaller scale, and have a search know them.

    Parameters
    ----------
    search : PatchSearch
        The search at full size; what was picked stays where it was picked.
    manner : Manner
        How places are chosen; its courses are those of the photograph, the pixels it bars those of ``seen``.
    seen : Sheet
        The sheet of the search, ``step`` x ``step`` pixels averaged into one.
    lay : function
        What lays all patches.

    Raises
    ------
    TilewrightValueError
        A pick outside the photograph, or no place is left for a patch.
    """
    picked, rejected = search.ledger.picked, search.ledger.rejected
    for name in picked:
        _check(search, name)
    rows, columns = (
        rhythm and rhythm.reduced(step, length)
        for rhythm, length in zip(manner.rhythm, seen.usable.shape, strict=True)
    )
    small = PatchSearch(
        seen,
        search.size // step,
        Ledger(rejected={name: [_scaled(p, step) for p in places] for name, places in rejected.items()}),
        search.period and search.period / step,
        search.pool,
        _in_two_rounds(search.progress, False),
        search.total,
        search.rng,
        replace(manner, rhythm=(rows, columns)),
    )
    small.ledger.picked.update({name: _nearest(small, name, _scaled(p, step)) for name, p in picked.items()})
    try:
        lay(small, search.rng)
    except TilewrightValueError as no_room:  # told in squares
        raise TilewrightValueError(
            f"the exemplar or its mask is too small for tiles of {search.size} pixels, or too many patches "
            "were rejected",
            advice="choose a smaller tile size or a larger photograph",
        ) from no_room
    found = {name: (y * step, x * step) for name, (y, x) in small.ledger.laid.items()}
    search.ledger.picked.update(found | picked)
    search.progress = _in_two_rounds(search.progress, True)
    search.places_known = True


def reduce_main(exemplar: Exemplar, step: int) -> Exemplar:
    """The main map of an exemplar, squares of pixels averaged into one."""
    if step == 1:
        return exemplar
    name = next(iter(exemplar.kinds))
    maps, masks = [], []
    for source, usable in zip(exemplar.sources, exemplar.masks, strict=True):
        maps.append({name: reduce_pixels(source[name], step)})
        masks.append(reduce_blocks(usable[..., np.newaxis].astype(np.float32), step)[..., 0] == 1)
    return Exemplar(maps, masks, {name: 1.0}, {name: exemplar.kinds[name]})


def _check(search: PatchSearch, name: str) -> None:
    if name.startswith("corner:"):
        check_picked_corner(search, name, corner_reach(search))
    else:
        search.checked_pick(name)


def _scaled(place: Place, step: int) -> Place:
    y, x = place
    return y // step, x // step


def _nearest(search: PatchSearch, name: str, place: Place) -> Place:
    """The place nearest to one that a patch may be taken from, as squares of pixels leave a wider border."""
    sources = range(len(search.sheet.tops))
    reach = corner_reach(search) if name.startswith("corner:") else 0
    places: NDArray[np.bool_] = search.matcher.places_of_size(2 * reach or search.size, sources)
    y, x = places.nonzero()
    if not len(y):
        return place
    best = np.argmin((y + reach - place[0]) ** 2 + (x + reach - place[1]) ** 2)
    return int(y[best]) + reach, int(x[best]) + reach


def _in_two_rounds(progress: Progress | None, second: bool) -> Progress | None:
    """The progress of one of two rounds of equally many steps."""
    if progress is None:
        return None
    return lambda done, total, what: progress(done + second * total, 2 * total, what)
