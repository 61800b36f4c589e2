"""Nested patches on photographs of two kinds: cuts and repetition together, by numbers.

Numbers do not settle it: the sheets of ``tilewright analyze`` are for looking. ``make bench`` measures all
photographs.
"""

import pytest

import tilewright as tw

# Photograph -> largest cut-line ratio, as a color step across cuts over that inside the photograph.
CUT_LINES = {"stone_wall": 1.20}


@pytest.mark.parametrize("name", CUT_LINES)
def test_sixteen_corner_tiles_of_a_photograph(photograph, name):
    figures = tw.analyze(tw.texture_tiles(photograph(name), tw.corner_tiles(2), seed=1)).figures
    assert figures["cut_line_ratio"] <= CUT_LINES[name]
    assert figures["same_place_share"] <= 0.17
    assert figures["edge_cut_share"] <= 0.03
    assert figures["tone_step_ratio"] <= 1.3
    assert figures["repetition"] <= 0.17


def test_gravel_whose_stones_are_all_edges(gravel):
    figures = tw.analyze(tw.texture_tiles(gravel, tw.corner_tiles(2), seed=1)).figures
    assert figures["cut_line_ratio"] <= 1.10
    assert figures["repetition"] <= 0.17
