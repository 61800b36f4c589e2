"""Points over meshes: as many as asked, evenly by area, the same again, exact where the mesh is flat."""

import numpy as np
import pytest
from scipy.spatial import KDTree

import tilewright as tw
from meshes import CLOSED, OPEN, cube, shared, square, torus
from tilewright.domains.medial import MedialDomain
from tilewright.domains.repair import make_sound
from tilewright.errors import TilewrightTypeError, TilewrightValueError, TilewrightWarning
from tilewright.fields.surfaces.density import Weighting
from tilewright.fields.surfaces.laying import fit_domain
from tilewright.kernels.dual_laying import find_triangles
from tilewright.sameness import same


def least(points):
    places = points.positions
    radius = np.sqrt(points.surface.area / (2 * np.sqrt(3) * len(places)))
    return KDTree(places).query(places, 2)[0][:, 1].min() / 2 / radius


@pytest.mark.parametrize("kind", ["even", "poisson", "tiles"])
@pytest.mark.parametrize("name", {**CLOSED, **OPEN})
def test_every_mesh_gets_as_many_points_as_asked_on_its_surface(name, kind):
    mesh = {**CLOSED, **OPEN}[name]
    made = tw.surface_points(mesh, 700, kind=kind, seed=3)
    assert len(made) == 700 == len(np.unique(made.positions, axis=0))
    assert made.spots.weights.min() >= 0
    assert made.spots.weights.sum(axis=1) == pytest.approx(1)
    lists = [set(face.tolist()) for face in mesh.faces]
    named = made.surface.triangles[made.spots.triangles]
    if name != "moebius":  # whose vertices are copied along the cut
        assert all(
            set(row) <= lists[face] for row, face in zip(named.tolist(), made.faces.tolist(), strict=True)
        )
    if kind != "tiles":
        assert least(made) >= 0.765 - 1e-6
        assert made.distance == pytest.approx(
            2 * 0.765 * np.sqrt(made.surface.area / (2 * np.sqrt(3) * 700)), rel=1e-3
        )
        assert made.figures["pairs_left"] == 0
    assert len(np.unique(made.places * 1000 + made.numbers)) == 700
    columns = made.columns()
    assert {len(values) for values in columns.values()} == {700}
    assert np.array_equal(np.stack([columns[axis] for axis in "xyz"], axis=1), made.positions)


def test_points_follow_area_before_and_after_they_are_refined():
    """Counts of faces against their shares: far below what chance alone would give."""
    mesh = torus()
    sound = make_sound(mesh)
    areas = np.bincount(sound.cut.faces, sound.cut.surface.areas)
    for kind in ("tiles", "even"):
        made = tw.surface_points(mesh, 6000, kind=kind)
        wanted = 6000 * areas / areas.sum()
        found = np.bincount(made.faces, minlength=len(mesh))
        assert ((found - wanted) ** 2 / wanted).mean() < 0.35


def test_tiles_on_a_flat_even_mesh_keep_the_distance_of_their_set():
    """Nine of ten points of all tiles, whose sides join the middles of sides of squares."""
    made = tw.surface_points(square(8), round(0.9 * 64 * 2 * 32), kind="tiles")
    assert made.figures["level"] == 0
    distance = tw.dual_point_tiles(2, 32, 0.7).distance * np.sqrt(2) / 2 / 8
    assert KDTree(made.positions).query(made.positions, 2)[0][:, 1].min() >= distance - 1e-7


def test_the_brick_of_figure_9_has_the_distance_of_its_set():
    """Twelve tiles of three corners and four of five; no point is left out."""
    mesh = shared("t_brick_k1.obj")
    made = tw.surface_points(mesh, 22 * 2 * 32, kind="tiles")
    found = tw.analyze_surface(made.surface, made.spots)
    assert found.certain
    assert found.rho_surface * found.r_max >= tw.dual_point_tiles(2, 32).distance / 2 * np.sqrt(0.5) - 1e-6


def test_fewer_points_are_some_of_the_same():
    mesh = torus()
    many = tw.surface_points(mesh, 7900, kind="tiles", seed=5)
    few = tw.surface_points(mesh, 7000, kind="tiles", seed=5)
    assert fit_domain(MedialDomain.of(make_sound(mesh)), 7900, None)[1] == 24
    names = [set(zip(p.places.tolist(), p.numbers.tolist(), strict=True)) for p in (many, few)]
    assert len(names[1] - names[0]) < 0.02 * 7000
    assert np.array_equal(many.ranks, np.sort(many.ranks))


