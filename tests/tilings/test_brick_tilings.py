"""Brick Wang tiles, walls of given classes, and endless walls."""

import hashlib
from itertools import product

import numpy as np
import pytest

from mixer import mixer
from tilewright.errors import TilewrightError
from tilewright.tiles import corner_tiles, wang_tiles
from tilewright.tiles.bricks import brick_tiles, check_bricks, number_bricks
from tilewright.tilings import first_mismatch
from tilewright.tilings.bricks import brick_tiling, endless_brick_tiling
from walls import brick_classes

FAR = 2**61
WALLS = [(2, (2, 2)), (2, (3, 3)), (2, (3, 8)), (3, (2, 2)), (4, (3, 3)), (5, (5, 2)), (16, (8, 8))]


def digest(cells):
    return hashlib.sha256(np.ascontiguousarray(cells, "<i4").tobytes()).hexdigest()[:16]


def longest_run(cells):
    """The longest run of True along the rows."""
    edges = np.diff(np.pad(cells, ((0, 0), (1, 1))).astype(int), axis=1)
    return (np.nonzero(edges < 0)[1] - np.nonzero(edges > 0)[1]).max(initial=0)


@pytest.mark.parametrize("n", range(2, 17))
def test_the_set_holds_every_tile_traversed_once(n):
    tiles = brick_tiles(n)
    every = np.indices((n,) * 4).reshape(4, -1).T
    once = (every[:, 0] == every[:, 2]) ^ (every[:, 1] == every[:, 3])
    assert np.array_equal(tiles.slots, every[once])
    assert len(tiles) == 2 * n**2 * (n - 1)
    assert np.array_equal(number_bricks(n, *tiles.slots.T), np.arange(len(tiles)))
    assert check_bricks("tiles", tiles) is tiles


def test_classes_tell_how_a_tile_is_traversed():
    tiles = brick_tiles(3)
    along, down = tiles.find([[0, 2, 1, 2], [1, 0, 1, 2]])  # E = W = 2; N = S = 1
    assert brick_classes(tiles)[[along, down]].tolist() == [0, 1]
    assert brick_classes(tiles).sum() == len(tiles) // 2


@pytest.mark.parametrize("tiles", [wang_tiles(3), corner_tiles(2), "bricks"])
def test_other_sets_are_no_brick_tiles(tiles):
    with pytest.raises(
        TilewrightError, match=r"walls (is the complete set .* take brick_tiles|must be a TileSet)"
    ):
        check_bricks("walls", tiles)


@pytest.mark.parametrize("n", [2, 3, 16])
@pytest.mark.parametrize("shape", [(1, 1), (1, 9), (8, 1), (40, 50)])
def test_walls_have_the_classes_asked_for(n, shape):
    classes = np.random.default_rng(1).integers(0, 2, shape)
    tiling = brick_tiling(classes, n, seed=5)  # checks that tiles match
    assert np.array_equal(brick_classes(tiling.tiles)[tiling.cells], classes)
    assert np.array_equal(tiling.cells, brick_tiling(classes.astype(bool), n, seed=5).cells)
    if shape == (40, 50):
        assert (tiling.cells != brick_tiling(classes, n, seed=6).cells).mean() > 0.3
        part = brick_tiling(classes[:30, :20], n, seed=5)
        assert np.array_equal(part.cells, tiling.cells[:30, :20])


def test_edges_of_walls_are_random():
    classes = np.random.default_rng(1).integers(0, 2, (300, 300))
    slots = brick_tiles(5).slots[brick_tiling(classes, 5).cells]
    for slot, changes in ((3, classes == 1), (0, classes == 0)):
        pairs = np.bincount((slots[..., slot] * 5 + slots[..., (slot + 2) % 4])[changes], minlength=25)
        pairs = pairs.reshape(5, 5)[~np.eye(5, dtype=bool)]
        assert abs(pairs / pairs.mean() - 1).max() < 0.1


def closes(changes, n):
    """Whether some colors around a ring change just there; by trying all."""
    size = len(changes)
    return any(
        all((c[i] != c[(i + 1) % size]) == changes[i] for i in range(size))
        for c in product(range(n), repeat=size)
    )


