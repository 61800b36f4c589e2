"""Every photograph at hand: cuts and repetition of nested patches, and what is measured of faithful ones."""

import pytest
from PIL import Image

import tilewright as tw
from conftest import PHOTOGRAPHS

# Photograph -> largest cut-line ratio, as a color step across cuts over that inside the photograph.
CUT_LINES = {
    "sand": 1.00,
    "grass": 1.00,
    "pebbles": 1.00,
    "leaves_albedo": 1.00,
    "straw_dense": 1.00,
    "straw_sparse": 1.00,
    "cobblestone": 1.03,
    "stone_wall": 1.20,
    "weave": 1.00,
}


@pytest.mark.parametrize("name", CUT_LINES)
def test_sixteen_corner_tiles_of_a_photograph(name):
    path = PHOTOGRAPHS / f"{name}.png"
    if not path.exists():
        pytest.skip(f"{path.name} is not at hand")
    figures = tw.analyze(tw.texture_tiles(Image.open(path), tw.corner_tiles(2), seed=1)).figures
    print(f"\n{name}: {figures}")
    assert figures["cut_line_ratio"] <= CUT_LINES[name]
    assert figures["same_place_share"] <= 0.17
    assert figures["edge_cut_share"] <= 0.03
    assert figures["tone_step_ratio"] <= 1.3
    if name != "weave":  # a weave agrees with itself at such lags
        assert figures["repetition"] <= 0.17


@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("name", CUT_LINES)
def test_faithful_tiles_give_no_figure_to_object_to(name, seed):
    path = PHOTOGRAPHS / f"{name}.png"
    if not path.exists():
        pytest.skip(f"{path.name} is not at hand")
    report = tw.analyze(tw.texture_tiles(Image.open(path), method="faithful", seed=seed))
    print(f"\n{name}, seed {seed}: {report.figures}")
    assert report.objections == []
