"""Five methods on one photograph, measured alike: what is seen of repetition, and what is lost."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft2, next_fast_len, rfft2
from scipy.ndimage import gaussian_filter, uniform_filter
from scipy.spatial.distance import cdist

from tilewright.errors import Progress
from tilewright.fields.photos.contenders import SideBySide, side_by_side
from tilewright.pixels import without_alpha
from tilewright.signals.textures import TextureTiles

Gray = NDArray[np.float32]

METHOD_MEANING = {
    "repetition": "autocorrelation at the method's own lattice lags, less the photograph's: 1 all, 0 none",
    "fine_contrast": "contrast of the finest details over the photograph's",
    "coarse_contrast": "contrast of details about eight times as large over the photograph's",
    "strangeness": "distance of small pieces to the photograph; 1 as the photograph repeated",
}
_TILES, _PHOTOGRAPHS = 12, 2
"""Sides of the picture that is measured: at least this number of tiles, and of photographs."""
_PIECE, _ASKED, _KNOWN, _COMPONENTS = 8, 600, 20000, 16


def compare_textures(
    material: TextureTiles, *, seed: int = 0, progress: Progress | None = None
) -> SideBySide:
    """Measure plain repeat, hex-tiling, by-example noise, Wang tiles and corner tiles on one photograph.

    Parameters
    ----------
    material : TextureTiles
        Made from one photograph; the other kind of tiles is made like it, see `side_by_side`.
    seed : int, optional
        Seed of the tilings and blends, 0 to 2^64 - 1; default 0.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop.

    Returns
    -------
    SideBySide
        ``figures[method]`` has ``repetition``, ``fine_contrast``, ``coarse_contrast`` and ``strangeness``.

    Raises
    ------
    TilewrightTypeError
        Something else than texture tiles.
    TilewrightValueError
        The material was made from several photographs.

    Notes
    -----
    All are taken on the main map, on one window of each plane, in gray (the mean of the channels) but for
    strangeness, which sees colors.

    Repetition is the mean autocorrelation at all vectors of the method's lattice up to half the window: of
    the photograph's size where it is repeated, of the triangle grid where patches are blended, of tiles. The
    picture is high-passed first (sigma half the lattice's spacing). What the photograph has there by itself
    is taken off, as far as it reaches and down to 0. It tells what is seen of a grid; a photograph is
    finite, so every method shows its parts again and again, blends at places that form no grid.

    Contrast is the standard deviation in a band (difference of Gaussians of sigma 1 and 2, and 8 and 16).
    Strangeness is the mean distance of pieces of 8 x 8 pixels (at full, half and quarter size; 16 principal
    components) to the nearest of 20,000 pieces of the photograph: ghosts of two patches and broken structure
    raise it.
    """
    planes = side_by_side(material, seed=seed, progress=progress)
    photo = _color(planes.photo)
    side = max(_TILES * material.tile_size, _PHOTOGRAPHS * max(photo.shape[:2]))
    figures = {}
    for step, (name, one) in enumerate(planes.contenders.items()):
        if progress is not None:
            progress(step, len(planes.contenders), f"measuring {one.label}")
        picture = _color(one.field.render(0, 0, side, side))
        figures[name] = _measure(picture, photo, one.lattice)
    base = figures["repeat"]["strangeness"] or 1.0
    for found in figures.values():
        found["strangeness"] /= base
    rounded = {n: {k: round(float(v), 4) for k, v in found.items()} for n, found in figures.items()}
    return replace(planes, figures=rounded)


def _measure(picture: Gray, photo: Gray, lattice: NDArray[np.int64]) -> dict[str, float]:
    gray, own = picture.mean(axis=2), photo.mean(axis=2)
    repetition = lattice_autocorrelation(gray, lattice) - max(0.0, lattice_autocorrelation(own, lattice))
    return {
        "repetition": max(0.0, repetition),
        "fine_contrast": _share(_contrast(gray, 1), _contrast(own, 1)),
        "coarse_contrast": _share(_contrast(gray, 8), _contrast(own, 8)),
        "strangeness": float(np.mean([_strangeness(picture, photo, step) for step in (1, 2, 4)])),
    }


def lattice_autocorrelation(gray: Gray, lattice: NDArray[np.int64]) -> float:
    """Mean autocorrelation of a picture at all vectors of a lattice up to half its size.

    The picture is high-passed with sigma half the lattice's shorter spacing; 0 where it is smaller than two
    steps of the lattice, or flat.
    """
    lags = _lags(lattice, gray.shape)
    if not len(lags):
        return 0.0
    fine = gray - gaussian_filter(gray, np.hypot(*lattice.T).min() / 2)
    reach = np.abs(lags).max(axis=0)
    size = [next_fast_len(s + int(most), real=True) for s, most in zip(gray.shape, reach, strict=True)]
    sums = irfft2(np.abs(rfft2(fine, size)) ** 2, size)
    both = np.prod(np.array(gray.shape) - np.abs(lags), axis=1)
    flat = float(np.mean(fine.astype(np.float64) ** 2))
    return float(np.mean(sums[lags[:, 0], lags[:, 1]] / both)) / flat if flat > 1e-9 else 0.0


def _lags(lattice: NDArray[np.int64], shape: tuple[int, ...]) -> NDArray[np.int64]:
    """Lattice vectors (y, x) up to half the shape, one of each pair of opposite ones."""
    reach = int(max(shape) / np.abs(np.linalg.det(lattice)) ** 0.5) + 2
    i, j = np.mgrid[-reach : reach + 1, -reach : reach + 1].reshape(2, -1)
    lags = (np.stack([i, j], axis=1) @ lattice)[:, ::-1]
    near = (np.abs(lags) <= np.array(shape) // 2).all(axis=1)
    half = (lags[:, 0] > 0) | ((lags[:, 0] == 0) & (lags[:, 1] > 0))
    return lags[near & half]


def _contrast(gray: Gray, sigma: float) -> float:
    return float((gaussian_filter(gray, sigma) - gaussian_filter(gray, 2 * sigma)).std())


def _share(ours: float, theirs: float) -> float:
    return ours / theirs if theirs > 0 else 1.0


def _strangeness(picture: Gray, photo: Gray, step: int) -> float:
    """Mean distance of pieces to the nearest piece of the photograph, both reduced by a step."""
    rng = np.random.default_rng(step)
    asked, known = _pieces(picture, step, _ASKED, rng), _pieces(photo, step, _KNOWN, rng)
    mean = known.mean(axis=0)
    _, axes = np.linalg.eigh((known - mean).T @ (known - mean))
    basis = axes[:, -_COMPONENTS:]
    nearest = cdist((asked - mean) @ basis, (known - mean) @ basis).min(axis=1)
    return float(nearest.mean()) / max(float(known.std()), 1e-9)


def _pieces(picture: Gray, step: int, most: int, rng: np.random.Generator) -> Gray:
    """Pieces at random places, shape (most, values): each value the mean of step x step pixels."""
    reduced = uniform_filter(
        picture, (step, step, 0), mode="nearest", origin=(-((step - 1) // 2),) * 2 + (0,)
    )
    side = min(_PIECE, min(picture.shape[:2]) // step)
    y, x = (rng.integers(0, s - side * step + 1, (most, 1, 1)) for s in picture.shape[:2])
    i, j = np.mgrid[:side, :side] * step
    return reduced[y + i, x + j].reshape(most, -1)


def _color(pixels: NDArray[np.generic]) -> Gray:
    """Without alpha."""
    return without_alpha(pixels).astype(np.float32)
