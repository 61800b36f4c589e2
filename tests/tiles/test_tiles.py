"""Tile sets: sizes from the papers (with the errata), codes, properties the sets are asked to have."""

import pickle
from collections import Counter

import numpy as np
import pytest
from hypothesis import given, strategies as st

import tilewright as tw
from tilewright.errors import TilewrightError
from tilewright.tiles import CORNER, CORNER_CUBE, DOMINO, WANG

ALL_COLORS = range(1, 17)


@pytest.mark.parametrize("c", ALL_COLORS)
def test_complete_sets_are_complete_and_in_index_order(c):
    for tiles in (tw.corner_tiles(c), tw.wang_tiles(c)):
        assert len(tiles) == c**4
        assert tiles.is_complete
        assert np.array_equal(tiles.codes, np.arange(c**4))
    assert len(tw.dominoes(c)) == c**2
    assert len(tw.wang_tiles(c, 17 - c)) == (c * (17 - c)) ** 2


@pytest.mark.parametrize("tiles", [tw.corner_tiles(2), tw.wang_tiles(2), tw.corner_coded_tiles()], ids=repr)
def test_a_set_from_another_process_has_the_shape_that_is_known_here(tiles):
    again = pickle.loads(pickle.dumps(tiles))
    assert again.shape is tiles.shape
    assert np.array_equal(again.slots, tiles.slots)


# Lagae 2007, 3.2.1 and 3.2.2, as corrected: compact Wang sets 2C^2, compact corner sets 2C^3.
@pytest.mark.parametrize(
    ("c", "wang", "corner"),
    [(2, 8, 16), (3, 18, 54), (4, 32, 128), (5, 50, 250), (6, 72, 432), (7, 98, 686), (8, 128, 1024)],
)
def test_compact_sets_have_the_sizes_of_the_thesis(c, wang, corner):
    assert len(tw.compact_wang_tiles(c)) == wang
    assert len(tw.corner_tiles(c, choices=2)) == corner
    assert len(tw.summed_wang_tiles(c)) == c**3
    assert len(tw.column_corner_tiles(c)) == 4 * c * c


@pytest.mark.parametrize("c", range(2, 17))
def test_compact_sets_always_leave_two_choices(c):
    _, _, s, w = range(4)
    tiles = tw.compact_wang_tiles(c).slots
    assert set(Counter(map(tuple, tiles[:, [0, w]])).values()) == {2}
    assert set(Counter(map(tuple, tiles[:, [1, s]])).values()) == {2}
    assert len(Counter(map(tuple, tiles[:, [0, w]]))) == c * c
    corners = tw.corner_tiles(c, choices=2).slots
    known = Counter(map(tuple, corners[:, [0, 2, 3]]))
    assert len(known) == c**3
    assert set(known.values()) == {2}


@pytest.mark.parametrize(("count", "c_h", "c_v"), [(8, 2, 2), (12, 2, 3), (18, 3, 3)])
def test_cohens_sets(count, c_h, c_v):
    tiles = tw.cohen_tiles(count)
    assert len(tiles) == count
    assert tiles.colors == (c_h, c_v, c_h, c_v)
    assert set(Counter(map(tuple, tiles.slots[:, [0, 3]])).values()) == {2}
    assert set(Counter(map(tuple, tiles.slots[:, [1, 2]])).values()) == {2}


def test_cohens_eight_tiles_are_the_summed_set_over_two_colors():
    assert np.array_equal(np.sort(tw.cohen_tiles(8).codes), np.sort(tw.summed_wang_tiles(2).codes))


def test_corner_coded_sets():
    whole, half = tw.corner_coded_tiles(), tw.corner_coded_tiles(scanline_only=True)
    assert (len(whole), len(half)) == (128, 64)
    # N, W and the corners NE, SW, NW are known in scanline order.
    known = Counter(map(tuple, half.slots[:, [0, 3, 4, 6, 7]]))
    assert len(known) == 32
    assert set(known.values()) == {2}


