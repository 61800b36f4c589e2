"""Walls: bricks where the tiles say, painted alike in every window."""

import xml.etree.ElementTree as ET
from itertools import product

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightError
from tilewright.export.drawing.walls import draw_wall
from tilewright.fields.bricks.bonds import ALIASES, BONDS, BondBricks
from tilewright.fields.bricks.field import MAPS, BrickField
from tilewright.fields.bricks.patterns import WangBricks
from tilewright.fields.bricks.relief import MARGIN, light
from tilewright.signals.bricks.style import BrickStyle
from tilewright.tiles.bricks import brick_tiles
from tilewright.tilings import MixerHash
from tilewright.tilings.bricks import brick_region
from walls import SMALL, WALLS, Draughtboard, plain


@pytest.mark.parametrize("wall", WALLS)
def test_a_window_shows_what_any_other_shows(wall, monkeypatch):
    x, y = (-77, -31) if wall == "herringbone" else (10**15 + 7, -(10**15) - 5)
    field = BrickField(WALLS[wall](), seed=3)
    whole = field.render_maps(x, y, 90, 70)
    assert set(whole) == set(MAPS)
    for left, top, width, height in ((13, 29, 71, 41), (89, 0, 1, 70)):
        part = field.render_maps(x + left, y + top, width, height)
        for name in MAPS:
            assert np.array_equal(part[name], whole[name][top : top + height, left : left + width]), name
    lit = field.render(x, y, 90, 70)
    assert np.array_equal(field.render(x + 20, y + 9, 33, 22), lit[9:31, 20:53])
    monkeypatch.setattr("tilewright.fields.bricks.field._BLOCK", 16 * 64)
    for name, pixels in field.render_maps(x, y, 90, 70).items():
        assert np.array_equal(pixels, whole[name]), name


def corner_at(tile, places, x, y):
    """The corner (x, y: 0 or 1) of a tile in whose brick a pixel lies, by the lines of the tile."""
    north, east, south, west = (places[n % 2][color] for n, color in enumerate(tile))
    if tile[1] == tile[3]:
        below = y >= west
        return int(x >= (south if below else north)), int(below)
    right = x >= north
    return int(right), int(y >= (east if right else west))


@pytest.mark.parametrize(("count", "size"), [(2, (30, 31)), (3, (16, 12)), (5, (24, 13))])
@pytest.mark.parametrize(("x", "y"), [(-40, -17), (2**59 + 5, -(2**60) + 3)])
def test_each_pixel_belongs_to_the_brick_that_its_tile_says(count, size, x, y):
    tiling = Draughtboard(count)
    wall = WangBricks(tiling, size)
    ids = BrickField(wall, plain(mortar=1)).render(x, y, 60, 50, map="id")
    for j, i in product(range(0, 50, 3), range(60)):
        (cell_x, at_x), (cell_y, at_y) = divmod(x + i, size[0]), divmod(y + j, size[1])
        slots = tiling.tiles.slots[tiling.indices(cell_x, cell_y, 1, 1)[0, 0]]
        corner = corner_at(slots, wall.places, at_x, at_y)
        assert ids[j, i].tolist() == [cell_x + corner[0], cell_y + corner[1]]


@pytest.mark.parametrize("wall", WALLS)
def test_bricks_leave_nothing_free_and_do_not_overlap(wall):
    pattern = WALLS[wall]()
    index, found = pattern.locate(-95, 61, 300, 200)
    west, north, east, south = found.sides.T
    y, x = np.indices(index.shape)
    inside = (west[index] <= x) & (x < east[index]) & (north[index] <= y) & (y < south[index])
    assert inside.all()
    assert np.bincount(index.ravel(), minlength=len(west)).min() > 0
    shown = (east.clip(0, 300) - west.clip(0, 300)) * (south.clip(0, 200) - north.clip(0, 200))
    assert shown.sum() == index.size
    assert pattern.thinnest <= min((east - west).min(), (south - north).min())
    assert len(np.unique(found.ids, axis=0)) == len(found.ids) or pattern.domain.periods[0]


