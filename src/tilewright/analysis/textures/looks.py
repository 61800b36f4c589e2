"""What the eye would say of a plane beside its photograph: tones, contrast, and what it finds again."""

import numpy as np
from numpy.typing import NDArray
from scipy.fft import irfft2, next_fast_len, rfft2
from scipy.ndimage import gaussian_filter, maximum_filter, median_filter

from tilewright.signals.textures.lone import stand_out
from tilewright.signals.textures.sheet import reduce_blocks

Lab = NDArray[np.float32]

BLOTS = 32
"""Shorter side of a photograph over the standard deviation of the Gaussian that leaves its blots of tone."""
ALIKE, SAME = 0.8, 0.6
"""Correlation from which two windows show one thing, and from which two neighboring cells are equal."""
WINDOW = 1 / 5
"""Side of the windows that are looked for again, in tiles."""
WINDOWS, WORST, THINGS = 30, 10, 6
"""Random windows that are looked for, how many of the most repeated count, and salient things."""
SPIKE = 25
"""Power over that of the waves around it from which a wave is a spike."""
AFAR = 16
"""Pixels that are seen as one from afar, for tiles of 256; as many for others as keep 16 texels a tile."""


def measure_looks(plane: Lab, photo: Lab, size: int, seed: int = 0) -> dict[str, float]:
    """All figures of a plane of tiles of ``size`` pixels, a tile's corner at its own.

    What a photograph has by itself does not count: a weave has copies and equal neighbors of its own.
    """
    found = {
        "mean_difference": mean_difference(plane, photo),
        "low_contrast": low_contrast(plane, photo),
        "fine_contrast": fine_contrast(plane, photo),
    }
    copies = {"recurrence": recurrence, "salient_copies": salient_copies}
    found |= {
        n: f(plane, photo, size, seed) / max(1.0, f(photo, photo, size, seed)) for n, f in copies.items()
    }
    alike = {"equal_neighbors": equal_neighbors, "lattice_spikes": lattice_spikes}
    return found | {n: max(0.0, f(plane, size) - f(photo, size)) for n, f in alike.items()}


def mean_difference(plane: Lab, photo: Lab) -> float:
    """Distance of the mean colors, in units of CIE L*a*b* (delta E 1976)."""
    means = (picture.mean(axis=(0, 1), dtype=np.float64) for picture in (plane, photo))
    first, second = means
    return float(np.linalg.norm(first - second))


def low_contrast(plane: Lab, photo: Lab) -> float:
    """Standard deviation of the plane's blots of tone over that of the photograph's."""
    sigma = min(photo.shape[:2]) / BLOTS
    step = max(1, int(sigma / 4))  # what is left is smooth
    reduced = (reduce_blocks(picture, step) for picture in (plane, photo))
    ours, theirs = (_deviation(gaussian_filter(p, (sigma / step, sigma / step, 0))) for p in reduced)
    return ours / max(theirs, 1e-9)


def fine_contrast(plane: Lab, photo: Lab) -> float:
    """Standard deviation of what is finer than two pixels over that of the photograph."""
    light = (picture[..., :1] for picture in (plane, photo))
    ours, theirs = (_deviation(p - gaussian_filter(p, (2, 2, 0))) for p in light)
    return ours / max(theirs, 1e-9)


def _deviation(picture: Lab) -> float:
    return float(np.sqrt(picture.reshape(-1, picture.shape[2]).var(axis=0, dtype=np.float64).sum()))