def test_cubes():
    assert [len(tw.corner_cubes(c)) for c in (1, 2, 3, 4, 16)] == [1, 256, 6561, 65536, 16**8]
    assert [len(tw.wang_cubes(c)) for c in (1, 2, 3, 4, 16)] == [1, 64, 729, 4096, 16**6]
    assert [len(tw.compact_wang_cubes(c)) for c in (1, 2, 3, 4, 16)] == [1, 16, 54, 128, 8192]
    assert [len(tw.compact_corner_cubes(c)) for c in (1, 2, 3, 16)] == [1, 256, 2 * 3**7, 2 * 16**7]
    # Sixteen Wang cubes suffice: two for each way N, W and U can be.
    known = Counter(map(tuple, tw.compact_wang_cubes(2).slots[:, [0, 3, 4]]))
    assert len(known) == 8
    assert set(known.values()) == {2}
    sed, others = 5, [0, 1, 2, 3, 4, 6, 7]
    known = Counter(map(tuple, tw.compact_corner_cubes(3).slots[:, others]))
    assert CORNER_CUBE.slots[sed] == "SED"
    assert len(known) == 3**7
    assert set(known.values()) == {2}


@pytest.mark.parametrize(
    "make", [tw.corner_cubes, tw.wang_cubes, tw.compact_corner_cubes, tw.compact_wang_cubes]
)
@pytest.mark.parametrize("c", ALL_COLORS)
def test_cube_sets_compute_their_tiles(make, c):
    tiles = make(c)
    index = np.unique(np.linspace(0, len(tiles) - 1, 500).astype(np.int64))
    slots = tiles.slots_of(index)
    assert slots.max(initial=0) < c
    assert np.array_equal(tiles.find(slots), index)
    if tiles.is_complete:
        assert np.array_equal(index, tw.encode(slots, (c,) * len(tiles.shape.slots)))
    if len(tiles) < 10_000:
        assert len(np.unique(tiles.slots, axis=0)) == len(tiles)
        assert np.array_equal(tiles.slots[index], slots)


def test_colors_that_no_tile_has_are_not_found():
    assert list(tw.cohen_tiles(8).find([[0, 0, 0, 0], [0, 1, 0, 0], [9, 0, 0, 0], [-1, 0, 0, 0]])) == [
        0,
        -1,
        -1,
        -1,
    ]
    assert tw.compact_corner_cubes(3).find(np.full(8, 2)) >= 0
    assert tw.compact_corner_cubes(3).find([0, 0, 0, 0, 0, 2, 0, 0]) == -1
    assert tw.compact_wang_cubes(2).find([0, 1, 0, 0, 0, 0]) == -1


@given(st.integers(1, 16), st.data())
def test_codes_and_slots_are_inverse(c, data):
    code = data.draw(st.integers(0, c**4 - 1))
    slots = tw.decode(code, (c,) * 4)
    a, b, d, e = (int(v) for v in slots)
    assert ((a * c + b) * c + d) * c + e == code  # eq. 2.2 and 2.5
    assert tw.encode(slots, (c,) * 4) == code


def test_an_asymmetric_tile_has_its_slots_in_the_papers_order():
    corner = tw.corner_tiles(4)
    assert corner.shape.slots == ("NE", "SE", "SW", "NW")
    assert list(corner.fitting(NE=0, SE=1, SW=2, NW=3)) == [0 * 64 + 1 * 16 + 2 * 4 + 3]
    wang = tw.wang_tiles(4)
    assert wang.shape.slots == ("N", "E", "S", "W")
    assert list(wang.fitting(N=3, E=2, S=1, W=0)) == [3 * 64 + 2 * 16 + 1 * 4]
    assert DOMINO.slots == ("E", "W")


def test_queries():
    tiles = tw.cohen_tiles(8)
    assert len(tiles.fitting(N=0)) == 4
    assert len(tiles.fitting(N=0, W=1)) == 2
    with pytest.raises(TilewrightError, match="have no slot 'NE'"):
        tiles.fitting(NE=0)


def test_a_corner_set_as_wang_tiles():
    corners = tw.corner_tiles(2)
    wang = tw.as_wang_tiles(corners)
    assert wang.shape is WANG
    assert len(wang) == 16
    assert wang.colors == (4,) * 4
    # Neighbors match as corner tiles exactly where they match as Wang tiles.
    for joint_c, joint_w in zip(corners.shape.joints, wang.shape.joints, strict=True):
        for a in range(16):
            for b in range(16):
                as_corners = all(corners.slots[a, f] == corners.slots[b, n] for f, n in joint_c)
                as_wang = all(wang.slots[a, f] == wang.slots[b, n] for f, n in joint_w)
                assert as_corners == as_wang


