"""Everything says in one line what it is; what can be seen is a small picture in a notebook."""

import dataclasses
import inspect
import io
import subprocess
import sys
import types

import numpy as np
import pytest
from PIL import Image

import tilewright as tw
from handmade import handmade
from tilewright import showing
from tilewright.errors import TilewrightError

TILES = tw.corner_tiles(2)


def point_tiles(variants=1):
    rows = [[[0.25, 0.5], [0.5, 0.75]]] * (16 * variants)
    return tw.PointTiles.of(TILES, [np.array(r) for r in rows], variants=tw.Variants.uniform(TILES, variants))


def point_field():
    return tw.PointField(point_tiles(), tw.direct(TILES, seed=3))


def region():
    return tw.brick_region([[1, 1, 1], [1, 0, 1]], positions=3, seed=1)


SEEN = {
    "corner tiles": lambda: TILES,
    "Wang tiles": lambda: tw.wang_tiles(2),
    "corner-coded tiles": tw.corner_coded_tiles,
    "direct": lambda: tw.direct(TILES, seed=3),
    "torus": lambda: tw.direct(TILES, period=(3, 5)),
    "array": lambda: tw.array_tiling(TILES, np.zeros((4, 6), int)),
    "packing": lambda: tw.packing(TILES),
    "aperiodic": lambda: tw.aperiodic_tiling(tw.aperiodic_tiles()),
    "texture tiles": lambda: handmade(TILES, 32),
    "float texture tiles": lambda: handmade(TILES, 16, np.float32, 1, maps=2),
    "gray and alpha": lambda: handmade(TILES, 16, np.uint16, 2),
    "texture": lambda: tw.TextureField(handmade(TILES, 16), tw.direct(TILES)),
    "texture on an array": lambda: tw.TextureField(
        handmade(TILES, 16), tw.array_tiling(TILES, np.zeros((4, 6), int))
    ),
    "wall": lambda: tw.BrickField(region(), size=(40, 24)),
    "photo": lambda: tw.HexField(np.arange(64 * 64, dtype=np.uint16).reshape(64, 64) * 16),
    "point tiles": point_tiles,
    "points of tiles": point_field,
    "points on a torus": lambda: tw.PointField(point_tiles(), tw.direct(TILES, period=(3, 2))),
    "point set": lambda: tw.PointSet(np.random.default_rng(1).random((300, 2))),
    "point window": lambda: point_field().window(2, 3, 4, 5),
}
UNSEEN = {
    "cubes": lambda: tw.corner_cubes(2),
    "dominoes": lambda: tw.dominoes(2),
    "many tiles": lambda: tw.corner_tiles(8),
    "tiling of cubes": lambda: tw.direct(tw.corner_cubes(2)),
    "volume of points": lambda: tw.PointSet(np.zeros((3, 3)), tw.Box((1, 1, 1))),
    "no points": lambda: point_field().window(0.3, 0.3, 0.01, 0.01),
}
UNPICTURED = {
    "exemplar": lambda: tw.Exemplar([{"albedo": np.zeros((40, 64, 3), np.uint8)}]),
    "region": region,
    "bond": lambda: tw.BondBricks("herringbone", (48, 16)),
    "endless dapple": lambda: tw.endless_dappled_tiling({"H0": 3, "V1": 3}, seed=5),
    "search": lambda: tw.PackingSearch(TILES),
    "jigsaw": lambda: tw.Jigsaw(tw.packing(TILES)),
    "transducer": lambda: tw.strip(tw.wang_tiles(2), 1),
    "mixer": lambda: tw.MixerHash(2**63 + 5),
    "permutation": lambda: tw.PermutationHash(7),
    "variants": lambda: tw.Variants.uniform(TILES, 3),
    "weighted variants": lambda: tw.Variants.weighted([[1, 2]] * 16),
    "placements": lambda: tw.direct(TILES).placements(0, 0, 4, 3),
    "long period": lambda: tw.LongPeriodHash(7),
    "distribution": lambda: tw.radial_distribution(tw.PointSet(np.random.default_rng(1).random((300, 2)))),
    "closest": lambda: tw.closest_dapple(np.zeros((3, 4), np.uint8), {"H0": 2}),
}


@pytest.mark.parametrize("name", [*SEEN, *UNSEEN, *UNPICTURED])
def test_a_thing_says_in_one_line_what_it_is(name):
    thing = (SEEN | UNSEEN | UNPICTURED)[name]()
    line = repr(thing)
    assert type(thing).__name__.removeprefix("Ruled").removeprefix("Listed") in line
    assert "\n" not in line
    assert len(line) < 260
    assert "array(" not in line
    assert " at 0x" not in line


