"""Aperiodic sets, how corner sets are made from them, and the machine checks of what is claimed."""

import warnings
from fractions import Fraction as F
from itertools import permutations, product

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightError, TilewrightWarning
from tilewright.tiles import CORNER, WANG, ListedTileSet, as_wang_tiles
from tilewright.tiles.aperiodic import (
    APERIODIC_SETS,
    MERGE_TO_24,
    MERGE_TO_26,
    MERGE_TO_31,
    PUBLISHED_ONLY,
    aperiodic_tiles,
)
from tilewright.tiles.blocks import drop_idle, possible_blocks
from tilewright.tiles.lifting import check_lifting
from tilewright.tiles.merging import grouped_subdivision, merge_colors
from tilewright.tiles.transducers import find_period, strip
from tilewright.tiles.translations import CONSTRUCTIONS, as_corner_tiles, translation_is_sound

WANG_SETS = ("culik-13", "kari-14", "ammann-16", "jeandel-rao-11-4", "jeandel-rao-11-5")

# Corner tiles as they were found by a second program: colors NW, NE, SE, SW.
LISTED = {
    "jeandel-rao-36": """5051 8151 8161 5182 8183 6252 8262 6264 7270 6382 7471 1515 2515 1518 1526 2526 2527
        1528 1626 2626 2627 4627 1628 2647 4647 0705 1705 0715 1715 1718 2815 3818 2826 2827 3828 2836""",
    "jeandel-rao-34": """5051 5182 6252 6264 6382 7270 7471 8151 8161 8183 8262 0705 0715 1515 1518 1526 1528
        1628 1705 1715 1718 2526 2527 2626 2627 2647 2815 2826 2827 2836 3818 3828 4627 4647""",
    "jeandel-rao-37": """0427 0517 0705 0724 1407 1427 1705 1715 1734 2417 2507 2704 2714 2716 2725 3437 3517
        3627 3734 4072 4170 4271 4372 4373 5071 5171 5270 6172 7042 7050 7140 7143 7153 7241 7252 7263
        7341""",
    "jeandel-rao-31": """0003 0012 0023 0111 0121 0200 0232 0303 0313 1021 1101 1110 1131 1202 1303 1311 1313
        1320 1321 2003 2020 2023 2100 2113 2120 2123 2320 2323 3031 3112 3230""",
    "jeandel-rao-26": """0001 0003 0013 0030 0100 0321 0323 0330 1003 1013 1030 1100 1223 2200 2201 2310 2311
        2322 2332 3033 3132 3211 3222 3311 3322 3332""",
    "jeandel-rao-24": """0033 0123 0301 0311 1011 1032 1100 1101 1110 1122 1301 1311 2013 2223 2232 2233 2302
        2313 3111 3113 3223 3230 3233 3331""",
}


def rows(tiles):
    return set(map(tuple, tiles.slots.tolist()))


@pytest.mark.parametrize("name", LISTED)
def test_derived_sets_are_the_listed_ones(name):
    listed = {tuple(int(row[k]) for k in (1, 2, 3, 0)) for row in LISTED[name].split()}
    assert rows(aperiodic_tiles(name)) == listed


def test_an_asymmetric_tile_of_each_table_has_its_slots_in_order():
    assert list(aperiodic_tiles("kari-14").fitting(N=2, E=5, S=1, W=4)) == [6]
    assert list(aperiodic_tiles("culik-13").fitting(N=3, E=1, S=3, W=2)) == [6]
    assert list(aperiodic_tiles("ammann-16").fitting(N=3, E=4, S=1, W=5)) == [0]
    assert list(aperiodic_tiles("lagae-44").fitting(NW=0, NE=4, SE=2, SW=1)) == [0]


def test_culik_and_kari_tiles_multiply():
    halves = np.array([F(0), F(0), F(1, 2), F(1), F(2)])  # two of Culik's colors stand for 0
    n, e, s, w = halves[aperiodic_tiles("culik-13").slots].T
    assert [n[t] + e[t] - w[t] in (s[t] / 2, s[t] * 3) for t in range(13)] == [True] * 13
    thirds = np.array([F(-1), F(0), F(0), F(-1, 3), F(1, 3), F(2, 3)])
    n, e, s, w = aperiodic_tiles("kari-14").slots.T.astype(object)
    e, w = thirds[e.astype(int)], thirds[w.astype(int)]
    assert [s[t] + e[t] - w[t] in (F(2) * n[t], F(2, 3) * n[t]) for t in range(14)] == [True] * 14


