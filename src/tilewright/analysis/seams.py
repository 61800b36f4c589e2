"""Seams: how much the picture jumps where one patch meets another, and whether tiles meet at all."""

import numpy as np
from numpy.typing import NDArray

from tilewright.analysis.sample import Sample, as_sample, find_cuts
from tilewright.signals.textures import TextureTiles

_TILES_AT_ONCE = 64


def measure_seams(material: TextureTiles | Sample, *, cells: int = 12, seed: int = 0) -> dict[str, float]:
    """Color steps across cut lines, and cuts along tile borders.

    A *cut* is a pair of neighboring pixels that are not neighbors in the exemplar; a *step* is the
    absolute difference of the two pixels, mean over channels.

    Parameters
    ----------
    material : TextureTiles or Sample
    cells, seed
        Size and seed of the random tiling.

    Returns
    -------
    dict of str to float
        ``cut_line_ratio``: mean step across cuts over the mean step elsewhere; 0 without cuts.
        ``cut_line_ratio_worst_tile``: the largest mean step inside one tile of the set over the same
        mean elsewhere. ``cut_share``: share of pairs that are cuts. ``edge_cut_share``: the same for
        pairs across tile borders.

    Notes
    -----
    Bound from below by nothing: blurred or flat seams score under 1. A cut through like-colored parts of
    unlike things scores well; see `measure_structure`.
    """
    sample = as_sample(material, cells, seed)
    cut_sum = cut_count = all_sum = all_count = 0.0
    for axis, cut in zip((1, 0), sample.cuts, strict=True):
        step = _steps(sample.pixels, axis)
        cut_sum += float(np.sum(step, where=cut, dtype=float))
        cut_count += np.count_nonzero(cut)
        all_sum += float(step.sum(dtype=float))
        all_count += step.size
    elsewhere = _ratio(all_sum - cut_sum, all_count - cut_count)
    border = np.arange(sample.size - 1, len(sample.placed) - 1, sample.size)
    east, south = sample.cuts
    across = np.concatenate([east[:, border].ravel(), south[border].ravel()])
    return {
        "cut_line_ratio": _ratio(_ratio(cut_sum, cut_count), elsewhere),
        "cut_line_ratio_worst_tile": _ratio(float(tile_steps(sample).max()), elsewhere),
        "cut_share": cut_count / all_count,
        "edge_cut_share": float(across.mean()),
    }


def tile_steps(sample: Sample) -> NDArray[np.float64]:
    """Mean step across the cuts inside each tile, shape (T,); 0 for a tile without cuts."""
    means = []
    for first in range(0, len(sample.places), _TILES_AT_ONCE):
        some = slice(first, first + _TILES_AT_ONCE)
        total = count = 0.0
        for axis, cut in zip((2, 1), find_cuts(sample.places[some], sample.stride), strict=True):
            total = total + (_steps(sample.tile_pixels[some], axis) * cut).sum(axis=(1, 2), dtype=float)
            count = count + cut.sum(axis=(1, 2))
        means.append(total / np.maximum(count, 1))
    return np.concatenate(means)


def _steps(pixels: NDArray[np.float32], axis: int) -> NDArray[np.float32]:
    step = np.diff(pixels, axis=axis)
    return np.abs(step, out=step).mean(axis=-1)


def _ratio(a: float, b: float) -> float:
    if b == 0:
        return 0.0 if a == 0 else float("inf")
    return float(a / b)
