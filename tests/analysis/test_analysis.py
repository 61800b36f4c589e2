"""The figures, from cases whose values are known."""

import dataclasses

import numpy as np
import pytest

import tilewright as tw
from handmade import handmade
from tilewright.analysis import lay_sample
from tilewright.analysis.textures.meanings import ANY, MEANING
from tilewright.analysis.textures.repetition import lattice_share, same_place_share, tile_lag_autocorrelation
from tilewright.analysis.textures.report import Report
from tilewright.analysis.textures.sample import Sample
from tilewright.analysis.textures.seams import (
    cut_color_ratio,
    cut_line_ratio,
    edge_cut_share,
    tone_step_ratio,
)
from tilewright.analysis.textures.structure import seam_novelty
from tilewright.signals.textures import TextureTiles, copy_from_sources


def crops(photo, size, count, seed=0, continuous=None):
    """A "set" of ``count`` unrelated crops; with ``continuous``, one big crop cut into that many columns."""
    rng = np.random.default_rng(seed)
    i, j = np.indices((size, size))
    origins = np.zeros((count, size, size, 3), np.uint16)
    for t in range(count):
        if continuous:
            y, x = (t // continuous) * size, (t % continuous) * size
        else:
            y, x = rng.integers(0, photo.shape[0] - size, 2)
        origins[t, ..., 1], origins[t, ..., 2] = i + y, j + x
    tiles = tw.tile_set([[0, 0, 0, t] for t in range(count)], "wang") if count < 256 else None
    source = ({"a": photo},)
    return TextureTiles(tiles, copy_from_sources(source, origins), source, origins)


@pytest.fixture(scope="module")
def noise():
    return np.random.default_rng(5).integers(0, 255, (512, 512, 1)).astype(np.uint8)


def test_one_continuous_piece_has_no_cuts(gravel):
    material = crops(gravel, 64, 64, continuous=8)
    sample = Sample(material, np.arange(64).reshape(8, 8))
    assert cut_line_ratio(sample) == 0
    assert edge_cut_share(sample) == 0
    assert tone_step_ratio(sample) == pytest.approx(1, abs=0.25)


def test_cut_line_ratio_against_plain_loops(gravel):
    material = tw.synthesize(
        tw.Exemplar([{"a": gravel[:200, :200]}]), tw.corner_tiles(2), tile_size=32, seed=1
    )
    sample = Sample(material, tw.direct(material.tiles, 3).indices(0, 0, 2, 2))
    pixels, origins = sample.pixels, sample.origins
    across, inside = [], []
    for y in range(64):
        for x in range(64):
            for dy, dx in ((0, 1), (1, 0)):
                if y + dy < 64 and x + dx < 64:
                    step = abs(float(pixels[y, x, 0]) - float(pixels[y + dy, x + dx, 0]))
                    onward = tuple(origins[y + dy, x + dx] - origins[y, x]) == (0, dy, dx)
                    (inside if onward else across).append(step)
    assert cut_line_ratio(sample) == pytest.approx(np.mean(across) / np.mean(inside), rel=1e-5)


def test_cuts_along_outlines_are_as_good_as_none():
    # Stripes of 32 pixels and three colors, under grain.
    photo = np.tile(np.repeat([60, 120, 180], 32), 5) + np.random.default_rng(0).normal(0, 20, (64, 480))
    photo = photo.clip(0, 255).astype(np.uint8)[..., np.newaxis]

    def sample(cut, second=0):
        """Tiles of two stripes: to ``cut`` from one place, the rest from another or a second source."""
        origins = np.zeros((8, 64, 64, 3), np.uint16)
        origins[..., 1:] = np.moveaxis(np.indices((64, 64)), 0, -1)
        for tile in range(8):
            origins[tile, :, :cut, 2] += 32 * tile
            origins[tile, :, cut:, 2] += 32 * (tile + 4)
        origins[:, :, cut:, 0] = second
        source = ({"a": photo}, {"a": photo})
        material = TextureTiles(tw.free_tiles(8), copy_from_sources(source, origins), source, origins)
        return Sample(material, np.arange(8).reshape(2, 4))

    assert cut_color_ratio(sample(32)) == pytest.approx(1, abs=0.2)
    assert cut_color_ratio(sample(48)) > 2
    assert cut_color_ratio(sample(48, second=1)) == 0
    assert cut_line_ratio(sample(32)) > 1.1


@pytest.mark.parametrize("figure", ["cut_line_ratio", "lattice_spikes"])
@pytest.mark.parametrize("treatment", ["courses", "things", "even", ""])
def test_outlines_and_courses_are_not_objected_to(noise, treatment, figure):
    fine = treatment == "courses" or (treatment == "things" and figure == "cut_line_ratio")
    material = dataclasses.replace(crops(noise, 32, 4), recipe={"treatment": treatment})
    report = Report({figure: 1.5}, Sample(material, np.zeros((4, 4), np.int32)))
    assert len(report.objections) == (not fine)
    assert (f"over {MEANING[figure].limits[1]:g}" in str(report)) == (not fine)


def test_a_report_says_what_to_change(noise):
    """In sentences, each once; every figure has its unit, and an objection goes with advice."""
    sample = Sample(crops(noise, 32, 4), np.zeros((4, 4), np.int32))
    report = Report(
        {"used_share": 0.04, "lattice_share": 0.3, "recurrence": 4.0, "mean_difference": 0.5}, sample
    )
    assert report.verdict == [
        "To object to: only 4.0% of the photograph is shown; every tile has its light and dark at the same "
        "places; a piece of the plane is seen 4.0 times on the photograph's area.",
        "To change: larger tiles, more colors or more variants, or a smaller cut of the photograph; "
        "more colors or more variants.",
    ]
    assert str(report).splitlines()[-2:] == report.verdict
    assert "0.040 share  below 0.1" in str(report)
    assert "0.500 dE " in str(report)
    assert Report({"used_share": 0.4}, sample).verdict[0].startswith("No figure is beyond its limit")
    assert all(bool(meaning.objection) == bool(meaning.advice) for meaning in MEANING.values())
    assert all(meaning.objection for meaning in MEANING.values() if meaning.limits != ANY)


def test_wrong_neighbors_are_told(gravel):
    good = tw.synthesize(tw.Exemplar([{"a": gravel[:200, :200]}]), tw.corner_tiles(2), tile_size=48, seed=1)
    assert edge_cut_share(lay_sample(good)) < 0.06
    wrong = Sample(good, np.random.default_rng(0).integers(0, 16, (12, 12)))
    assert edge_cut_share(wrong) > 0.4


def test_repetition_runs_from_none_to_one(noise):
    one = Sample(crops(noise, 32, 4), np.zeros((12, 12), np.int32))
    assert tile_lag_autocorrelation(one)[0] == pytest.approx(1, abs=0.05)
    assert same_place_share(one) == 1
    every = Sample(crops(noise, 32, 144), np.arange(144).reshape(12, 12))
    assert abs(tile_lag_autocorrelation(every)[0]) < 0.03
    assert same_place_share(every) < 0.01
    four = Sample(crops(noise, 32, 4), np.random.default_rng(1).integers(0, 4, (12, 12)))
    assert tile_lag_autocorrelation(four)[0] == pytest.approx(0.25, abs=0.06)
    assert same_place_share(four) == pytest.approx(0.25, abs=0.03)


def test_same_place_share_against_plain_counting(noise):
    sample = Sample(crops(noise, 16, 3), np.random.default_rng(2).integers(0, 3, (4, 4)))
    cells = sample.cells.ravel()
    equal = [
        (sample.material.origins[a] == sample.material.origins[b]).all(axis=-1).mean()
        for i, a in enumerate(cells)
        for j, b in enumerate(cells)
        if i != j
    ]
    assert same_place_share(sample) == pytest.approx(np.mean(equal))


def test_tone_of_middles_is_seen(gravel):
    material = crops(gravel, 64, 16)
    sample = Sample(material, np.random.default_rng(3).integers(0, 16, (8, 8)))
    plain = tone_step_ratio(sample)
    pixels = material.pixels.astype(float)
    pixels[:, 12:52, 12:52] += np.random.default_rng(4).choice([-40, 40], 16)[:, None, None, None]
    patchy = dataclasses.replace(material, maps={"a": pixels.clip(0, 255).astype(np.uint8)})
    assert plain < 1.5
    assert tone_step_ratio(Sample(patchy, sample.cells)) > 2 * plain


def test_the_lattice_is_seen(noise):
    material = crops(noise, 64, 144)
    sample = Sample(material, np.arange(144).reshape(12, 12))
    assert lattice_share(sample) < 0.05
    ramp = (material.pixels * 0.5 + np.linspace(0, 120, 64)[:, None]).astype(np.uint8)
    shaded = dataclasses.replace(material, maps={"a": ramp})
    assert lattice_share(Sample(shaded, sample.cells)) > 0.5


def test_novelty_of_cuts(gravel):
    exemplar = tw.Exemplar([{"a": gravel}])
    nested = tw.synthesize(exemplar, tw.corner_tiles(2), tile_size=64, seed=1)
    mosaic = Sample(crops(gravel, 64, 16), np.random.default_rng(0).integers(0, 16, (12, 12)))
    assert seam_novelty(lay_sample(nested))[0] < seam_novelty(mosaic)[0] - 0.1


@pytest.mark.parametrize("tiles", [tw.corner_tiles(2), tw.wang_tiles(2), tw.cohen_tiles(18)], ids=repr)
@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
def test_every_set_gets_a_report_and_a_sheet(tmp_path, tiles, kind):
    report = tw.analyze(handmade(tiles, 16, kind, 4), cells=6)
    assert all(np.isfinite(v) for v in report.figures.values())
    assert all(name in str(report) for name in report.figures)
    report.save_sheet(tmp_path / "sheet.png")
    assert tw.read_image(tmp_path / "sheet.png").shape[2] in (3, 4)


def test_a_sheet_has_room_for_its_pictures():
    """However long the objections are; photograph and plane have one scale."""
    report = tw.analyze(handmade(tw.corner_tiles(2), 16), cells=6)
    poor = {"low_contrast": 0.3, "recurrence": 13.0, "lattice_spikes": 0.1, "mean_difference": 9.0}
    report = dataclasses.replace(report, figures=report.figures | poor)
    assert len(" ".join(report.objections)) > 150
    figure = report.sheet()
    figure.draw_without_rendering()
    photograph, near, cut = figure.axes[:3]
    assert min(axis.get_position().width for axis in figure.axes) > 0.2
    assert photograph.get_xlim() == near.get_xlim() == cut.get_xlim()
    numbers = [text.get_text() for text in figure.axes[4].texts]
    assert numbers == [str(tile) for tile in range(16)]