@pytest.mark.parametrize("n", [2, 3, 4])
def test_walls_close_around_a_torus_wherever_they_can(n):
    rings = {bits: closes(bits, n) for size in (3, 4) for bits in product((False, True), repeat=size)}
    possible, refused = 0, 0
    for code in np.random.default_rng(n).permutation(4096):
        classes = (code >> np.arange(12) & 1).reshape(3, 4) == 1
        lines = [tuple(row.tolist()) for row in classes] + [tuple((~line).tolist()) for line in classes.T]
        if all(rings[line] for line in lines):
            tiling = brick_tiling(classes, n, seed=possible, torus=True)
            assert np.array_equal(brick_classes(tiling.tiles)[tiling.cells], classes)
            possible += 1
        elif refused < 20:
            with pytest.raises(TilewrightError, match=r"(row|column) \d of classes has"):
                brick_tiling(classes, n, torus=True)
            refused += 1
        if possible == 30:
            break
    assert possible > 10


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"classes": []}, "classes has shape"),
        ({"classes": [0, 1]}, r"classes has shape \(2,\)"),
        ({"classes": [[0, 2]]}, "classes holds 0 to 2; allowed are 0 for H tiles and 1 for V tiles"),
        ({"classes": [[0.0, 1.0]]}, "classes must hold integers"),
        ({"positions": 1}, "positions is 1; allowed are 2 to 16"),
        ({"positions": 2.5}, "positions must be an integer"),
        ({"seed": 2**64}, "seed is"),
        ({"classes": [[0, 0], [0, 1]], "torus": True}, "row 1 of classes has one V tile"),
        ({"classes": [[0, 1, 1, 1]] * 2, "positions": 2, "torus": True}, "row 0 .* 3 V tiles; .* even"),
        ({"classes": [[1, 1], [1, 1], [0, 0]], "torus": True}, "column 0 of classes has one H tile"),
    ],
)
def test_bad_walls_are_told_in_one_line(change, message):
    with pytest.raises(TilewrightError, match=message) as caught:
        brick_tiling(**{"classes": [[0, 1], [1, 0]]} | change)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(("n", "longest"), WALLS)
def test_endless_walls_are_valid_and_have_short_lines(n, longest):
    wall = endless_brick_tiling(n, seed=3, longest=longest)
    cells = wall.indices(-700, -300, 1100, 600)
    assert first_mismatch(wall.tiles, cells, torus=False) is None
    classes = brick_classes(wall.tiles)[cells]
    assert (longest_run(classes == 0), longest_run(classes.T == 1)) == wall.longest == longest
    share = classes.mean()
    assert abs(share - 0.5) < 0.01 if longest[0] == longest[1] else (share > 0.5) == (longest[1] > longest[0])
    counts = [np.bincount(wall.tiles.slots[cells, slot].ravel(), minlength=n) for slot in (0, 3)]
    assert abs(counts / np.mean(counts) - 1).max() < 0.05


@pytest.mark.parametrize(("n", "longest"), WALLS)
@pytest.mark.parametrize(
    "corner", [(-300, -200), (2**32 - 300, -(2**32) - 100), (FAR - 420, -FAR), (-FAR, 5)]
)
def test_every_window_of_an_endless_wall_shows_the_same(n, longest, corner):
    wall = endless_brick_tiling(n, seed=2**64 - 1, longest=longest)
    x, y = corner
    cells = wall.indices(x, y, 420, 310)
    assert first_mismatch(wall.tiles, cells, torus=False) is None
    for dx, dy, w, h in (
        (0, 0, 1, 1),
        (299, 100, 3, 2),
        (419, 0, 1, 310),
        (37, 309, 383, 1),
        (100, 99, 257, 31),
    ):
        assert np.array_equal(wall.indices(x + dx, y + dy, w, h), cells[dy : dy + h, dx : dx + w])


def test_threads_share_the_work_and_seeds_differ():
    wall = endless_brick_tiling(3, seed=1)
    cells = wall.indices(-50, -20, 4300, 530)
    assert np.array_equal(cells[480:, 4000:], wall.indices(3950, 460, 300, 50))
    given = np.empty((530, 4300), np.int32)
    assert wall.indices(-50, -20, 4300, 530, out=given) is given
    assert np.array_equal(given, cells)
    assert (endless_brick_tiling(3, seed=2).indices(-50, -20, 200, 200) != cells[:200, :200]).mean() > 0.9


def test_endless_walls_are_the_same_everywhere_and_ever():
    assert digest(endless_brick_tiling(4, seed=7).indices(-5, 11, 40, 30)) == "4b65feb53589b2a0"
    assert (
        digest(endless_brick_tiling(2, seed=7, longest=(2, 5)).indices(-5, 11, 40, 30)) == "ce8bdf75d7de4076"
    )
    classes = np.arange(40 * 30).reshape(30, 40) * 7 // 3 % 2
    assert digest(brick_tiling(classes, 6, seed=7).cells) == "1f4f75b0b2b36b03"


@pytest.mark.parametrize(("n", "longest"), [(3, (2, 2)), (4, (3, 3)), (2, (3, 3)), (6, (8, 8))])
def test_endless_walls_have_no_grid_and_no_diagonals(n, longest):
    wall = endless_brick_tiling(n, seed=4, longest=longest)
    signs = brick_classes(wall.tiles)[wall.indices(0, 0, 1024, 1024)] * 2.0 - 1
    power = abs(np.fft.fft2(signs - signs.mean())) ** 2
    correlation = np.fft.ifft2(power).real / power.sum() * power.size
    correlation /= correlation[0, 0]
    for k in (1, 2, 3, 4, 5, 6):
        # The two diagonals alike, and rows like columns.
        assert abs(correlation[k, k] - correlation[k, -k]) < 0.02
        assert abs(correlation[0, k] - correlation[k, 0]) < 0.02
    far = correlation[8:-8, 8:-8]
    assert abs(far).max() < (0.04 if min(longest) == 2 else 0.006)
    # Blocks of 2 x 2 cells, from which the wall was made, have left no trace.
    for changes in (signs[:, 1:] != signs[:, :-1], (signs[1:] != signs[:-1]).T):
        assert abs(changes[:, ::2].mean() - changes[:, 1::2].mean()) < (0.03 if min(longest) == 2 else 0.012)


