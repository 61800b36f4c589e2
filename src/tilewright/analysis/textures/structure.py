"""Whether what the cuts make looks like something in the photograph."""

import numpy as np
from numpy.typing import NDArray

from tilewright.analysis.textures.sample import Sample

_PATCHES = 400
_DICTIONARY = 20000
_COMPONENTS = 16


def seam_novelty(sample: Sample, side: int = 8, seed: int = 0) -> tuple[float, float]:
    """How far patches on cut lines are from the photograph: mean and 95th percentile.

    The distance of a patch (side x side pixels, 16 principal components) to its nearest neighbor in the
    photograph, over the mean of the same for patches of the photograph (their own surroundings left out).
    1 means that what the cuts make could be in the photograph; fused stones and broken courses raise it.
    """
    rng = np.random.default_rng(seed)
    east, south = sample.cuts
    cut: NDArray[np.bool_] = np.zeros(sample.gray.shape, bool)
    cut[:, :-1] |= east
    cut[:-1] |= south
    photo = sample.material.sources[0][sample.material.main].astype(np.float32)
    rows, columns = photo.shape[0] - side + 1, photo.shape[1] - side + 1
    pick = rng.choice(rows * columns, min(_DICTIONARY, rows * columns), replace=False)
    places = np.stack([pick // columns, pick % columns], axis=1)
    known = _patches(photo, places, side)
    mean = known.mean(axis=0)
    _, _, components = np.linalg.svd((known - mean)[:4000], full_matrices=False)
    basis = components[:_COMPONENTS].T
    known = (known - mean) @ basis
    cy, cx = (c.astype(np.int64) for c in np.nonzero(cut))
    near = (cy >= side) & (cy < cut.shape[0] - side) & (cx >= side) & (cx < cut.shape[1] - side)
    cy, cx = cy[near], cx[near]
    if not len(cy):
        return 0.0, 0.0
    pick = rng.choice(len(cy), min(_PATCHES, len(cy)), replace=False)
    asked = (_patches(sample.pixels, np.stack([cy[pick], cx[pick]], axis=1) - side // 2, side) - mean) @ basis
    ours = np.sqrt(_squared(asked, known).min(axis=1))
    own = _squared(known[:_PATCHES], known)
    beside = np.abs(places[:_PATCHES, None] - places).max(axis=2) < 2 * side
    own[beside] = np.inf
    theirs = float(np.sqrt(own.min(axis=1)).mean())
    if theirs == 0:
        return 0.0, 0.0
    return float(ours.mean() / theirs), float(np.percentile(ours, 95) / theirs)


def _patches(image: NDArray[np.float32], places: NDArray[np.int64], side: int) -> NDArray[np.float32]:
    i, j = np.indices((side, side))
    found = image[places[:, 0, None, None] + i, places[:, 1, None, None] + j]
    return found.reshape(len(places), -1)


def _squared(a: NDArray[np.float32], b: NDArray[np.float32]) -> NDArray[np.float32]:
    return np.maximum((a * a).sum(axis=1)[:, None] + (b * b).sum(axis=1) - 2 * a @ b.T, 0)


def used_share(sample: Sample) -> float:
    """Share of the photograph's pixels that the tile set shows."""
    origins = sample.material.origins.reshape(-1, 3)
    shown = len(np.unique(origins, axis=0))
    sizes = [s[sample.material.main].shape for s in sample.material.sources]
    return shown / sum(h * w for h, w, _ in sizes)
