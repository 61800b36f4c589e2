"""Nested patches on a photograph: cuts and repetition together, by numbers.

Numbers do not settle it: the sheets of ``tilewright analyze`` are for looking. ``make bench`` measures all
photographs.
"""

import tilewright as tw
from tilewright.analysis import lay_sample
from tilewright.analysis.textures.repetition import same_place_share, tile_lag_autocorrelation
from tilewright.analysis.textures.seams import cut_line_ratio, edge_cut_share, tone_step_ratio


def test_gravel_whose_stones_are_all_edges(gravel):
    sample = lay_sample(tw.texture_tiles(gravel, tw.corner_tiles(2), seed=1))
    assert cut_line_ratio(sample) <= 1.10
    assert same_place_share(sample) <= 0.17
    assert edge_cut_share(sample) <= 0.03
    assert tone_step_ratio(sample) <= 1.3
    assert tile_lag_autocorrelation(sample)[0] <= 0.17
