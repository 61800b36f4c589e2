"""Sheets and plots as files: the same bytes each time, in the proportions of the box."""

import os
import re
import subprocess
import sys
import zlib
from contextlib import suppress

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightTypeError, TilewrightValueError

SAVE = """
import sys, tilewright as tw
tw.analyze(tw.sample_points("dart", 200, seed=1)).save_sheet(sys.argv[1])
"""


@pytest.mark.parametrize("suffix", ["svg", "pdf", "png"])
def test_a_sheet_has_the_same_bytes_at_any_time(tmp_path, suffix):
    for name, hashes in (("a", "1"), ("b", "2")):
        command = [sys.executable, "-c", SAVE, tmp_path / f"{name}.{suffix}"]
        # The second begins more than a second later, which is as finely as files are dated.
        subprocess.run(command, check=True, env={**os.environ, "PYTHONHASHSEED": hashes})
    one, other = ((tmp_path / f"{name}.{suffix}").read_bytes() for name in "ab")
    assert plain(one, suffix) == plain(other, suffix)


def plain(data, suffix):
    """A file, of PDF its parts; six digits, since the last belong to the alignment of arrays."""
    if suffix == "png":
        return data
    if suffix == "svg":
        names = list(dict.fromkeys(re.findall(rb"\b[a-zA-Z][0-9a-f]{10}\b", data)))
        for number, name in enumerate(names):
            data = data.replace(name, b"name %d" % number)
        return short(data)
    assert b"CreationDate" not in data
    parts = []
    for body in re.findall(rb"stream\n(.*?)\nendstream", data, re.DOTALL):
        with suppress(zlib.error):
            body = zlib.decompress(body)
        parts.append(short(body))
    return parts


def short(text):
    return re.sub(rb"\d+\.\d{7,}", lambda number: b"%.6f" % float(number[0]), text)


def test_a_plot_shows_the_box_at_one_scale(tmp_path):
    points = tw.sample_points("dart", 100, seed=1, box=tw.Box((3, 1)))
    (axis,) = tw.plot_points(points, tmp_path / "p.png").axes
    assert (axis.get_xlim(), axis.get_ylim(), axis.get_aspect()) == ((0, 3), (1, 0), 1)
    np.testing.assert_array_equal(axis.collections[0].get_offsets(), points.points)
    assert (tmp_path / "p.png").stat().st_size > 1000


def test_windows_and_arrays_are_plotted():
    blue = tw.ready_tiles()
    window = tw.PointField(blue, tw.direct(blue.tiles, seed=7)).window(2.5, -2.5, 3, 2)
    for given in (window, window.points, window.points.tolist()):
        (axis,) = tw.plot_points(given).axes
        assert axis.get_xlim()[0] < window.points[:, 0].min()


def test_what_is_no_points_is_not_plotted(tmp_path):
    for bad, kind in (("a", TilewrightTypeError), (np.empty((0, 2)), TilewrightValueError)):
        with pytest.raises(kind):
            tw.plot_points(bad)
    with pytest.raises(TilewrightValueError, match="suffix"):
        tw.plot_points([[0.5, 0.5]], tmp_path / "p.gif")