def test_the_same_seed_gives_the_same_points_and_another_others():
    mesh = cube()
    one, two, other = (tw.surface_points(mesh, 400, seed=s) for s in (1, 1, 2))
    assert one == two
    assert not same(one.spots, other.spots)
    again = tw.surface_points(mesh, 400, seed=np.random.default_rng(1))
    assert same(again.spots, tw.surface_points(mesh, 400, seed=np.random.default_rng(1)).spots)


def test_a_radius_stands_for_a_count():
    made = tw.surface_points(square(), radius=0.02, kind="even")
    assert len(made) == int(0.765**2 / (2 * np.sqrt(3) * 0.02**2))
    assert made.distance >= 2 * 0.02 - 1e-9


@pytest.mark.parametrize("way", ["vertices", "faces", "picture", "function"])
def test_points_follow_a_density(way):
    """Twice as dense on the right: two of three points lie there, whichever way it is told."""
    mesh = square(8)
    density = {
        "vertices": 1.0 + (mesh.vertices[:, 0] > 0.5),
        "faces": 1.0 + (np.arange(64) % 8 >= 4),
        "picture": np.tile(np.repeat([1.0, 2.0], 32), (64, 1)),
        "function": lambda places: 1.0 + (places[:, 0] > 0.5),
    }[way]
    if way == "picture":
        mesh = tw.Mesh(mesh.vertices, mesh.corners, mesh.starts, mesh.vertices[mesh.corners][:, :2])
    made = tw.surface_points(mesh, 3000, density=density, kind="tiles")
    share = (made.positions[:, 0] > 0.5).mean()
    assert share == pytest.approx(2 / 3, abs=0.015 if way != "vertices" else 0.03)
    even = tw.surface_points(mesh, 3000, density=density)
    assert (even.positions[:, 0] > 0.5).mean() == pytest.approx(share, abs=0.03)


def test_a_steep_density_has_its_counts_in_every_band():
    mesh = square(8)
    made = tw.surface_points(mesh, 8000, density=lambda p: 64 ** p[:, 0], kind="tiles")
    bands = np.histogram(made.positions[:, 0], 8, (0, 1))[0]
    wanted = 8000 * np.diff(64 ** np.linspace(0, 1, 9)) / 63
    assert bands == pytest.approx(wanted, rel=0.06, abs=10)


def test_with_a_density_the_promise_is_that_of_the_densest_place():
    """Even where one face spans all of it: distances follow, and none is below what is promised."""
    made = tw.surface_points(square(1), 2000, density=lambda p: 64 ** p[:, 0])
    places = made.positions
    near, who = KDTree(places).query(places, 2)
    assert 0 < made.distance <= near[:, 1].min()
    wanted = np.sqrt(63 / np.log(64) / 64 ** places[:, 0] / (2 * np.sqrt(3) * 2000))
    reached = near[:, 1] / (wanted + wanted[who[:, 1]])
    assert reached.min() == pytest.approx(0.765, abs=0.005)
    assert made.figures["rho"] == pytest.approx(0.765, abs=0.002)


def test_a_picture_is_read_between_pixels_with_v_up():
    mesh = square(1)
    mesh = tw.Mesh(mesh.vertices, mesh.corners, mesh.starts, mesh.vertices[mesh.corners][:, :2])
    sound = make_sound(mesh)
    weighting = Weighting.of(mesh, sound, np.array([[4.0, 0], [1, 0]]))
    domain = MedialDomain.of(sound)
    spots = domain.lift(np.zeros(3, int), np.array([(0.25, 0.25), (0.25, 0.75), (0.5, 0.25)]))
    assert weighting.at(spots) == pytest.approx([1, 4, 0.5])


def test_triangles_below_places_are_found():
    sides = np.array([[(0, 0), (1, 0), (1, 1)], [(0, 0), (1, 1), (0, 1)]], float)
    uv = np.array([(0.7, 0.2), (0.2, 0.7), (0.5, 0.5), (-0.1, 0.4)])
    found = np.empty(4, np.int64)
    find_triangles(4, np.zeros(4, np.int64), uv, np.array([0, 2]), sides, found)
    assert found.tolist() == [0, 1, 0, 1]


