"""Planes from a photograph without tiles, and the comparison of five methods."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.analysis.textures.comparison import compare_textures, lattice_autocorrelation
from tilewright.errors import TilewrightError
from tilewright.fields.photos.contenders import side_by_side
from tilewright.fields.photos.gaussian import gaussianize
from tilewright.fields.photos.methods import HexField, NoiseField, RepeatField, triangle_grid

FIELDS = (RepeatField, HexField, NoiseField)


def make_photo(channels=3, kind=np.uint8, shape=(96, 130)):
    rng = np.random.default_rng(4)
    grain = rng.random((*shape, 1)) * 0.6 + rng.random((*shape, channels)) * 0.4
    return (grain * (1 if kind is np.float32 else np.iinfo(kind).max)).astype(kind)


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("make", FIELDS)
def test_a_window_is_part_of_any_other(make, kind):
    for channels in (1, 3, 4):
        plane = make(make_photo(channels, kind))
        whole = plane.render(-70, 11, 200, 90)
        assert whole.dtype == kind
        assert np.array_equal(whole[5:60, 31:80], plane.render(-39, 16, 49, 55))


@pytest.mark.parametrize("make", FIELDS)
def test_planes_reach_far(make):
    plane = make(make_photo())
    for x, y in ((2**62 - 9, -(2**62)), (-(2**62), 2**62 - 8)):
        assert plane.render(x, y, 9, 8).shape == (8, 9, 3)
    with pytest.raises(TilewrightError, match="x is"):
        plane.render(2**62 + 1)


def test_repeated_is_the_photograph_over_and_over():
    photo = make_photo()
    assert np.array_equal(RepeatField(photo).render(-130, 96 * 2**40, 260, 192), np.tile(photo, (2, 2, 1)))


@pytest.mark.parametrize("make", [HexField, NoiseField])
def test_a_seed_moves_the_patches(make):
    photo = make_photo()
    first, again, other = (make(photo, seed=s).render(0, 0, 200, 200) for s in (1, 1, 2))
    assert np.array_equal(first, again)
    assert (first != other).mean() > 0.9


def slow_patches(plane, x, y):
    """The three patches of a pixel from the definition, in plain Python."""
    a, h = plane.edge, plane.row
    hash = tw.MixerHash(int(plane.hash.seed))
    found = []
    for j in range(y // h - 1, y // h + 3):
        for i in range((x - j * a // 2) // a - 1, (x - j * a // 2) // a + 3):
            dx, dy = x + 0.5 - (i * a + j * a // 2), y + 0.5 - j * h
            # Barycentric weight of the vertex: 1 at it, 0 on the hexagon of its neighbors.
            v = dy / h
            u = dx / a - v / 2
            weight = 1 - max(abs(u), abs(v), abs(u + v))
            if weight > 0:
                middle = [
                    first + (int(hash.words(stream, i, j)) >> 8) * count // 2**24
                    for stream, (first, count) in zip((10, 11), plane.range, strict=True)
                ]
                spot = [round(d - 0.5) + m for d, m in zip((dx, dy), middle, strict=True)]
                size = plane.photo.shape[1::-1]
                spot = [
                    -1 - s if s < 0 else 2 * n - 1 - s if s >= n else s
                    for s, n in zip(spot, size, strict=True)
                ]
                found.append((weight, spot))
    return found


def test_hex_tiling_is_what_its_paper_says():
    photo = make_photo()
    plane = HexField(photo, seed=5)
    rendered = plane.render(-300, 200, 120, 110).astype(int)
    light = np.where(photo / 255 <= 0.04045, photo / 255 / 12.92, ((photo / 255 + 0.055) / 1.055) ** 2.4)
    for x, y in ((0, 0), (13, 77), (60, 50), (119, 109), (101, 3)):
        patches = slow_patches(plane, x - 300, y + 200)
        assert len(patches) == 3
        assert sum(weight for weight, _ in patches) == pytest.approx(1)
        colors = [light[spot[1], spot[0]] for _, spot in patches]
        shares = [
            weight**7 * (0.4 + 0.6 * (color @ (0.299, 0.587, 0.114)))
            for (weight, _), color in zip(patches, colors, strict=True)
        ]
        mixed = sum(s * c for s, c in zip(shares, colors, strict=True)) / sum(shares)
        shown = np.where(mixed <= 0.0031308, mixed * 12.92, 1.055 * mixed ** (1 / 2.4) - 0.055) * 255
        assert np.abs(shown - rendered[y, x]).max() < 1


def test_by_example_noise_is_what_its_paper_says():
    photo = make_photo(1)
    plane = NoiseField(photo, seed=5)
    rendered = plane.render(40, -70, 60, 60).astype(int)
    ordered = np.sort(photo.ravel())
    for x, y in ((0, 0), (13, 47), (59, 59)):
        patches = slow_patches(plane, x + 40, y - 70)
        gauss = [plane.gaussian.pixels[spot[1], spot[0], 0] / 255 - 0.5 for _, spot in patches]
        weights = np.array([weight for weight, _ in patches])
        mixed = weights @ gauss / np.sqrt(weights @ weights)
        from scipy.special import ndtr

        rank = ndtr(6 * mixed) * len(ordered) - 0.5
        assert abs(np.interp(rank, np.arange(len(ordered)), ordered) - rendered[y, x, 0]) <= 1.5


def test_patches_are_those_of_the_definition_also_where_they_are_mirrored():
    plane = HexField(make_photo(), seed=3)
    weights, rows, columns = plane._patches(-500, 900, 400, 300)
    outside = np.zeros(plane.photo.shape[:2], int)
    rng = np.random.default_rng(0)
    for x, y in zip(rng.integers(0, 400, 250), rng.integers(0, 300, 250), strict=True):
        fast = sorted(zip(weights[:, y, x], columns[:, y, x], rows[:, y, x], strict=True))
        slow = sorted((weight, *spot) for weight, spot in slow_patches(plane, int(x) - 500, int(y) + 900))
        assert np.allclose(fast[-len(slow) :], slow)
        outside[rows[:, y, x], columns[:, y, x]] += 1
    assert outside[[0, -1]].any()


def test_patches_reach_over_the_border_only_where_they_have_faded_to_half():
    plane = HexField(make_photo(), seed=3)
    weights, rows, columns = plane._patches(-500, 900, 400, 300)
    main = weights > 0.5
    # Where a patch counts most it goes on pixel by pixel: nothing is mirrored.
    along = main[:, :, 1:] & main[:, :, :-1] & (np.diff(rows, axis=2) == 0)
    assert along.sum() > 1000
    assert (np.diff(columns, axis=2)[along] == 1).mean() > 0.99


def test_the_grid_is_nearly_regular():
    for side in (32, 100, 512, 4096):
        edge, row = triangle_grid((side, side + 9))
        assert edge % 2 == 0
        assert abs(row / edge - 3**0.5 / 2) < 0.5 / edge
        assert abs(edge * 2 * 3**0.5 / side - 1) < 0.12


def test_gaussian_values_are_normal_and_lead_back():
    photo = (make_photo(3, shape=(128, 128)) / 255) ** 3  # a skewed histogram: the mean is not the median
    found = gaussianize(photo)
    values = found.pixels / 255
    assert np.allclose(values.mean(axis=(0, 1)), 0.5, atol=0.01)
    assert np.allclose(values.std(axis=(0, 1)), 1 / 6, atol=0.005)
    assert np.abs(np.corrcoef(values.reshape(-1, 3).T) - np.eye(3)).max() < 0.05
    assert np.abs(found.restore(values) - photo).mean() < 0.003
    assert np.quantile(np.abs(found.restore(values) - photo), 0.999) < 0.05
    # From afar every pixel is the mean Gaussian value, and has the mean color.
    afar = found.mean + found.table[-1][[127, 128]].mean(axis=0) @ found.axes.T
    assert np.allclose(afar, photo.mean(axis=(0, 1)), atol=0.01)
    assert np.abs(np.median(photo, axis=(0, 1)) - photo.mean(axis=(0, 1))).min() > 0.03


def test_the_histogram_stays_with_noise_and_contrast_falls_with_averaging(gravel):
    photo = np.repeat(gravel, 3, axis=2)
    noise = NoiseField(photo, seed=1).render(0, 0, 1024, 1024)
    quantiles = np.linspace(2, 98, 25)
    assert np.abs(np.percentile(noise, quantiles) - np.percentile(photo, quantiles)).max() < 12
    hexes = HexField(photo, seed=1).render(0, 0, 1024, 1024)
    assert 0.8 * photo.std() < hexes.std() < 0.99 * photo.std() < noise.std() * 1.03


def test_autocorrelation_tells_what_comes_back():
    rng = np.random.default_rng(0)
    one = rng.random((32, 32)).astype(np.float32)
    square = np.eye(2, dtype=int) * 32
    assert lattice_autocorrelation(np.tile(one, (8, 8)), square) == pytest.approx(1, abs=0.03)
    assert abs(lattice_autocorrelation(rng.random((256, 256)).astype(np.float32), square)) < 0.02
    half = np.tile(one, (8, 8))
    half += rng.normal(size=half.shape).astype(np.float32) * one.std()
    assert lattice_autocorrelation(half, square) == pytest.approx(0.5, abs=0.05)
    skewed = np.array([[32, 0], [16, 28]])
    assert abs(lattice_autocorrelation(np.tile(one, (8, 8)), skewed)) < 0.45
    assert lattice_autocorrelation(np.zeros((64, 64), np.float32), square) == 0
    assert lattice_autocorrelation(one, square) == 0


@pytest.fixture(scope="module")
def small_comparison(gravel):
    exemplar = tw.Exemplar([{"albedo": gravel[:192, :192]}])
    return compare_textures(tw.synthesize(exemplar, tw.corner_tiles(2), tile_size=32, seed=1), seed=3)


def test_figures_rank_the_methods(small_comparison):
    figures = small_comparison.figures
    assert list(figures) == ["repeat", "hex", "noise", "wang", "corner"]
    assert figures["repeat"]["repetition"] == pytest.approx(1, abs=0.05)
    for blend in ("hex", "noise"):
        assert figures[blend]["repetition"] < 0.05
    for tiles in ("wang", "corner"):
        assert 0.02 < figures[tiles]["repetition"] < 0.5
    assert figures["hex"]["fine_contrast"] < 0.97 < figures["noise"]["fine_contrast"]
    assert figures["noise"]["strangeness"] > figures["repeat"]["strangeness"] == 1


def test_both_kinds_of_tiles_are_made_alike(small_comparison, gravel):
    wang, corner = (small_comparison.contenders[n].field.material for n in ("wang", "corner"))
    assert corner is small_comparison.material
    assert len(wang.tiles) == len(corner.tiles) == 16
    assert wang.tile_size == corner.tile_size
    assert wang.recipe["seed"] == corner.recipe["seed"] == 1
    back = side_by_side(wang, seed=3)
    assert np.array_equal(back.contenders["corner"].field.material.pixels, corner.pixels)
    fetches = {name: (one.fetches, one.table_fetches) for name, one in back.contenders.items()}
    assert fetches == {"repeat": (1, 0), "hex": (3, 0), "noise": (3, 1), "wang": (1, 0), "corner": (1, 0)}
    assert back.contenders["wang"].texels == 16 * 32 * 32


def test_two_photographs_cannot_be_compared():
    from handmade import handmade

    with pytest.raises(TilewrightError, match="was made from 2 photographs; a comparison takes one"):
        side_by_side(handmade(tw.corner_tiles(2)))
    with pytest.raises(TilewrightError, match="material must be TextureTiles, not int"):
        compare_textures(3)
