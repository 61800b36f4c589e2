"""From an exemplar to texture tiles: the methods by name, and the record that makes a set again."""

import os
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import numpy as np

from tilewright.checks import check_int, check_progress, check_type, type_error
from tilewright.errors import Progress, TilewrightValueError
from tilewright.seeds import Seed, check_seed
from tilewright.signals.textures.character import find_character
from tilewright.signals.textures.choices import (
    check_choices,
    check_cost,
    check_size,
    expected_seconds,
    to_sheet,
    to_source,
    warn_of_clone,
    warn_of_misfit,
)
from tilewright.signals.textures.drafting import draft_step, know_places, reduce_main
from tilewright.signals.textures.exemplar import Exemplar
from tilewright.signals.textures.keeping import Earlier, Kept
from tilewright.signals.textures.lone import lone_things_of
from tilewright.signals.textures.methods import check_method, find_method
from tilewright.signals.textures.recipe import Recipe, Spot
from tilewright.signals.textures.regularity import Regularity, find_regularity, suited_tile_size
from tilewright.signals.textures.seams import copy_maps
from tilewright.signals.textures.search import Ledger, PatchSearch
from tilewright.signals.textures.sheet import make_sheet
from tilewright.signals.textures.texture_tiles import TextureTiles
from tilewright.signals.textures.tone import take_tone
from tilewright.signals.textures.treatment import (
    Treatment,
    find_treatment,
    plain_treatment,
    usual_size,
)
from tilewright.tiles import TileSet
from tilewright.tiles.variants import Variants


def synthesize(
    exemplar: Exemplar,
    tiles: TileSet | None = None,
    *,
    tile_size: int | str | None = None,
    seed: Seed = 0,
    method: str | None = None,
    tone: bool | None = None,
    variants: int = 1,
    pick: Mapping[str, Spot] | None = None,
    reject: Mapping[str, Sequence[Spot]] | None = None,
    threads: int | None = None,
    progress: Progress | None = None,
) -> TextureTiles:
    """Synthesize a texture over a tile set, from an exemplar in memory.

    Parameters
    ----------
    exemplar : Exemplar
        One source, or two for an inhomogeneous set: then the upper half of the corner colors is taken from
        the second (Cohen et al. 2003, section 3.5).
    tiles : TileSet, optional
        Corner, corner-coded or Wang tiles; by default `classed_corner_tiles` that suit the exemplar.
    tile_size : int or "auto", optional
        Pixels along a tile, even, 16 to 1,024; with ``"faithful"`` by default what suits the exemplar: about
        an eighth of its shorter side, at least 160 where it has 512, larger for things with outlines, and a
        whole number of courses where it has any; with other methods 128. ``"auto"`` takes for these a
        size near 128 that is a whole number of the exemplar's periods.
    seed : int or numpy.random.Generator, optional
        The same seed gives the same bytes, whatever the number of threads; 0 to 2^64 - 1, default 0.
    method : str, optional
        For corner tiles ``"faithful"`` (default where no tiles are given: nested patches that keep step with
        courses, show what is seldom once, and leave tone to be laid over the tiles), ``"nested"`` (default
        where they are), ``"ng"`` (Ng et al. 2005: one patch per corner color, cut
        in the inscribed circle by one patch per tile; Lagae & Dutré 2006, figure 6d) or ``"squares"``
        (figure 6c); for Wang tiles ``"centered-diamonds"`` (default), ``"diamonds"`` (Cohen et al. 2003;
        figure 6a) or ``"burke"`` (figure 6b).
    tone : bool, optional
        Whether colors that vary over more than a tile are laid outside the tiles, as noise made from the
        exemplar; only with ``"faithful"`` and one source. By default where they do not belong to things with
        outlines or courses.
    variants : int, optional
        Pictures of every tile, 1 to 256; default 1. They are patches of their own over the same borders, so
        any of them may lie beside any neighbor. They hide repetition with fewer tiles than more colors. Only
        methods with a patch of its own for each tile have them: ``"faithful"``, ``"nested"``, ``"ng"`` and
        ``"centered-diamonds"``.
    pick : dict of str to (source, y, x), optional
        Places for named patches, instead of a search; see ``recipe["patches"]`` for names and places. By
        default every place is searched for.
    reject : dict of str to list of (source, y, x), optional
        Places that named patches must not be taken from, nor within a quarter of a tile; by default none.
    threads : int, optional
        Number of threads, 1 to 1,024; by default one for each processor.
    progress : callable, optional
        Called as ``progress(done, total, what)`` after each patch; raise `Cancelled` in it to stop.

    Returns
    -------
    TextureTiles
        Pictures for each tile of the set, and where each of their pixels was copied from.

    Raises
    ------
    TilewrightTypeError
        An argument of another type.
    TilewrightValueError
        The exemplar or its mask is too small for the tile size, the tiles have more than 2^28 pixels
        together, the method does not go with the set, with variants or with tone, or too much was rejected.

    Warns
    -----
    TilewrightWarning
        The exemplar holds a copy of itself, or is periodic and the tile size is off its period; the set
        will take minutes.

    Examples
    --------
    >>> import numpy as np
    >>> import tilewright as tw
    >>> photo = np.random.default_rng(1).integers(0, 256, (64, 64, 3), np.uint8)
    >>> material = tw.synthesize(tw.Exemplar([{"albedo": photo}]), tw.corner_tiles(2), tile_size=16)
    >>> material.pixels.shape
    (16, 16, 16, 3)
    """
    return _synthesize(
        exemplar, tiles, tile_size=tile_size, seed=seed, method=method, tone=tone, variants=variants,
        pick=pick, reject=reject, threads=threads, progress=progress,
    )  # fmt: skip


