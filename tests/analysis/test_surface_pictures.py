"""Pictures of surfaces against a plain rasterizer and what can be counted on them."""

from math import pi, sqrt

import numpy as np
import pytest

from small_surfaces import box, grid, random_spots, spots_at, torus
from tilewright.analysis.surfaces.creases import corner_normals
from tilewright.analysis.surfaces.pictures import draw_surface
from tilewright.errors import TilewrightError, TilewrightTypeError, TilewrightValueError
from tilewright.kernels.rasterizing import rasterize
from tilewright.kernels.threads import at_most

FRONT = {"view": (0, 0), "width": 100, "height": 100}


def plainly(corners, rows, columns):
    """Number and height of what is seen, by looking at every triangle at every pixel."""
    y, x = np.mgrid[:rows, :columns] + 0.5
    numbers, heights = np.full((rows, columns), -1), np.full((rows, columns), -np.inf)
    for t, (a, b, c) in enumerate(corners):
        sides = np.array([[a[0], b[0], c[0]], [a[1], b[1], c[1]], [1, 1, 1]])
        weights = np.linalg.solve(sides, np.stack([x, y, np.ones_like(x)]).reshape(3, -1))
        height = (weights.T @ (a[2], b[2], c[2])).reshape(rows, columns)
        nearer = (weights.min(axis=0) >= -1e-12).reshape(rows, columns) & (height > heights)
        numbers[nearer], heights[nearer] = t, height[nearer]
    return numbers, heights


def drawn(corners, rows, columns):
    depths, numbers = np.full((rows, columns), -np.inf), np.full((rows, columns), -1, np.int32)
    weights = np.zeros((rows, columns, 3))
    rasterize(rows, corners, depths, numbers, weights)
    return numbers, depths, weights


def test_every_pixel_shows_the_nearest_triangle():
    corners = np.random.default_rng(3).random((60, 3, 3)) * (70, 50, 10) - (10, 10, 0)
    numbers, heights = plainly(corners, 37, 53)
    found, depths, weights = drawn(corners, 37, 53)
    assert (found == numbers).all()
    assert depths[numbers >= 0] == pytest.approx(heights[numbers >= 0])
    y, x = np.nonzero(numbers >= 0)
    at = np.einsum("nk,nkd->nd", weights[y, x], corners[found[y, x]])
    assert at[:, :2] == pytest.approx(np.stack([x, y], 1) + 0.5)
    with at_most(1):
        assert (drawn(corners, 37, 53)[0] == found).all()


def test_triangles_that_meet_leave_no_gap():
    sheet = grid(9, 7)
    shown = draw_surface(sheet, ground="dark", colors=(1.0, 1.0, 1.0), **FRONT)
    covered = (shown > 100).all(axis=2)
    assert covered[6:94, 6:94].all()
    assert not covered[:4].any()
    assert covered.sum() == pytest.approx(90**2, rel=0.02)


def test_the_eye_is_where_the_view_says():
    cube = box()
    colors = np.zeros((12, 3))
    # Sides in turn: below, above along z, then y = 0, y = 1, x = 0, x = 1.
    for side, color in enumerate([(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 0, 1), (0, 1, 1)]):
        colors[2 * side : 2 * side + 2] = color

    def middle(view, up):
        return (
            draw_surface(cube, view=view, up=up, colors=colors, width=20, height=20)[10, 9] > 100
        ).tolist()

    assert middle((0, 0), "y") == [0, 1, 0]
    assert middle((90, 0), "y") == [0, 1, 1]
    assert middle((0, 90), "y") == [1, 1, 0]
    assert middle((0, 0), "z") == [0, 0, 1]
    assert middle((90, 0), "z") == [0, 1, 1]
    assert middle((0, 90), "z") == [0, 1, 0]


def test_disks_have_their_radius():
    sheet = grid(3, 3)
    spots = spots_at(sheet, [(0.5, 0.5, 0)])
    r_max = 1 / sqrt(2 * sqrt(3))
    bare = draw_surface(sheet, **FRONT).astype(float)
    shown = draw_surface(sheet, spots, dots=0.4, dot_colors=(0.0, 0.0, 0.0), **FRONT)
    dark = (bare - shown).sum() / bare[50, 50].sum()
    assert dark == pytest.approx(pi * (0.4 * r_max * 90) ** 2, rel=0.08)
    assert (shown[50, 50] == 0).all()
    assert (shown[10, 10] == bare[10, 10]).all()