def test_points_that_people_bring_are_spread():
    rng = np.random.default_rng(1)
    given = rng.random((300, 3)) * (1, 1, 0)
    made = tw.refine_points(square(), given)
    assert made.notes == ()
    assert (made.places == -1).all()
    assert least(made) >= 0.765 - 1e-6
    above = given + np.array([(0, 0, 0.01)])
    off = tw.refine_points(square(), above, kind="poisson", rho=0.6)
    assert "from up to 0.01 off it" in off.notes[0]
    assert np.array_equal(off.positions[:, 2], np.zeros(300))


def test_a_thin_plate_is_told():
    vertices = np.array([(x, y, z) for z in (0, 0.002) for y in (0, 1) for x in (0, 1)], float)
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    made = tw.surface_points((vertices, faces), 300)
    assert "could not be moved as far apart as asked" in made.notes[-1]
    assert made.figures["pairs_left"] > 0
    assert least(made) >= made.figures["rho"] - 1e-6


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        ({}, "count, or radius"),
        ({"count": 5, "radius": 1}, "count, or radius"),
        ({"count": 0}, "count is 0"),
        ({"count": 10**9}, "count is"),
        ({"radius": 0}, "radius is 0"),
        ({"radius": 1e-9}, "radius is 1e-09"),
        ({"radius": np.nan}, "radius is nan"),
        ({"count": 5, "kind": "dart"}, "kind"),
        ({"count": 5, "rho": 0.99}, "rho is 0.99"),
        ({"count": 5, "density": np.zeros(8)}, "0 everywhere"),
        ({"count": 5, "density": -np.ones(8)}, "density holds -1"),
        ({"count": 5, "density": np.ones(7)}, r"\(8,\) for vertices"),
        ({"count": 5, "density": np.ones((2, 2))}, "no texture coordinates"),
        ({"count": 5, "density": lambda p: p}, "one number for every place"),
        ({"count": 5, "density": []}, "density"),
    ],
)
def test_what_cannot_be_done_is_refused(arguments, words):
    with pytest.raises(TilewrightValueError, match=words):
        tw.surface_points(cube(), **arguments)


def test_what_is_no_mesh_and_no_points_is_refused():
    for mesh in (7, (1, 2, 3), None):
        with pytest.raises(TilewrightTypeError):
            tw.surface_points(mesh, 5)
    with pytest.raises(TilewrightTypeError, match="density"):
        tw.surface_points(cube(), 5, density="dense")
    for points in (np.zeros((0, 3)), [(0, 0)], [(0, 0, np.nan)]):
        with pytest.raises(TilewrightValueError, match="points"):
            tw.refine_points(cube(), points)
    with pytest.raises(TilewrightTypeError, match="points"):
        tw.refine_points(cube(), [("a", "b", "c")])


@pytest.mark.parametrize("count", [1, 2, 3, 7])
def test_a_few_points_are_no_exception(count):
    for kind in ("even", "poisson", "tiles"):
        assert len(tw.surface_points(cube(), count, kind=kind)) == count


def test_objects_of_other_libraries_are_meshes():
    class Other:
        vertices, faces = np.asarray(cube().vertices), np.asarray(cube().faces)

    assert tw.surface_points(Other(), 50).mesh == cube()


def test_progress_is_told_and_can_stop():
    def stop(done, total, what):
        raise tw.Cancelled

    with pytest.raises(tw.Cancelled):
        tw.surface_points(cube(), 50, progress=stop)


def test_mended_meshes_are_told(tmp_path):
    soup = np.concatenate([np.asarray(cube().vertices)[face] for face in cube().faces])
    made = tw.surface_points((soup, np.arange(24).reshape(6, 4)), 50)
    assert "welded" in made.notes[0]
    (tmp_path / "a.obj").write_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n")
    with pytest.warns(TilewrightWarning, match="1 line"):
        assert len(tw.surface_points(tmp_path / "a.obj", 20)) == 20


def test_a_density_may_be_steep_and_large_and_0_almost_everywhere():
    mesh = square(1)
    for density in (lambda p: np.full(len(p), 1e300), lambda p: (p[:, 0] > 0.97) * 1.0):
        made = tw.surface_points(mesh, 300, density=density, kind="tiles")
        assert density(made.positions).min() > 0
    with pytest.raises(TilewrightValueError, match="lies almost all in so small a part"):
        tw.surface_points(mesh, 9000, density=lambda p: np.exp(-1e6 * (p**2).sum(axis=1)))
    with pytest.raises(TilewrightValueError, match="is 0 everywhere"):
        tw.surface_points(mesh, 9, density=lambda p: 0 * p[:, 0])
