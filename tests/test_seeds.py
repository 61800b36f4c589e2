"""Seeds: numbers and generators, never nothing."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.seeds import check_seed

MAKERS = {
    "direct": lambda seed: tw.direct(tw.corner_tiles(3), seed).indices(0, 0, 9, 9),
    "start": lambda seed: tw.random_start(9, 9, seed=seed),
    "points": lambda seed: tw.sample_points("uniform", 9, seed=seed).points,
    "texture": lambda seed: tw.texture_tiles(PHOTO, tw.corner_tiles(1), tile_size=16, seed=seed).origins,
    "aperiodic": lambda seed: tw.aperiodic_tiling(tw.aperiodic_tiles("ammann-16"), seed).indices(0, 0, 9, 9),
}
PHOTO = np.random.default_rng(5).integers(0, 256, (96, 96, 3), np.uint8)


@pytest.mark.parametrize("name", MAKERS)
def test_a_generator_gives_the_seed(name):
    make = MAKERS[name]
    one, again = (make(np.random.default_rng(7)) for _ in range(2))
    assert np.array_equal(one, again)
    assert np.array_equal(one, make(check_seed(np.random.default_rng(7))))
    generator = np.random.default_rng(7)
    assert np.array_equal(one, make(generator))
    assert not np.array_equal(one, make(generator))


def test_nothing_is_no_seed():
    with pytest.raises(tw.TilewrightError, match="must be a whole number or a numpy Generator, not None"):
        tw.direct(tw.corner_tiles(2), None)
    for wrong in (-1, 2**64, 0.5, "1"):
        with pytest.raises(tw.TilewrightError, match="seed"):
            check_seed(wrong)
