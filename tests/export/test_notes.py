"""What an output leaves out of its material is said."""

import pytest

import tilewright as tw


def test_two_photographs_lie_by_chance_in_engines_and_pages(tmp_path, gravel):
    made = tw.texture_tiles(gravel[:96, :96], tw.corner_tiles(2), second=gravel[96:192, :96], tile_size=16)
    with pytest.warns(tw.TilewrightWarning, match="lie by chance in engines"):
        tw.save_for_engine(made, tmp_path / "e", "glsl")
    with pytest.warns(tw.TilewrightWarning, match="lie by chance in the page"):
        tw.save_viewer(made, tmp_path / "v.html")