def test_lagaes_transcription_is_the_translation_of_ammanns_set_seen_in_a_mirror():
    with pytest.warns(TilewrightWarning, match="no Wang tiling gives"):
        made = as_corner_tiles(aperiodic_tiles("ammann-16"), "horizontal")
    mirrored = made.slots[:, [3, 2, 1, 0]]  # NE <-> NW, SE <-> SW
    lagae = rows(aperiodic_tiles("lagae-44"))
    assert any({tuple(p[c] for c in t) for t in mirrored.tolist()} == lagae for p in permutations(range(6)))


def test_lagaes_set_has_a_period_of_2_by_3():
    tiles = aperiodic_tiles("lagae-44")
    corners = np.array([[4, 0], [2, 1], [3, 0]])
    east = np.roll(corners, -1, 1)
    cells = tiles.find(np.stack([east, np.roll(east, -1, 0), np.roll(corners, -1, 0), corners], axis=-1))
    assert tw.array_tiling(tiles, cells, torus=True).indices(-4, -6, 8, 12).shape == (12, 8)
    assert find_period(tiles, 3).shape == (3, 2)
    # Nor does it help to leave out the tiles that occur in no tiling.
    fewer = drop_idle(tiles, margin=0)
    assert len(fewer) == 30
    tw.array_tiling(fewer, find_period(fewer, 3), torus=True)


@pytest.mark.parametrize("construction", ["horizontal", "vertical"])
def test_ammanns_translations_have_periods_too(construction):
    with pytest.warns(TilewrightWarning):
        tiles = as_corner_tiles(aperiodic_tiles("ammann-16"), construction)
    rows = {"horizontal": 3, "vertical": 2}[construction]
    found = find_period(tiles, rows)
    assert found.shape == (rows, 5 - rows)
    tw.array_tiling(tiles, found, torus=True)
    assert all(find_period(tiles, n) is None for n in range(1, rows))


def test_no_other_set_has_a_short_period():
    for name in APERIODIC_SETS:
        if name != "lagae-44":
            most = 4 if name in ("culik-13", "kari-14") else 9
            assert not any(find_period(aperiodic_tiles(name), n) is not None for n in range(1, most))


def test_which_translations_are_sound():
    every = product(WANG_SETS, ("horizontal", "vertical"))
    sound = {(n, c) for n, c in every if translation_is_sound(aperiodic_tiles(n), c)}
    assert sound == {("kari-14", "vertical")}
    for construction in ("diagonal", "rotation", "subdivision"):
        wang = as_wang_tiles(as_corner_tiles(aperiodic_tiles("jeandel-rao-11-4"), construction))
        assert translation_is_sound(wang, "horizontal")
        assert translation_is_sound(wang, "vertical")


def corner_tiles_by_hand(wang, construction):
    """The corner tiles of a construction, from all choices of tiles, written down slot by slot."""
    t = [tuple(map(int, row)) for row in wang.slots]  # N, E, S, W
    if construction == "diagonal":
        beside = {(a, b) for a, b in product(range(len(t)), repeat=2) if t[a][1] == t[b][3]}
        return {
            (b, d, c, a)
            for (a, b), (c, d) in product(beside, repeat=2)
            if t[a][2] == t[c][0] and t[b][2] == t[d][0]
        }
    pairs = list(product(t, repeat=2))
    if construction == "horizontal":
        return {(b[0], b[2], a[2], a[0]) for a, b in pairs if a[1] == b[3]}
    if construction == "vertical":
        return {(a[1], b[1], b[3], a[3]) for a, b in pairs if a[2] == b[0]}
    if construction == "subdivision":
        star, made = max(wang.colors) + len(t), set()
        for center, (n, e, s, w) in enumerate(t, max(wang.colors)):
            made |= {(n, center, w, star), (star, e, center, n), (e, star, s, center), (center, s, star, w)}
        return made
    level = sorted({c for row in t for c in row[0::2]})
    upright = sorted({c for row in t for c in row[1::2]})
    h, v = {c: i for i, c in enumerate(level)}, {c: i + len(level) for i, c in enumerate(upright)}
    made = {(h[n], v[e], h[s], v[w]) for n, e, s, w in t}
    for b, _, c, a in corner_tiles_by_hand(wang, "diagonal"):
        made.add((v[t[a][1]], h[t[b][2]], v[t[c][1]], h[t[a][2]]))
    return made