def equal_neighbors(plane: Lab, size: int) -> float:
    """Share of cells that look like the one to their east or south, color shifts aside."""
    step = max(1, size // 32)
    light = reduce_blocks(plane[..., :1], step)[..., 0]
    n = size // step
    rows, columns = (s // n for s in light.shape)
    if min(rows, columns) < 2:
        return 0.0
    fine = light - gaussian_filter(light, n / 8)
    cells = (
        fine[: rows * n, : columns * n].reshape(rows, n, columns, n).swapaxes(1, 2).reshape(rows, columns, -1)
    )
    cells = cells - cells.mean(axis=2, keepdims=True)
    cells /= np.maximum(np.linalg.norm(cells, axis=2, keepdims=True), 1e-9)
    east, south = (cells[:, 1:] * cells[:, :-1]).sum(axis=2), (cells[1:] * cells[:-1]).sum(axis=2)
    return float(((east > SAME).sum() + (south > SAME).sum()) / (east.size + south.size))


def recurrence(plane: Lab, photo: Lab, size: int, seed: int = 0) -> float:
    """How often random windows come again on an area of the photograph's size: the mean of the worst."""
    step = max(1, size // 64)
    light = reduce_blocks(plane[..., :1], step)[..., 0]
    side = max(4, round(WINDOW * size / step))
    if min(light.shape) <= side:
        return 1.0
    rng = np.random.default_rng(seed)
    tops, lefts = (rng.integers(0, n - side, WINDOWS) for n in light.shape)
    counts = count_copies(light, list(zip(tops.tolist(), lefts.tolist(), strict=True)), side)
    areas = light.size * step**2 / (photo.shape[0] * photo.shape[1])
    return float(np.sort(counts)[-WORST:].mean() / areas)


def salient_copies(plane: Lab, photo: Lab, size: int, seed: int = 0) -> float:
    """Copies of the most repeated of the things that stand out most, on an area of the photograph's size."""
    step = max(1, size // 64)
    small = reduce_blocks(plane, step)
    side = max(4, round(WINDOW * size / step))
    usable = np.ones(small.shape[:2], bool)
    salience = np.sqrt((stand_out(small, usable, size / step / 32) ** 2).sum(axis=2))
    half = side // 2
    salience[:half] = salience[-half - 1 :] = salience[:, :half] = salience[:, -half - 1 :] = 0
    peaks = np.argwhere((salience == maximum_filter(salience, 2 * side + 1)) & (salience > 0))
    if not len(peaks):
        return 1.0
    order = np.argsort(-salience[tuple(peaks.T)], kind="stable")[:THINGS]
    places = [(int(y) - half, int(x) - half) for y, x in peaks[order]]
    areas = small.shape[0] * small.shape[1] * step**2 / (photo.shape[0] * photo.shape[1])
    return float(count_copies(small[..., 0], places, side).max() / areas)


def count_copies(light: NDArray[np.float32], places: list[tuple[int, int]], side: int) -> NDArray[np.int64]:
    """How many windows correlate with each of some, themselves included: normalized correlation by FFT."""
    size = tuple(next_fast_len(n, real=True) for n in light.shape)
    spectrum = rfft2(light.astype(np.float64), size)
    box = np.zeros(light.shape)
    box[:side, :side] = 1 / side**2
    kernel = np.conj(rfft2(box, size))
    valid = tuple(slice(0, n - side + 1) for n in light.shape)
    mean = irfft2(spectrum * kernel, size)[valid]
    square = irfft2(rfft2(light.astype(np.float64) ** 2, size) * kernel, size)[valid]
    spread = np.sqrt(np.maximum(square - mean**2, 1e-6 * float(light.var())))
    counts = []
    for y, x in places:
        window = light[y : y + side, x : x + side].astype(np.float64)
        window = (window - window.mean()) / max(float(window.std()), 1e-9) / side**2
        product = irfft2(spectrum * np.conj(rfft2(window, size)), size)[valid]
        alike = product / spread
        counts.append(int(((alike == maximum_filter(alike, side)) & (alike > ALIKE)).sum()))
    return np.array(counts)


def lattice_spikes(plane: Lab, size: int) -> float:
    """Share of the variance seen from afar that is in waves far above those around them."""
    step = max(1, size // AFAR)
    light = reduce_blocks(plane[..., :1], step)[..., 0]
    if min(light.shape) < AFAR:
        return 0.0
    light = (light - light.mean()) * np.hanning(light.shape[0])[:, np.newaxis] * np.hanning(light.shape[1])
    power = np.abs(np.fft.fft2(light)) ** 2
    around = median_filter(power, 15, mode="wrap")
    return float(power[power > SPIKE * around].sum() / max(float(power.sum()), 1e-12))