def test_points_on_the_other_side_of_a_thin_plate_do_not_show():
    plate = box(1, 1, 0.001)
    spots = spots_at(plate, [(0.3, 0.3, 0.001), (0.7, 0.7, 0)])
    shown = draw_surface(plate, spots, dots=0.2, up="y", **FRONT)
    assert (shown[95 - 27, 32] < 60).all()
    assert (shown[95 - 63, 68] > 100).all()
    # The nearest point is on the other side, and one on this side is near enough.
    close = spots_at(plate, [(0.3, 0.3, 0.001), (0.31, 0.3, 0)])
    assert (draw_surface(plate, close, dots=0.2, **FRONT)[95 - 27, 33] < 60).all()


def test_colors_may_be_given_in_every_form():
    sheet = grid(2, 2)
    pictures = [
        draw_surface(sheet, colors=colors, **FRONT)
        for colors in (
            "#ff8000",
            (255, 128, 0),
            np.array([1, 128 / 255, 0]),
            np.tile([255, 128, 0], (9, 1)),
            np.tile([255, 128, 0], (8, 1)),
            lambda triangles, weights: np.tile([1, 128 / 255, 0], (len(triangles), 1)),
        )
    ]
    for picture in pictures[1:]:
        assert abs(picture.astype(int) - pictures[0]).max() <= 1
    halves = np.zeros((8, 3)) + sheet.vertices[sheet.triangles].mean(axis=1)[:, :1].round()
    assert draw_surface(sheet, colors=halves, **FRONT)[50, [20, 80]].min(axis=1).tolist() == [0, 235]
    mixed = draw_surface(sheet, colors=np.repeat(sheet.vertices[:, :1], 3, axis=1), **FRONT)[50, :, 0]
    assert (np.diff(mixed[8:92].astype(int)) >= 0).all()


def test_creases_stay_and_round_parts_look_round():
    cube, ring = box(), torus(48, 24)
    assert corner_normals(cube, False) == pytest.approx(corner_normals(cube, True))
    around = ring.vertices[ring.triangles]
    center = around * (1, 1, 0)
    center /= np.linalg.norm(center, axis=2, keepdims=True)
    exact = (around - center) / 0.4
    smooth = np.einsum("tkd,tkd->tk", corner_normals(ring, False), exact)
    assert smooth.min() > np.cos(np.radians(2))
    assert np.einsum("tkd,tkd->tk", corner_normals(ring, True), exact).min() < np.cos(np.radians(5))
    fan = grid(1, 1)
    assert corner_normals(fan, False) == pytest.approx(np.broadcast_to([0, 0, 1.0], (2, 3, 3)))


def test_large_pictures_are_drawn_in_bands(monkeypatch):
    from tilewright.analysis.surfaces import pictures

    spots = random_spots(torus(), 100)
    whole = draw_surface(torus(), spots, width=60, height=50)
    monkeypatch.setattr(pictures, "_BAND", 1000)
    assert (draw_surface(torus(), spots, width=60, height=50) == whole).all()


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ({"width": 0}, "width is 0"),
        ({"view": 3}, "view must be two numbers"),
        ({"view": (0, 91)}, "elevation is 91"),
        ({"up": "x"}, "up is 'x'"),
        ({"ground": "red"}, "ground is 'red'"),
        ({"shading": True}, "shading is True"),
        ({"colors": np.zeros((5, 3))}, r"colors has shape \(5, 3\); expected \(3,\) or "),
        ({"colors": (0, 0, 300)}, "colors holds what is no color"),
        ({"colors": "red"}, "is 'red'; expected '#'"),
        ({"colors": np.array(["a", "b", "c"])}, "colors must hold numbers"),
        ({"colors": lambda triangles, weights: np.zeros(4)}, "colors has shape"),
        ({"dots": -1}, "dots is -1"),
        ({"dot_colors": np.zeros((3, 3))}, "dot_colors has shape"),
    ],
)
def test_what_cannot_be_drawn_is_refused(wrong, says):
    with pytest.raises(TilewrightError, match=says):
        draw_surface(torus(), random_spots(torus(), 10), **{"width": 10, "height": 10} | wrong)


def test_what_is_no_surface_is_refused():
    with pytest.raises(TilewrightTypeError, match="surface must be a Surface"):
        draw_surface(3)
    with pytest.raises(TilewrightTypeError, match="spots must be Spots"):
        draw_surface(torus(), 3)
    with pytest.raises(TilewrightValueError, match="at least 1"):
        draw_surface(torus(), random_spots(torus(), 10)[:0])