@pytest.mark.parametrize("construction", CONSTRUCTIONS)
def test_constructions_against_all_choices(construction):
    rng = np.random.default_rng(5)
    for size in (2, 4, 8):
        whole = tw.wang_tiles(2, 3)
        wang = ListedTileSet(WANG, whole.slots[rng.choice(36, size, replace=False)], (2, 3, 2, 3))
        by_hand = corner_tiles_by_hand(wang, construction)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", TilewrightWarning)
            if construction in ("horizontal", "vertical") and translation_fails(wang, construction):
                with pytest.raises(TilewrightError, match="translation fails"):
                    as_corner_tiles(wang, construction)
            else:
                assert rows(as_corner_tiles(wang, construction)) == by_hand


def translation_fails(wang, construction):
    far, near = (1, 3) if construction == "horizontal" else (2, 0)
    pairs = sum(a[far] == b[near] for a, b in product(wang.slots.tolist(), repeat=2))
    return len(corner_tiles_by_hand(wang, construction)) < pairs


def test_the_way_back_numbers_only_the_pairs_that_occur():
    corners = aperiodic_tiles("jeandel-rao-31")
    wang = as_wang_tiles(corners)
    ne, se, sw, nw = corners.slots.astype(int).T
    level, upright = {*(4 * nw + ne), *(4 * sw + se)}, {*(4 * ne + se), *(4 * nw + sw)}
    assert wang.colors == (len(level), len(upright)) * 2
    assert [len(np.unique(wang.slots[:, [k, k + 2]])) for k in (0, 1)] == [len(level), len(upright)]
    for joint_c, joint_w in zip(corners.shape.joints, wang.shape.joints, strict=True):
        for a, b in product(range(31), repeat=2):
            as_corners = all(corners.slots[a, f] == corners.slots[b, n] for f, n in joint_c)
            assert as_corners == all(wang.slots[a, f] == wang.slots[b, n] for f, n in joint_w)
    full = tw.corner_tiles(3)
    ne, se, sw, nw = full.slots.astype(int).T
    assert np.array_equal(as_wang_tiles(full).slots.T, [nw * 3 + ne, ne * 3 + se, sw * 3 + se, nw * 3 + sw])


def partitions(items):
    if not items:
        yield []
        return
    for rest in partitions(items[1:]):
        yield [[items[0]], *rest]
        for k in range(len(rest)):
            yield [*rest[:k], [items[0], *rest[k]], *rest[k + 1 :]]


def quarters(tiles):
    return [{(t[a], t[b]) for t in tiles} for a, b in ((0, 3), (0, 1), (2, 1), (2, 3))]


def admissible(tiles, known):
    n_w, n_e, s_e, s_w = quarters(tiles)
    colors = range(2)
    return all(
        t in known
        for t in product(colors, repeat=4)
        if (t[0], t[3]) in n_w and (t[0], t[1]) in n_e and (t[2], t[1]) in s_e and (t[2], t[3]) in s_w
    )


def test_groupings_are_the_best_of_all_partitions():
    rng = np.random.default_rng(3)
    for _ in range(12):
        wang = ListedTileSet(WANG, tw.wang_tiles(2).slots[rng.choice(16, 6, replace=False)], (2,) * 4)
        t = [tuple(map(int, row)) for row in wang.slots]
        good = [p for p in partitions(t) if all(admissible(part, set(t)) for part in p)]
        best = min((sum(len(q) for part in p for q in quarters(part)), len(p)) for p in good)
        found = grouped_subdivision(wang)
        assert (len(found.tiles), len(found.classes)) == best
        assert found.plain == 24


def test_groupings_of_the_named_sets():
    sizes = {n: len(grouped_subdivision(aperiodic_tiles(n)).tiles) for n in WANG_SETS if n != "ammann-16"}
    assert sizes == {"culik-13": 46, "kari-14": 49, "jeandel-rao-11-4": 37, "jeandel-rao-11-5": 37}