BAD = {
    "no colors": (lambda: tw.corner_tiles(0), "colors is 0; allowed are 1 to 16"),
    "many colors": (lambda: tw.wang_tiles(17), "colors is 17; allowed are 1 to 16"),
    "colors as text": (lambda: tw.wang_tiles("2"), "colors must be an integer, not '2'"),
    "a float": (lambda: tw.wang_tiles(2.0), "must be an integer"),
    "one choice": (lambda: tw.corner_tiles(4, choices=1), "choices is 1; allowed are 2 to 4"),
    "big cubes": (lambda: tw.corner_cubes(16).slots, "too large to list; slots_of() and find() work"),
    "not a power of two": (lambda: tw.shifted_wang_tiles(6), "needs a power of two"),
    "another count": (lambda: tw.cohen_tiles(9), "8, 12 or 18"),
    "ragged": (lambda: tw.tile_set([[0, 1], [0]]), "slots is not a table of equally long rows"),
    "index": (lambda: tw.corner_tiles(2).slots_of([3, 16]), "index holds 3 to 16; the set has tiles 0 to 15"),
    "code": (lambda: tw.decode(81, (3,) * 4), "allowed are 0 to 80"),
    "color to encode": (lambda: tw.encode([0, 3, 0, 0], (3,) * 4), "colors outside 0 up to"),
    "short row": (lambda: tw.encode([0, 1], (3,) * 4), "its last axis must be 4 long"),
    "empty": (lambda: tw.tile_set([]), "at least one tile"),
    "beyond 64 bits": (lambda: tw.tile_set([[0, 0, 0, 2**70]]), "beyond 64 bits"),
    "no set": (lambda: tw.corner_coded_tiles(3), "base must be a TileSet"),
    "find three": (lambda: tw.corner_tiles(2).find([0, 0, 0]), "last axis must be 4 long"),
    "decode none": (lambda: tw.decode(0, (0, 2)), "colors is 0; allowed are 1 to 32768"),
    "decode nothing": (lambda: tw.decode(0, None), "colors must be a tuple"),
    "decode huge": (lambda: tw.decode(0, (256,) * 8), "up to 2^62"),
    "three slots": (lambda: tw.tile_set([[0, 1, 2]]), r"need (tiles, 4)"),
    "twice": (lambda: tw.tile_set([[0, 1, 0, 1]] * 2), "a tile twice"),
    "negative": (lambda: tw.tile_set([[0, -1, 0, 0]]), "colors -1 to 0"),
    "floats": (lambda: tw.tile_set([[0.5, 0, 0, 0]]), "must hold integers"),
    "shape": (lambda: tw.tile_set([[0] * 4], "hexagon"), "shape is 'hexagon'"),
    "wang to wang": (lambda: tw.as_wang_tiles(tw.wang_tiles(2)), "only corner sets"),
    "coded corners": (lambda: tw.corner_coded_tiles(tw.corner_tiles(2)), "must be a set of Wang tiles"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_sets_get_one_clear_line(case):
    make, message = BAD[case]
    with pytest.raises(TilewrightError) as error:
        make()
    assert message in str(error.value)
    assert "\n" not in str(error.value)


def test_user_sets_share_a_palette_where_slots_can_meet():
    tiles = tw.tile_set([[0, 3, 1, 0], [1, 0, 0, 3]], "wang")
    assert tiles.colors == (2, 4, 2, 4)
    assert not tiles.is_complete
    assert CORNER.dimension == 2


def test_crossed_wang_tiles_name_the_edges_at_their_corners():
    tiles = tw.crossed_wang_tiles(2)
    assert len(tiles) == 2**12
    n, e, s, w, ne, se, sw, nw = tiles.slots.astype(int).T

    def edges(code):
        return code // 8, code // 4 % 2, code // 2 % 2, code % 2  # north, east, south, west

    assert (edges(ne)[3] == n).all()
    assert (edges(ne)[2] == e).all()
    assert (edges(se)[0] == e).all()
    assert (edges(se)[3] == s).all()
    assert (edges(sw)[1] == s).all()
    assert (edges(sw)[0] == w).all()
    assert (edges(nw)[1] == n).all()
    assert (edges(nw)[2] == w).all()
    with pytest.raises(ValueError, match="531,441"):
        tw.crossed_wang_tiles(3)


def test_crossed_tiles_lie_as_the_wang_tiles_they_come_from():
    crossed = tw.crossed_wang_tiles(2)
    plain = tw.wang_tiles(2)
    cells = (-9, 4, 12, 7)
    with_corners = crossed.slots_of(tw.direct(crossed, 5).indices(*cells))
    np.testing.assert_array_equal(with_corners[..., :4], plain.slots_of(tw.direct(plain, 5).indices(*cells)))
