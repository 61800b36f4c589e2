"""Places of the patches of large tiles, found where several pixels are seen as one.

A tile of 512 pixels shows no more than one of 128 seen closer: which places go together is decided by what is
as large as a few pixels of the small one. Only the cuts are made at full size.
"""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tilewright.errors import Progress
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.manner import Manner
from tilewright.signals.textures.search import DRAFTED_AT, Ledger, Place
from tilewright.signals.textures.sheet import Sheet, reduce_blocks, reduce_pixels


class Draft(NamedTuple):
    """What is searched instead of the sheet, and how."""

    sheet: Sheet
    size: int
    manner: Manner
    ledger: Ledger
    period: float | None


def draft_step(size: int) -> int:
    """Pixels along the squares that are seen as one: a tile is an even number of them, 128 at the least."""
    most = max(1, size // DRAFTED_AT)
    return next(step for step in range(most, 0, -1) if size % (2 * step) == 0)


def make_draft(
    sheet: Sheet, size: int, manner: Manner, ledger: Ledger, period: float | None, step: int
) -> Draft:
    """The search at a scale; pixels that must not be shown (``manner.lone``) are at that scale already."""
    rows, columns = (
        rhythm and rhythm.reduced(step, length // step)
        for rhythm, length in zip(manner.rhythm, sheet.usable.shape, strict=True)
    )
    seen = Ledger(
        {name: (y // step, x // step) for name, (y, x) in ledger.picked.items()},
        {name: [(y // step, x // step) for y, x in places] for name, places in ledger.rejected.items()},
    )
    small = replace(manner, rhythm=(rows, columns))
    return Draft(sheet.reduced(step), size // step, small, seen, period and period / step)


def keep_places(draft: Draft, ledger: Ledger, step: int) -> Ledger:
    """The ledger with every patch picked where the draft laid it, but for those that were picked before."""
    found: dict[str, Place] = {name: (y * step, x * step) for name, (y, x) in draft.ledger.laid.items()}
    return Ledger(found | ledger.picked, ledger.rejected)


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


def in_two_rounds(progress: Progress | None, second: bool) -> Progress | None:
    """The progress of one of two rounds of equally many steps."""
    if progress is None:
        return None
    return lambda done, total, what: progress(done + second * total, 2 * total, what)


def at_full_size(manner: Manner) -> Manner:
    """The manner in which patches are cut whose places are known."""
    return replace(manner, popping=0.0, rhythm=(None, None), lone=None)
