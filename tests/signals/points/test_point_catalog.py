"""Point tiles by name."""

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightTypeError, TilewrightValueError
from tilewright.signals.points import TILE_METHODS


@pytest.mark.parametrize("name", TILE_METHODS)
def test_every_kind_is_made_by_name(name, request):
    small = {"points": 256} if name == "kopf" else {"points": 16}
    radius = {} if TILE_METHODS[name].rho is None else {"rho": 0.7}
    if name == "edge":
        made = request.getfixturevalue("crossed_points")
    else:
        made = tw.make_point_tiles(name, **small, **radius, colors=2, seed=np.random.default_rng(4))
    assert made.figures["doubled"] >= made.figures["window"] > 0
    assert tw.find_closeness(made).distance >= made.distance
    assert (made.counts > 0).all()


def test_unknown_kinds_and_settings_are_refused():
    with pytest.raises(TilewrightValueError, match="method is 'lloyd'; allowed are corner"):
        tw.make_point_tiles("lloyd")
    with pytest.raises(TilewrightTypeError, match="does not take rho"):
        tw.make_point_tiles("hiller", 16, 0.7)