def test_31_26_and_24_tiles_lift():
    diagonal = drop_idle(as_corner_tiles(aperiodic_tiles("jeandel-rao-11-5"), "diagonal"))
    twice = drop_idle(as_corner_tiles(as_wang_tiles(diagonal), "diagonal"))
    assert (len(diagonal), len(twice)) == (55, 129)
    for merged, original, mapping, size, counts in (
        ("jeandel-rao-31", aperiodic_tiles("jeandel-rao-34"), MERGE_TO_31, 3, (196, 196, 376, 376)),
        ("jeandel-rao-26", diagonal, MERGE_TO_26, 3, (219, 219, 525, 525)),
        ("jeandel-rao-24", twice, MERGE_TO_24, 3, (237, 215, 526, 526)),
        ("jeandel-rao-24", twice, MERGE_TO_24, 5, (1025, 1025, 1746, 1746)),
    ):
        found = check_lifting(aperiodic_tiles(merged), original, mapping, size)
        assert (found.blocks, found.unique, found.larger, found.lifted) == counts
        assert found.holds == (found.unique == found.blocks)


@pytest.mark.parametrize("mapping", [(0,) * 9, (0, 1, 2, 3, 4, 0, 1, 2, 3)])
def test_other_merges_do_not_lift(mapping):
    original = aperiodic_tiles("jeandel-rao-34")
    merged = merge_colors(original, mapping)
    assert not check_lifting(merged, original, mapping).holds
    assert any(find_period(merged, n) is not None for n in range(1, 9))


def test_merging_nothing_lifts_as_it_is():
    tiles = aperiodic_tiles("jeandel-rao-36")
    found = check_lifting(tiles, tiles, range(9), size=1, margin=1)
    assert found.holds
    assert found.blocks == 34  # the tiles of jeandel-rao-34


def test_possible_blocks():
    assert len(possible_blocks(tw.corner_tiles(2), 2)) == 2**9
    assert len(possible_blocks(tw.wang_tiles(2, 1), 2)) == 2**6
    dead = tw.tile_set([[0, 0, 1, 0]])  # nothing fits below it
    assert possible_blocks(dead, 3).shape == (0, 3, 3)
    with pytest.raises(TilewrightError, match="does not tile the plane"):
        drop_idle(dead)
    # A tiling's blocks are among them, and each matches.
    lagae = aperiodic_tiles("lagae-44")
    cells = np.tile(find_period(lagae, 3), (2, 2))
    found = {block.tobytes() for block in possible_blocks(lagae, 2)}
    for y, x in product(range(3), range(2)):
        assert np.ascontiguousarray(cells[y : y + 2, x : x + 2]).tobytes() in found
    for block in possible_blocks(aperiodic_tiles("jeandel-rao-31"), 3):
        tw.array_tiling(aperiodic_tiles("jeandel-rao-31"), block)


def test_strips_hold_every_column_of_an_endless_strip():
    tiles = aperiodic_tiles("kari-14")
    two = strip(tiles, 2)
    s = tiles.slots
    columns = {(a, b) for a, b in product(range(14), repeat=2) if s[a, 2] == s[b, 0]}
    while True:  # take out what nothing follows or precedes
        west = {(s[a, 3], s[b, 3]) for a, b in columns}
        east = {(s[a, 1], s[b, 1]) for a, b in columns}
        kept = {(a, b) for a, b in columns if (s[a, 3], s[b, 3]) in east and (s[a, 1], s[b, 1]) in west}
        if kept == columns:
            break
        columns = kept
    assert set(map(tuple, two.columns.tolist())) == columns
    assert np.array_equal(two.read, s[two.columns[:, 0], 0])
    assert np.array_equal(two.write, s[two.columns[:, 1], 2])
    first, second = np.nonzero(two.target[:, None] == two.source[None])
    assert (s[two.columns[first], 1] == s[two.columns[second], 3]).all()
    assert 0 < len(two.strong()) < len(two)


def test_cycles_come_back():
    for tiles in (tw.wang_tiles(2, 3), tw.corner_tiles(2), tw.tile_set([[0, 1, 1, 0], [1, 0, 0, 1]])):
        for height in (2, 4):
            tw.array_tiling(tiles, find_period(tiles, height), torus=True)
    odd = tw.tile_set([[0, 1, 1, 0], [1, 2, 0, 1], [0, 0, 1, 2]])
    assert find_period(odd, 1) is None
    assert find_period(tw.tile_set([[0, 1, 0, 2]]), 3) is None  # no strip at all


