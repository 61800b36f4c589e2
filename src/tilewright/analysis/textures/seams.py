"""How much is seen of the cuts."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter

from tilewright.analysis.textures.sample import Sample
from tilewright.signals.textures.kinds import to_lab
from tilewright.signals.textures.sheet import GRAIN


def cut_line_ratio(sample: Sample) -> float:
    """Mean color step across pixel pairs whose source changes, over the mean elsewhere.

    1 means that cuts are as smooth as the photograph is inside. It is taken on the copied pixels, so
    blending cannot flatter it; it does not see cuts that fuse two things of one color.
    """
    steps = [np.abs(np.diff(sample.pixels, axis=axis)).mean(axis=2) for axis in (1, 0)]
    across = np.concatenate([s[c] for s, c in zip(steps, sample.cuts, strict=True)])
    inside = np.concatenate([s[~c] for s, c in zip(steps, sample.cuts, strict=True)])
    if not across.size or not inside.size or inside.mean() == 0:
        return 0.0
    return float(across.mean(dtype=np.float64) / inside.mean(dtype=np.float64))


def worst_tile_ratio(sample: Sample) -> float:
    """The largest cut-line ratio of a single tile of the set, against the mean step of all of them."""
    tiles = sample.material.pixels.astype(np.float32)
    origins = sample.material.origins.astype(np.int32)
    across, count, inside = np.zeros(len(tiles)), np.zeros(len(tiles)), []
    for axis, onward in ((2, (0, 0, 1)), (1, (0, 1, 0))):
        step = np.abs(np.diff(tiles, axis=axis)).mean(axis=3)
        cut = (np.diff(origins, axis=axis) != onward).any(axis=3)
        across += (step * cut).sum(axis=(1, 2))
        count += cut.sum(axis=(1, 2))
        inside.append(step[~cut])
    level = np.concatenate(inside).mean()
    return float((across / np.maximum(count, 1)).max() / level) if level > 0 else 0.0


def cut_color_ratio(sample: Sample) -> float:
    """Difference in color of the two sides of cuts within tiles, over what either patch has there by itself.

    Sides are seen in L*a*b* without grain (a Gaussian of a 64th of a tile), two of its standard deviations
    from the cut. 1 means that color changes across cuts as it does in the photograph. A cut along an outline
    is as good as one within a thing; things of two colors raise it. Cuts between photographs do not count.
    """
    main = sample.material.main
    sigma = GRAIN * sample.size
    reach = max(1, round(2 * sigma))
    soft = [
        gaussian_filter(to_lab(s[main], sample.material.kinds[main]), (sigma, sigma, 0), mode="nearest")
        for s in sample.material.sources
    ]
    origins = sample.material.origins.astype(np.int32)
    across = own = 0.0
    for axis, onward in ((2, (0, 0, 1)), (1, (0, 1, 0))):
        near, far = np.delete(origins, -1, axis), np.delete(origins, 0, axis)
        cut = (far - near != onward).any(axis=3) & (far == near)[..., 0]
        step = reach * np.array(onward, np.int32)
        # The colors of both patches, before the cut and after it.
        seen = [_colors(soft, spots[cut] + way * step) for spots in (near, far) for way in (-1, 1)]
        known = np.isfinite(np.concatenate(seen, axis=1)).all(axis=1)
        before, on, back, after = (colors[known] for colors in seen)
        across += float(np.linalg.norm(before - after, axis=1).sum(dtype=np.float64))
        for one, other in ((before, on), (back, after)):
            own += 0.5 * float(np.linalg.norm(one - other, axis=1).sum(dtype=np.float64))
    return across / own if own > 0 else 0.0


def _colors(sources: Sequence[NDArray[np.float32]], spots: NDArray[np.int32]) -> NDArray[np.float32]:
    """Colors at (source, y, x), shape (k, channels); not a number outside of the source."""
    found = np.full((len(spots), sources[0].shape[2]), np.nan, np.float32)
    y, x = spots[:, 1], spots[:, 2]
    for number, source in enumerate(sources):
        mine = (spots[:, 0] == number) & (y >= 0) & (y < source.shape[0]) & (x >= 0) & (x < source.shape[1])
        found[mine] = source[y[mine], x[mine]]
    return found


def edge_cut_share(sample: Sample) -> float:
    """Share of pixel pairs across tile borders whose source changes.

    Neighbors share the content of their edge: 0.00 to 0.03 for right neighbors, 0.4 and more for wrong ones.
    """
    n = sample.size
    east, south = sample.cuts
    return float(np.concatenate([east[:, n - 1 :: n].ravel(), south[n - 1 :: n].ravel()]).mean())


def tone_step_ratio(sample: Sample, sigma: float | None = None) -> float:
    """Steps of tone along the tiles' frames, over those in the photograph at that scale.

    The tone (low-passed, sigma an eighth of a tile) of each tile's middle is compared with that of its
    border band; the mean square difference is divided by that of windows of the photograph. 1 is what the
    photograph does by itself; square patches in step with the tiles raise it.
    """
    n = sample.size
    sigma = n / 8 if sigma is None else sigma
    tone = _reduced(gaussian_filter(sample.pixels, (sigma, sigma, 0), mode="reflect"), n)
    ours = _middle_against_border(
        tone.reshape(*sample.cells.shape, n, n, -1).reshape(-1, n, n, tone.shape[-1])
    )
    theirs = []
    for source in sample.material.sources:
        photo = source[sample.material.main].astype(np.float32)
        low = gaussian_filter(photo, (sigma, sigma, 0), mode="reflect")
        step = max(1, n // 4)
        windows = [
            low[y : y + n, x : x + n]
            for y in range(0, low.shape[0] - n + 1, step)
            for x in range(0, low.shape[1] - n + 1, step)
        ]
        theirs.append(_middle_against_border(np.stack(windows)))
    reference = float(np.mean(theirs))
    return float(np.sqrt(ours / reference)) if reference > 0 else 0.0


def _reduced(picture: NDArray[np.float32], n: int) -> NDArray[np.float32]:
    """A picture as cells: shape (rows, columns, n, n, channels)."""
    h, w, c = picture.shape
    return picture.reshape(h // n, n, w // n, n, c).swapaxes(1, 2)


def _middle_against_border(windows: NDArray[np.float32]) -> float:
    """Mean square difference between the tone of the middle and of the border of square windows."""
    n = windows.shape[1]
    middle = windows[:, n * 3 // 10 : n * 7 // 10, n * 3 // 10 : n * 7 // 10].mean(axis=(1, 2))
    band = max(1, n // 16)
    edge = np.concatenate(
        [
            windows[:, :band].reshape(len(windows), -1, windows.shape[3]),
            windows[:, -band:].reshape(len(windows), -1, windows.shape[3]),
            windows[:, :, :band].reshape(len(windows), -1, windows.shape[3]),
            windows[:, :, -band:].reshape(len(windows), -1, windows.shape[3]),
        ],
        axis=1,
    ).mean(axis=1)
    return float(((middle - edge) ** 2).sum(axis=1).mean())