def test_bonds_are_of_the_bricks_they_are_named_after():
    def sizes(bond):
        sides = BondBricks(bond, (48, 16)).bricks(5, 5, 400, 400).sides
        return set(map(tuple, (sides[:, 2:] - sides[:, :2]).tolist()))

    assert sizes("running-bond") == {(48, 16)}
    assert sizes("flemish-bond") == {(48, 16), (24, 16)}
    assert sizes("herringbone") == sizes("basket-weave") == {(48, 16), (16, 48)}


@pytest.mark.parametrize("bond", ["running-bond", "flemish-bond"])
def test_joints_lie_over_the_middle_of_bricks(bond):
    found = BondBricks(bond, (48, 16)).bricks(-200, -60, 400, 120)
    middle = {(west + east, north) for west, north, east, _ in found.sides.tolist()}
    for west, _, east, south in found.sides.tolist():
        # Headers over the middle of stretchers; in running bond joints over the middle of bricks.
        x = west + east if bond == "flemish-bond" else 2 * east
        if 100 < x < 700 and south < 120:
            assert (x, south) in middle


def runs(row):
    """Lengths of the runs of True that begin and end within a row."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], row, [False]]).astype(int)))
    lengths = edges[1::2] - edges[::2]
    return set(lengths[(edges[::2] > 0) & (edges[1::2] < len(row))].tolist())


@pytest.mark.parametrize("mortar", [1, 2, 3, 6, 9])
def test_mortar_is_as_wide_as_asked(mortar):
    field = BrickField(BondBricks("running-bond", SMALL), plain(mortar=mortar))
    joints = field.render(0, 0, 300, 200, map="mortar")[..., 0] > 0
    assert runs(joints[36]) == {mortar}
    assert runs(joints[:, 12]) == {mortar}
    worn = BrickField(BondBricks("running-bond", SMALL), BrickStyle(mortar=mortar))
    uneven = worn.render(0, 0, 300, 200, map="mortar")[..., 0] > 0
    assert abs(uneven.mean() - joints.mean()) < 0.05
    assert mortar < 3 or (uneven != joints).any()


@pytest.mark.parametrize("wall", ["wang", "herringbone"])
def test_normals_are_those_of_the_heights(wall):
    field = BrickField(WALLS[wall](), BrickStyle(relief=5.0))
    height = field.render(-9, 7, 150, 120, map="height")[..., 0] * (5.0 / 65535)
    normal = field.render(-8, 8, 148, 118, map="normal").astype(float)
    east, south = (height[1:-1, 2:] - height[1:-1, :-2]) / 2, (height[2:, 1:-1] - height[:-2, 1:-1]) / 2
    vectors = np.stack([-east, south, np.ones_like(east)], axis=-1)
    vectors /= np.linalg.norm(vectors, axis=-1, keepdims=True)
    assert np.abs(vectors * 127.5 + 127.5 - normal).max() < 0.6
    assert height.std() > 0.3


def test_bricks_stand_above_mortar_and_differ():
    field = BrickField(WALLS["wang"]())
    maps = field.render_maps(0, 0, 400, 300)
    joint = maps["mortar"][..., 0] > 0
    assert maps["height"][~joint].mean() > maps["height"][joint].mean() + 15000
    assert maps["roughness"][joint].mean() > maps["roughness"][~joint].mean()
    tones = field.tones(field.bricks(0, 0, 400, 300))
    assert len(np.unique(tones, axis=0)) > 50
    index, found = field.pattern.locate(0, 0, 400, 300)
    face = ~joint & (np.bincount(index.ravel(), minlength=len(found.ids)) > 500)[index]
    inner = [maps["color"][face & (index == k)].mean(axis=0) for k in np.unique(index[face])]
    assert np.abs(np.array(inner) - tones[np.unique(index[face])]).max() < 25


def test_light_falls_from_the_north_west():
    side = 2 * MARGIN + 40
    height = np.zeros((side, side, 1), np.uint16)
    height[MARGIN + 10 : MARGIN + 20, MARGIN + 10 : MARGIN + 20] = 65535  # a block of 5 pixels
    maps = {"color": np.full((side, side, 3), 128, np.uint8), "height": height}
    maps["normal"] = np.full((side, side, 3), (128, 128, 255), np.uint8)
    lit = light(maps, 5.0)[..., 1].astype(int)
    sunny, sky = 0.97 * 0.50 / np.linalg.norm([0.60, 0.62, 0.50]) + 0.39, 0.39
    linear = ((128 / 255 + 0.055) / 1.055) ** 2.4
    expected = [255 * (1.055 * (linear * share) ** (1 / 2.4) - 0.055) for share in (sunny, sky)]
    assert abs(lit[2, 2] - expected[0]) < 2
    assert abs(lit[15, 15] - expected[0]) < 2
    assert (lit[20:24, 14:20] < expected[1]).all()  # in its shadow, where it also hides the sky
    assert abs(lit[27, 27] - expected[0]) < 2
    assert lit[8, 14] > lit[21, 16] + 30


def test_a_seed_makes_a_wall_and_another_one_another():
    first, again, other = (BrickField(WALLS["wang"](), seed=s).render_maps(0, 0, 60, 60) for s in (1, 1, 2))
    assert all(np.array_equal(first[name], again[name]) for name in MAPS)
    assert not any(np.array_equal(first[name], other[name]) for name in ("color", "height", "normal"))
    assert np.array_equal(first["id"], other["id"])


@pytest.mark.parametrize(
    ("pattern", "size"),
    [
        (WangBricks(Draughtboard(3, (12, 12)), (20, 12)), (240, 144)),
        (WangBricks(Draughtboard(2, (4, 4)), (40, 30)), (160, 120)),
        (BondBricks("running-bond", (40, 16), (2, 4)), (80, 64)),
        (BondBricks("flemish-bond", (40, 16), (3, 2)), (120, 32)),
        (BondBricks("herringbone", (32, 16), (2, 4)), (64, 64)),
        (BondBricks("basket-weave", (32, 16), (4, 4)), (128, 64)),
    ],
)  # fmt: skip
def test_a_closed_wall_can_be_repeated(pattern, size):
    field = BrickField(pattern)
    maps = field.render_maps(-7, 11, *size)
    for name, pixels in field.render_maps(-7 + 3 * size[0], 11 - 5 * size[1], *size).items():
        assert np.array_equal(pixels, maps[name]), name


def test_a_wall_that_ends_is_cut_at_its_rim():
    cells = Draughtboard().indices(0, 0, 6, 5)
    part = BrickField(tw.array_tiling(brick_tiles(3), cells), size=SMALL)
    whole = BrickField(Draughtboard(), size=SMALL)
    width, height = 6 * SMALL[0], 5 * SMALL[1]
    ours, theirs = part.render_maps(0, 0, width, height), whole.render_maps(0, 0, width, height)
    assert np.array_equal(ours["id"], theirs["id"])
    inner = (slice(24, -24), slice(48, -48))
    assert np.array_equal(ours["color"][inner], theirs["color"][inner])
    assert not ours["mortar"][:, 0].all()
    assert part.render(0, 0, width, height).shape == (height, width, 3)
    with pytest.raises(TilewrightError, match="x is 1; allowed are 0 to 0"):
        part.render_maps(1, 0, width, height)


def test_a_wall_with_holes_shows_them():
    y, x = np.mgrid[:7, :6]
    region = brick_region((y != 3) | (x < 2), 3, seed=1)
    field = BrickField(region, size=SMALL)
    maps = field.render_maps(0, 0, 288, 168)
    covered = np.kron(region.cells >= 0, np.ones(SMALL[::-1], bool))
    assert np.array_equal(maps["color"][..., 3] == 255, covered)
    assert np.array_equal((maps["id"] < 0).any(axis=2), ~covered)
    assert np.array_equal(field.render(0, 0, 288, 168)[..., 3] == 255, covered)
    for (cell_y, cell_x), tile in np.ndenumerate(region.cells):
        if tile >= 0:
            for at_x, at_y in product(range(2, 48, 9), range(2, 24, 5)):
                corner = corner_at(region.tiles.slots[tile], field.pattern.places, at_x, at_y)
                found = maps["id"][24 * cell_y + at_y, 48 * cell_x + at_x]
                assert found.tolist() == [cell_x + corner[0], cell_y + corner[1]]
    part = field.render_maps(150, 70, 60, 50)
    for name, pixels in part.items():
        assert np.array_equal(pixels, maps[name][70:120, 150:210]), name
    assert not field.render(200, 75, 40, 20, map="color").any()
    clip = ET.fromstring(draw_wall(field, 0, 0, 288, 168))[0][0].get("d")
    corners = np.array([[[float(n) for n in point.split()] for point in path.strip("Z").split("L")]
                        for path in clip[1:].split("M")])  # fmt: skip
    assert np.ptp(corners, axis=1).prod(axis=1).sum() == covered.sum()


def test_lattice_words_are_those_of_the_hash():
    from tilewright.kernels.brick_drawing import fill_lattice_words
    from tilewright.tilings.hashes import split_row

    x, y = np.arange(2**32 - 3, 2**32 + 4), np.array([-5, 2**40])
    out = np.empty((2, 7), np.uint32)
    fill_lattice_words(*split_row(x), y, 9, 13, MixerHash(6).seed, out)
    assert np.array_equal(out, MixerHash(6).words(13, x, y[:, np.newaxis], 9))


def slow_noise(words, dx, dy, key, field):
    """Gradient noise between four lattice points, in plain Python."""

    def value(word, x, y):
        for shift, factor in ((16, 0x21F0AAAD), (15, 0xD35A2D97)):
            word = (word ^ key if shift == 16 else word) & 0xFFFFFFFF
            word = (word ^ word >> shift) * factor % 2**32
        word ^= word >> 15
        parts = [(word >> (10 * field + n) & 31) / 15.5 - 1 for n in (0, 5)]
        return parts[0] * x + parts[1] * y

    u, v = (t**3 * (6 * t * t - 15 * t + 10) for t in (dx, dy))
    north = value(words[0], dx, dy) * (1 - u) + value(words[1], dx - 1, dy) * u
    south = value(words[2], dx, dy - 1) * (1 - u) + value(words[3], dx - 1, dy - 1) * u
    return north * (1 - v) + south * v


def test_noise_is_that_of_a_slow_twin():
    from tilewright.kernels.brick_drawing import roughen_span
    from tilewright.signals.bricks.painting import lay_noise

    rng, found = np.random.default_rng(3), {}

    def words(octave, points, at):
        found[octave] = rng.integers(2**32, size=at[:1:-1], dtype=np.uint32)
        return found[octave]

    noise = lay_noise(words, (48, 24), (17, 5), (60, 9))
    out, weights = np.zeros((3, 60), np.float32), noise.weights
    row, key = 4, 0xABCDEF01
    near = noise._replace(rows=noise.rows[row], south=noise.south[row])
    roughen_span(10, 50, np.uint32(key), near, out)
    for j, field in ((10, 0), (23, 1), (37, 2), (49, 2)):
        total = 0.0
        for octave, (points_x, points_y) in enumerate([(16, 8), (8, 4), (4, 2)]):
            x, y = (17 + j + 0.5) * points_x / 48, (5 + row + 0.5) * points_y / 24
            first_x, first_y = (int(17.5 * points_x / 48), int(5.5 * points_y / 24))
            i, k = int(x) - first_x, int(y) - first_y
            four = found[octave][k : k + 2, i : i + 2].ravel().tolist()
            total += weights[octave, field] * slow_noise(four, x % 1, y % 1, key, field)
        assert out[field, j] == pytest.approx(total, abs=1e-5)
    assert not out[:, :10].any()


def test_bonds_are_known_by_the_names_people_use():
    named = BondBricks("stretcher-bond", (48, 16)).bricks(0, 0, 100, 100)
    assert (named.sides == BondBricks("running-bond", (48, 16)).bricks(0, 0, 100, 100).sides).all()
    assert set(ALIASES.values()) <= set(BONDS)
    assert not set(ALIASES) & set(BONDS)
    with pytest.raises(
        TilewrightError, match=r"herringbone-45.*herringbone, basket-weave; or by another name"
    ):
        BondBricks("herringbone-45")