def _synthesize(
    exemplar: Exemplar,
    tiles: TileSet | None,
    *,
    tile_size: int | str | None,
    seed: Seed,
    method: str | None,
    tone: bool | None,
    variants: int,
    pick: Mapping[str, Spot] | None,
    reject: Mapping[str, Sequence[Spot]] | None,
    threads: int | None,
    progress: Progress | None,
    earlier: Earlier | None = None,
) -> TextureTiles:
    """As `synthesize`; of an earlier set only what touches its changed patches is made anew."""
    seed = check_seed(seed)
    workers = os.cpu_count() or 1 if threads is None else check_int("threads", threads, 1, 1024)
    check_type("exemplar", exemplar, Exemplar, "an Exemplar")
    check_progress(progress)
    pick, reject = check_choices(pick, reject)
    method = check_method(method, tiles, variants)
    check_size(tile_size)
    if not (tone is None or isinstance(tone, bool)):
        raise type_error("tone", tone, "True, False or None")
    from tilewright.kernels.threads import at_most

    with at_most(workers), ThreadPoolExecutor(workers) as pool:
        # Step 1: what the photograph asks for, where nobody asks otherwise.
        regularity, treatment = _treat(exemplar, tiles, tile_size, method, tone)
        tiles, size = treatment.tiles, treatment.tile_size
        warn_of_clone(regularity)
        check_cost(len(tiles) * variants, size, treatment.manner.jointly)
        # Step 2: tone apart from what the tiles hold.
        toned, held = take_tone(exemplar, size) if treatment.tone else (None, exemplar)
        # Step 3: patches.
        sheet = make_sheet(held, treatment.manner.breadth, size)
        # Places of large tiles are found where several pixels are seen as one.
        manner, step = treatment.manner, draft_step(held, size) if treatment.manner.jointly else 1
        seen = sheet if step == 1 else sheet.reduced(step)
        lone: list[Spot] = []
        if treatment.bars_lone_things:
            things, spots = lone_things_of(reduce_main(held, step), size // step)
            # As many tiles may show a thing as it takes for it to be as frequent as in the photograph.
            shows = max(1, round(len(tiles) * size**2 / sheet.usable.sum()))
            manner = replace(manner, lone=seen.lay(things), shows=shows)
            lone = [(source, y * step, x * step) for source, y, x in spots]
        ledger = Ledger(
            {name: to_sheet(sheet, name, spot) for name, spot in pick.items()},
            {name: [to_sheet(sheet, name, s) for s in spots] for name, spots in reject.items()},
        )
        picked, period, rng = dict(ledger.picked), treatment.period(regularity), np.random.default_rng(seed)
        lay, total = find_method(method, tiles, len(exemplar.sources), variants, manner)
        own = manner if step == 1 else treatment.manner
        kept = None if earlier is None else Kept.of(sheet, earlier, variants)
        search = PatchSearch(sheet, size, ledger, period, pool, progress, total, rng, own, kept)
        if step > 1:
            know_places(search, manner, seen, step, lay)
        canvas = lay(search, rng)
        unknown = (set(ledger.picked) | set(ledger.rejected)) - set(ledger.laid)
        if unknown:
            raise TilewrightValueError(
                f"no patch is called {min(unknown)!r}; this set has {', '.join(sorted(ledger.laid)[:6])}, ..."
            )
        del search, seen  # for memory
        origins = sheet.to_origins(canvas.rows, canvas.columns)
        recipe = Recipe(
            method,
            seed,
            size,
            exemplar.weights,
            {name: to_source(sheet, place) for name, place in ledger.laid.items()},
            {name: to_source(sheet, place) for name, place in picked.items()},
            {n: [to_source(sheet, p) for p in ps] for n, ps in ledger.rejected.items()},
            variants,
            treatment.tone,
            treatment.name,
            lone,
        )
        # Step 4: every map along the same cuts.
        del canvas, sheet  # for memory
        rows = Variants.uniform(tiles, variants)
        maps = copy_maps(held.sources, origins, exemplar.kinds, tiles, rows, progress)
        return TextureTiles(
            tiles,
            maps,
            exemplar.sources,
            origins,
            recipe.to_dict(),
            exemplar.masks,
            exemplar.kinds,
            rows,
            toned,
        )


def _treat(
    exemplar: Exemplar, tiles: TileSet | None, tile_size: int | str | None, method: str, tone: bool | None
) -> tuple[Regularity, Treatment]:
    """What is regular in a photograph, and what is decided for it."""
    size = check_size(tile_size)
    regularity = find_regularity(next(iter(exemplar.sources[0].values())))
    if tiles is None or method == "faithful":
        # Seen at its usual size, so that a set made again is treated as it was.
        character = find_character(exemplar, regularity, usual_size(exemplar))
        return regularity, find_treatment(exemplar, character, tiles, size, tone)
    treatment = plain_treatment(tiles, suited_tile_size(regularity) if tile_size == "auto" else size, tone)
    warn_of_misfit(regularity, treatment.tile_size)
    return regularity, treatment


def foresee(
    exemplar: Exemplar,
    tiles: TileSet | None = None,
    *,
    tile_size: int | str | None = None,
    method: str | None = None,
    tone: bool | None = None,
    variants: int = 1,
) -> dict[str, Any]:
    """What `synthesize` would make of the same arguments, and about what that costs on two cores."""
    method = check_method(method, tiles, variants)
    treatment = _treat(exemplar, tiles, tile_size, method, tone)[1]
    count, size = len(treatment.tiles) * variants, treatment.tile_size
    seconds = expected_seconds(count, size, treatment.manner.jointly)
    return {"tiles": len(treatment.tiles), "pictures": count, "tile_size": size, "seconds": round(seconds, 1)}


def resynthesize(
    material: TextureTiles,
    *,
    reject: Iterable[str] = (),
    pick: Mapping[str, Spot] | None = None,
    reseed_rest: bool = False,
    threads: int | None = None,
    progress: Progress | None = None,
) -> TextureTiles:
    """Make a set again with some of its patches rejected ("not this one") or picked by hand.

    All other patches stay where they are, and only the tiles that show one of the named patches are cut
    again: one tile for a center patch. What was rejected and picked before stays so, and so do the weights
    of variants.

    Parameters
    ----------
    material : TextureTiles
        A set that `synthesize` or `texture_tiles` made.
    reject : iterable of str, optional
        Names of patches in ``material.recipe["patches"]``: the place each was taken from is barred for it
        from now on. By default none.
    pick : dict of str to (source, y, x), optional
        Places for named patches, instead of a search; by default none.
    reseed_rest : bool, optional
        Whether the patches that are not named are searched for again too, as if the set were made for the
        first time; default False.
    threads : int, optional
        Number of threads, 1 to 1,024; by default one for each processor.
    progress : callable, optional
        Called as ``progress(done, total, what)`` after each patch; raise `Cancelled` in it to stop.

    Returns
    -------
    TextureTiles
        The set made anew; its recipe remembers what was rejected and picked.

    Raises
    ------
    TilewrightTypeError
        An argument of another type.
    TilewrightValueError
        A patch that the set does not have, a set without a recipe, or too much was rejected.
    """
    recipe = Recipe.of(material)
    if isinstance(reject, str) or not isinstance(reject, Iterable):
        raise type_error("reject", reject, "a list of patch names")
    if pick is not None and not isinstance(pick, Mapping):
        raise type_error("pick", pick, "a dict of patch name to (source, y, x)")
    rejected = {name: list(spots) for name, spots in recipe.rejected.items()}
    picked = recipe.picked | dict(pick or {})
    rejected_now = list(reject)
    for name in rejected_now:
        if name not in recipe.patches:
            raise TilewrightValueError(
                f"no patch is called {name!r}; this set has {', '.join(sorted(recipe.patches)[:6])}, ..."
            )
        rejected.setdefault(name, []).append(recipe.patches[name])
        picked.pop(name, None)
    changed = frozenset(rejected_now) | frozenset(pick or {})
    stay = {} if reseed_rest else {n: spot for n, spot in recipe.patches.items() if n not in changed}
    made = _synthesize(
        Exemplar(material.sources, material.masks or None, recipe.weights, material.kinds),
        material.tiles,
        tile_size=recipe.tile_size,
        seed=recipe.seed,
        method=recipe.method,
        variants=recipe.variants,
        tone=recipe.tone,
        pick=stay | picked,
        reject=rejected,
        threads=threads,
        progress=progress,
        earlier=None if reseed_rest else Earlier(material.origins, changed),
    )
    told = Recipe.of(made)
    told.picked = picked
    return replace(made, recipe=told.to_dict(), variants=material.variants)