def naive_classes(n, longest, seed, x0, y0, width, height, rounds):
    """The classes as `kernels/flips.py` states them, cell by cell; True for V, right far from the margins."""
    along, down = longest
    r = max(longest)
    size, turns, slope = (2, 2 * r + 6, r + 2) if n == 2 else (1, r + 1, 1)
    y, x = np.mgrid[y0 : y0 + height, x0 : x0 + width]

    def bits(layer):
        halves = range(x0 >> 6 << 1, (x0 + width >> 6 << 1) + 2)
        words = {(a, b): mixer(12, seed, a, int(b), layer) for a in halves for b in y[:, 0]}
        # Of the two words of 64 cells, the first has the high bits.
        return np.array([[words[a >> 5 ^ 1, b] >> (a & 31) & 1 for a in x[0]] for b in y[:, 0]], bool)

    def square(points):
        south = np.roll(points, -1, 0) | points
        return south | np.roll(south, -1, 1)

    def runs(cells, length):
        full = np.lib.stride_tricks.sliding_window_view(cells, length + 1, 1).all(-1)
        return np.any([np.pad(full, ((0, 0), (k, length - k))) for k in range(length + 1)], axis=0)

    cells = (x + y & 1 == 1) ^ square(bits(0) & (x & y & 1 == 1))
    for n_th in range(rounds):
        chosen = bits(n_th + 1)
        for turn in range(turns):
            points = chosen & ((x + (slope if n_th & 1 else -slope) * y) % turns == turn)
            flips = square if size == 2 else np.copy
            trial = cells ^ flips(points)
            faults = runs(~trial, along) | runs(trial.T, down).T
            if size == 2:
                faults = faults | np.roll(faults, 1, 0)
                faults = faults | np.roll(faults, 1, 1)
            cells = cells ^ flips(points & ~faults)
    return cells


@pytest.mark.parametrize(("n", "longest", "rounds"), [(3, (2, 3), 4), (5, (5, 4), 2), (2, (4, 4), 2)])
def test_classes_equal_those_of_a_naive_program(n, longest, rounds):
    margin = 150 if n == 2 else 70
    x, y, size = -40, -1000, 60
    wall = endless_brick_tiling(n, seed=11, longest=longest)
    classes = brick_classes(wall.tiles)[wall.indices(x, y, size, size)]
    wide = size + 2 * margin
    naive = naive_classes(n, longest, 11, x - margin, y - margin, wide, wide, rounds)
    assert np.array_equal(classes, naive[margin:-margin, margin:-margin])


def naive_line(changes, n, first, words, start, following):
    """Colors behind each cell of a block, from the color before; see `kernels/bricks.py`."""
    at = np.flatnonzero(changes)
    colors, c = [], first
    for k, changed in enumerate(changes):
        if changed and k == at[0]:
            c = start
        elif changed:
            others = [(c + 1 + i) % n for i in range(n - 1)]
            if k == at[-1] and following in others:
                others.remove(following)
            c = others[(words[k] >> 16) * len(others) >> 16]
        colors.append(c)
    return colors


@pytest.mark.parametrize("n", [3, 7])
def test_edges_equal_those_of_a_naive_program(n):
    wall = endless_brick_tiling(n, seed=13)
    cells = wall.indices(0, 0, 128, 64)
    vertical = brick_classes(wall.tiles)[cells] == 1
    slots = wall.tiles.slots[cells]

    def color(layer, x, y):
        return (mixer(13, 13, x, y, layer) >> 8) * n >> 24

    for y in (0, 40):
        words = [mixer(13, 13, x, y) for x in range(64, 128)]
        found = naive_line(vertical[y, 64:], n, slots[y, 64, 3], words, color(1, 1, y), color(1, 2, y))
        assert found == slots[y, 64:, 1].tolist()
    for x in (0, 77):
        words = [mixer(13, 13, x, y) for y in range(32, 64)]
        found = naive_line(~vertical[32:, x], n, slots[32, x, 0], words, color(2, x, 1), color(2, x, 2))
        assert found == slots[32:, x, 2].tolist()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"positions": 1}, "positions is 1; allowed are 2 to 16"),
        ({"positions": 17}, "positions is 17"),
        ({"longest": (1, 3)}, "longest is 1; allowed are 2 to 8"),
        ({"longest": (3, 9)}, "longest is 9"),
        ({"longest": (3,)}, "longest has 1 entries"),
        ({"longest": "33"}, "longest must be two numbers"),
        ({"longest": (3, float("nan"))}, "longest must be an integer"),
        ({"seed": -1}, "seed is -1"),
    ],
)
def test_bad_endless_walls_are_told_in_one_line(change, message):
    with pytest.raises(TilewrightError, match=message) as caught:
        endless_brick_tiling(**change)
    assert "\n" not in str(caught.value)
