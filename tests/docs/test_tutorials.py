"""The tutorials run from the first block to the last, and show pictures that they make."""

import warnings

import numpy as np
import pytest
from PIL import Image

from run_tutorials import PAGES, check_lines, pictures, run_page

LARGEST = 150_000
"""Bytes of a picture on a page."""


@pytest.mark.pages
@pytest.mark.parametrize("name", PAGES)
def test_a_tutorial_makes_what_it_shows(name, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    pytest.importorskip("pyarrow")
    monkeypatch.setattr(warnings, "showwarning", warnings.showwarning)  # the program sets its own
    run_page(PAGES[name], tmp_path)
    assert pictures(PAGES[name])
    for picture in pictures(PAGES[name]):
        made = tmp_path / picture.name
        assert picture.stat().st_size < LARGEST
        if picture.suffix == ".svg":
            assert made.read_text("utf-8") == picture.read_text("utf-8")
        else:
            shown, again = (np.asarray(Image.open(path).convert("RGB"), float) for path in (picture, made))
            assert abs(shown - again).mean() < 2, f"{picture.name} is old; run tools/run_tutorials.py"


@pytest.mark.parametrize(
    ("shown", "printed"),
    [
        ("two 1.02", "one\n  two   1.0\n"),
        ("a: 1,000 points in 3 s", "a: 1,000 points in 0.1 s"),
        ("one\n...\nthree", "one\ntwo\nthree"),
    ],
)
def test_lines_agree(shown, printed):
    check_lines(shown, printed)


@pytest.mark.parametrize(
    ("shown", "printed"), [("two 1.2", "two 1.0"), ("two", "one"), ("b\na", "a\nb"), ("a", "")]
)
def test_lines_differ(shown, printed):
    with pytest.raises(AssertionError, match="the page shows"):
        check_lines(shown, printed)
