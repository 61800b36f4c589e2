"""What an output leaves out of its material is said."""

import pytest

import tilewright as tw
from tilewright import jobs


def test_two_photographs_lie_by_chance_in_engines_and_pages(tmp_path, gravel):
    made = tw.texture_tiles(gravel[:96, :96], tw.corner_tiles(2), second=gravel[96:192, :96], tile_size=16)
    made.save(tmp_path / "set")
    with pytest.warns(tw.TilewrightWarning, match="lie by chance in engines"):
        jobs.ExportJob(folder=tmp_path / "set", to="glsl", output=tmp_path / "e").run()
    with pytest.warns(tw.TilewrightWarning, match="lie by chance in the page"):
        jobs.ViewJob(folder=tmp_path / "set", output=tmp_path / "v.html").run()