def test_sets_of_many_colors():
    tiles = tw.tile_set([[0, 300, 40_000 - 8_000, 32_767], [32_767, 1, 0, 2]])
    assert tiles.slots.dtype == np.uint16
    assert list(tiles.find([[32_767, 1, 0, 2], [32_767, 1, 0, 3]])) == [1, -1]
    assert tiles.colors == (32_768,) * 4
    code = tw.encode([300, 2, 7, 299], (301,) * 4)
    assert tw.decode(code, (301,) * 4).tolist() == [300, 2, 7, 299]
    assert tw.decode(0, (256,) * 4).dtype == np.uint8


JR = aperiodic_tiles("jeandel-rao-11-5")
JR36 = aperiodic_tiles("jeandel-rao-36")
BAD = {
    "unknown": (lambda: aperiodic_tiles("culik"), "name is 'culik'; allowed are culik-13, kari-14"),
    "a list": (lambda: aperiodic_tiles(["culik-13"]), "allowed are culik-13"),
    "24/24": (lambda: aperiodic_tiles("ammann-24"), "nobody's transcription of its tiles was found"),
    "32/16": (lambda: aperiodic_tiles(PUBLISHED_ONLY[1]), "name is 'penrose-32'; of this set only its size"),
    "corners translated": (lambda: as_corner_tiles(JR36, "rotation"), "wang must be a set of Wang tiles"),
    "no set": (lambda: as_corner_tiles([[0] * 4], "rotation"), "wang must be a TileSet"),
    "construction": (lambda: as_corner_tiles(JR, "shear"), "construction is 'shear'; allowed are diagonal"),
    "soundness": (lambda: translation_is_sound(JR, "rotation"), "allowed are horizontal, vertical"),
    "nothing fits": (
        lambda: as_corner_tiles(tw.tile_set([[0, 0, 1, 1]]), "diagonal"),
        "no tiles of the custom",
    ),
    "merged Wang": (lambda: merge_colors(JR, [0] * 5), "must be a set of corner tiles"),
    "short mapping": (lambda: merge_colors(JR36, [0] * 8), "mapping has shape (8,); the set has 9 colors"),
    "negative mapping": (lambda: merge_colors(JR36, [-1] * 9), "mapping holds -1 to -1; allowed are 0 to"),
    "float mapping": (lambda: merge_colors(JR36, [np.nan] * 9), "mapping must hold integers"),
    "many to group": (
        lambda: grouped_subdivision(tw.wang_tiles(3)),
        "has 81 tiles; groupings are searched of up",
    ),
    "even size": (lambda: check_lifting(JR36, JR36, range(9), size=4), "size is 4; it must be odd"),
    "lifting of Wang": (lambda: check_lifting(JR, JR36, range(9)), "merged must be a set of corner tiles"),
    "many blocks": (
        lambda: possible_blocks(tw.wang_tiles(2), 2),
        "blocks that may occur, more than 2000000",
    ),
    "cubes": (lambda: possible_blocks(tw.wang_cubes(2), 3), "tiles must be square tiles"),
    "size zero": (lambda: possible_blocks(JR, 0), "size is 0; allowed are 1 to 32"),
    "rows": (lambda: strip(JR, 0), "rows is 0; allowed are 1 to 64"),
    "too many columns": (lambda: strip(tw.wang_tiles(12), 2), "columns are that many rows high; allowed are"),
    "dominoes": (lambda: find_period(tw.dominoes(2), 2), "wang must be a set of Wang tiles"),
    "32769 colors": (lambda: tw.tile_set([[0, 0, 0, 2**15]]), "allowed are 0 to 32767"),
    "palette": (lambda: tw.encode([0], (2**15 + 1,)), "colors is 32769; allowed are 1 to 32768"),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_input_gets_one_clear_line(case):
    call, message = BAD[case]
    with pytest.raises(TilewrightError) as error:
        call()
    assert message in str(error.value)
    assert "\n" not in str(error.value)


def test_every_set_says_what_is_known_of_it():
    for name, listed in APERIODIC_SETS.items():
        assert aperiodic_tiles(name).shape is (WANG if name in WANG_SETS else CORNER)
        assert listed.source
        assert ("NOT aperiodic" in listed.status) == (name == "lagae-44")
