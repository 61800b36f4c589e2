"""How patches are sought: parts of a large sheet, small scales first, the price of what recurs."""

import dataclasses

import numpy as np
import pytest

import tilewright as tw
from tilewright.analysis.textures.repetition import same_place_share
from tilewright.analysis.textures.sample import lay_sample
from tilewright.signals.textures import matching
from tilewright.signals.textures.manner import NESTED
from tilewright.signals.textures.matching import cut_into_blocks
from tilewright.signals.textures.patchwork import Patchwork, thinned
from tilewright.signals.textures.sheet import Sheet


@pytest.mark.parametrize("shape", [(40, 64), (512, 512), (1280, 1281), (3072, 4096), (130, 9000)])
@pytest.mark.parametrize("size", [16, 128, 1024])
def test_every_window_lies_in_one_block(shape, size):
    if min(shape) < size:
        pytest.skip("no window fits")
    windows = np.zeros((shape[0] - size + 1, shape[1] - size + 1), int)
    for top, left, height, width in cut_into_blocks(shape, size):
        assert top + height <= shape[0]
        assert left + width <= shape[1]
        assert max(height, width) <= max(matching.BLOCK_SIDE, 2 * size)
        windows[top : top + height - size + 1, left : left + width - size + 1] += 1
    assert (windows == 1).all()


def test_a_sheet_searched_in_parts_gives_tiles_that_meet(gravel, monkeypatch):
    monkeypatch.setattr(matching, "BLOCK_SIDE", 100)
    material = tw.texture_tiles(gravel, tw.corner_tiles(2), tile_size=32, seed=1)
    again = tw.texture_tiles(gravel, tw.corner_tiles(2), tile_size=32, seed=1, threads=1)
    assert np.array_equal(material.origins, again.origins)
    assert tw.analyze(material).figures["edge_cut_share"] < 0.1
    rows = [spot[1] for name, spot in material.recipe["patches"].items() if name.startswith("center")]
    assert max(rows) - min(rows) > 100  # patches come from all over


def test_a_pick_does_not_move_other_patches(gravel, monkeypatch):
    monkeypatch.setattr(matching, "BLOCK_SIDE", 100)
    material = tw.texture_tiles(gravel, tw.corner_tiles(2), tile_size=32, seed=1)
    taken = tuple(material.recipe["patches"]["edge-h:0-1"])
    again = tw.resynthesize(material, pick={"edge-h:0-1": taken})
    assert again.recipe["patches"] == material.recipe["patches"]


def test_a_reduced_canvas_shows_what_the_canvas_shows():
    """A patch stays one patch, and the same pixels are seen up to the blocks they are averaged over."""
    ramp = np.indices((96, 96)).transpose(1, 2, 0).astype(np.float32)
    sheet = Sheet(ramp, np.ones((96, 96), bool), (0,), ((96, 96),))
    canvas = Patchwork.of_patch(32, 32, (9, 14))
    small = canvas.reduced(4)
    assert (np.diff(small.rows, axis=0) == 1).all()
    assert (np.diff(small.columns, axis=1) == 1).all()
    seen, asked = small.pixels(sheet.reduced(4).features), thinned(canvas.pixels(ramp), 4)
    assert np.abs(seen - asked).max() <= 2


@pytest.mark.parametrize("sigma", [1.0, 5.0, 12.0, 25.0])
def test_a_blur_spreads_a_point_by_its_sigma(sigma):
    point = np.zeros((301, 301, 1), np.float32)
    point[150, 150] = 1
    spread = Sheet(point, np.ones((301, 301), bool), (0,), ((301, 301),)).low_pass(sigma)[..., 0]
    along = spread.sum(axis=1)
    steps = np.arange(301) - 150
    assert along.sum() == pytest.approx(1, abs=1e-4)
    assert along @ steps == pytest.approx(0, abs=1e-3)
    assert np.sqrt(along @ steps**2) == pytest.approx(sigma, abs=0.6)


def test_a_price_on_what_recurs_lowers_repetition(gravel, monkeypatch):
    cheap, dear = [], []
    for price, found in ((0.0, cheap), (NESTED.recurrence, dear)):
        manner = dataclasses.replace(NESTED, recurrence=price)
        monkeypatch.setattr("tilewright.signals.textures.treatment.NESTED", manner)
        material = tw.texture_tiles(gravel, tw.corner_tiles(2), tile_size=96, seed=1)
        found.append(same_place_share(lay_sample(material, 12)))
    assert dear[0] < 0.92 * cheap[0]