def test_lines_hold_what_matters():
    lines = {
        repr(SEEN["texture tiles"]()): ("16 corner tiles", "of 32 x 32 pixels", "map0 (uint8, 3 channels)"),
        repr(SEEN["texture on an array"]()): ("map0 (uint8, 3 channels)", "rectangle 0 to 95 x 0 to 63"),
        repr(SEEN["torus"]()): ("16 corner tiles", "torus 3 x 5"),
        repr(point_tiles(2)): ("2 points each", "2 variants", "method given"),
        repr(UNPICTURED["weighted variants"]()): ("32 of 16 tiles", "weighted"),
        repr(SEEN["point set"]()): ("300 points", "torus 1 x 1"),
        repr(UNPICTURED["mixer"]()): ("seed 9223372036854775813",),
        repr(UNPICTURED["exemplar"]()): ("64 x 40 pixels", "albedo (color)"),
    }
    for line, words in lines.items():
        assert all(word in line for word in words), line


@pytest.mark.parametrize("name", sorted(tw.__all__))
def test_every_public_class_has_a_line_of_its_own(name):
    kind = getattr(tw, name)
    if not inspect.isclass(kind) or issubclass(kind, Exception):
        return
    assert kind.__repr__ is not object.__repr__
    if dataclasses.is_dataclass(kind):
        arrays = [f.name for f in dataclasses.fields(kind) if "ndarray" in str(f.type)]
        assert not arrays or not _is_generated(kind), arrays


def _is_generated(kind):
    """Whether a dataclass wrote the line, with every array in it."""
    assert hasattr(tw.Box.__repr__, "__wrapped__"), "Python writes the lines of dataclasses in another way"
    return hasattr(kind.__repr__, "__wrapped__")


@pytest.mark.parametrize("name", SEEN)
def test_notebooks_show_a_small_picture(name):
    png = SEEN[name]()._repr_png_()
    image = Image.open(io.BytesIO(png))
    assert image.format == "PNG"
    assert 16 <= image.width <= 640
    assert 16 <= image.height <= 400
    assert len(np.unique(np.asarray(image.convert("RGB")).reshape(-1, 3), axis=0)) > 1


@pytest.mark.parametrize("name", UNSEEN)
def test_what_cannot_be_seen_has_no_picture(name):
    assert UNSEEN[name]()._repr_png_() is None


def test_dots_lie_where_points_are():
    points = tw.PointSet(np.array([[0.25, 0.5], [0.75, 0.125]]), tw.Box((1, 1)))
    shown = np.asarray(Image.open(io.BytesIO(points._repr_png_())).convert("L"))
    assert shown.shape == (400, 400)
    assert shown[200, 100] == shown[50, 300] == 0
    assert (shown < 255).sum() < 100


def test_arrays_are_what_numpy_sees():
    points = SEEN["point set"]()
    assert np.array_equal(np.asarray(points), points.points)
    assert np.asarray(points, np.float32).dtype == np.float32
    assert np.shares_memory(np.asarray(points), points.points)
    window = point_field().window()
    assert np.array_equal(np.asarray(window), window.points)
    assert len(window) == len(window.points)
    laid = SEEN["array"]()
    assert np.array_equal(np.asarray(laid), laid.cells)
    material = handmade(TILES, 16)
    assert np.array_equal(np.asarray(material), material.pixels)
    with pytest.raises(TilewrightError, match=r"have maps map0, map1; take one of them, as maps\['map0'\]"):
        np.asarray(handmade(TILES, 16, maps=2))


def test_pictures_can_be_asked_for():
    assert tw.paint_png(TILES) == TILES._repr_png_()
    assert tw.paint_png("something else") is None


def test_painters_load_with_the_first_picture(monkeypatch):
    code = (
        "import sys; import tilewright as tw; tiles = tw.corner_tiles(2); repr(tiles); "
        "assert 'tilewright.export' not in sys.modules; assert tiles._repr_png_()[:4] == b'\\x89PNG'"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
    monkeypatch.setattr(showing, "painter", None)
    assert TILES._repr_png_() is None


def test_tiles_are_saved_and_loaded_by_their_own_methods(tmp_path):
    textures, points = handmade(TILES), point_tiles()
    textures.save(tmp_path / "t")
    points.save(tmp_path / "p")
    assert tw.TextureTiles.load(tmp_path / "t") == textures
    assert tw.PointTiles.load(tmp_path / "p") == points
    with pytest.raises(TilewrightError, match="holds PointTiles; TextureTiles were asked for"):
        tw.TextureTiles.load(tmp_path / "p")


def test_things_show_themselves(monkeypatch):
    shown = []
    monkeypatch.setattr(Image.Image, "show", lambda image, title: shown.append((image.size, title)))
    TILES.show()
    assert shown == [(tw_size(TILES), repr(TILES))]
    with pytest.raises(TilewrightError, match="has no picture"):
        tw.corner_cubes(2).show()


def tw_size(thing):
    return Image.open(io.BytesIO(thing._repr_png_())).size


def test_notebooks_show_things_below_the_cell(monkeypatch):
    shown = []
    shell = types.SimpleNamespace(kernel=object())
    display = types.ModuleType("IPython.display")
    display.Image, display.display = (lambda data: data), shown.append
    ipython = types.ModuleType("IPython")
    ipython.get_ipython, ipython.display = (lambda: shell), display
    monkeypatch.setitem(sys.modules, "IPython", ipython)
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    TILES.show()
    assert shown == [TILES._repr_png_()]
