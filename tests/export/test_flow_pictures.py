"""Animations and maps of flows, and the command that makes them."""

import json
import subprocess

import numpy as np
import pytest
from PIL import Image

import commands
import tilewright as tw
from tilewright.errors import TilewrightError
from tilewright.export.drawing import flows as animation
from tilewright.export.drawing.flows import draw_density, draw_trails, save_animation
from tilewright.files import read_image, write_image
from tilewright.flows.flow import FlowTile, simulate_flow
from tilewright.pixels import LUMA
from tilewright.tilings.dappled import find_violations

HUES = [bytes.fromhex(hue[1:]) for hue in animation._HUES["direction"]]


def call(*arguments):
    commands.call("flow", *arguments)


@pytest.fixture(scope="module")
def flow():
    tiles = (
        FlowTile("-", 0.25),
        FlowTile("|", 0.25),
        FlowTile("+", 0.6, emits=0.05),
        FlowTile("-", 0.1, kills=1),
    )
    cells = np.random.default_rng(4).choice(4, (6, 9), p=(0.4, 0.4, 0.1, 0.1))
    return simulate_flow(cells, tiles, particles=12, steps=30, seed=2)


@pytest.fixture(scope="module")
def still():
    """One particle on an empty row, and where it is in each frame."""
    return simulate_flow(np.zeros((3, 7), int), [FlowTile("-", 0.25)], particles=1, steps=40, seed=1)


@pytest.mark.parametrize("color", ["direction", "particle"])
def test_a_gif_has_every_frame_and_one_palette(flow, tmp_path, color):
    save_animation(tmp_path / "a.gif", flow, size=10, color=color, rate=20)
    with Image.open(tmp_path / "a.gif") as film:
        assert (film.n_frames, film.size, film.info["loop"], film.info["duration"]) == (31, (90, 60), 0, 50)
        film.seek(15)
        shown = np.array(film.convert("RGB"))
    assert np.array_equal(shown, draw_trails(flow, frame=15, size=10, color=color))
    assert _local_palettes((tmp_path / "a.gif").read_bytes()) == 0


def _local_palettes(data):
    """How many pictures of a GIF bring their own palette, by walking its blocks."""
    at, found = 13 + 3 * 2 ** ((data[10] & 7) + 1), 0
    while data[at] != 0x3B:
        if data[at] == 0x21:
            at += 2
        else:
            packed = data[at + 9]
            found += packed >> 7
            at += 11 + (3 * 2 ** ((packed & 7) + 1) if packed >> 7 else 0)
        while data[at]:
            at += data[at] + 1
        at += 1
    return found


def test_a_webp_shows_the_same(flow, tmp_path):
    save_animation(tmp_path / "a.webp", flow, size=10)
    with Image.open(tmp_path / "a.webp") as film:
        assert (film.n_frames, film.size) == (31, (90, 60))
        film.seek(15)
        assert np.array_equal(np.array(film.convert("RGB")), draw_trails(flow, frame=15, size=10))


def test_dots_are_where_particles_are_in_the_color_of_their_way(still):
    for frame in range(0, 40, 5):
        pixels = draw_trails(still, frame=frame, size=20, trail=0)
        lit = (pixels == list(HUES[still.ways[frame, 0]])).all(axis=2)
        y, x = np.argwhere(lit).mean(axis=0) + 0.5
        across, down = still.positions[frame, 0] * 20
        if 4 < across < 136:
            assert (x, y) == pytest.approx((across, down), abs=0.6)


def test_trails_fade_behind_particles_and_around_borders(still):
    steps = np.diff(still.positions[:, 0, 0])
    assert np.abs(steps).max() > 3  # it goes around
    bare, lit = (draw_trails(still, frame=40, size=20, trail=t).astype(int) for t in (0, 12))
    changed = np.argwhere((bare != lit).any(axis=2))
    row = still.positions[0, 0, 1] * 20
    assert len(changed) > 20
    assert np.abs(changed[:, 0] + 0.5 - row).max() < 3
    # Where it was last the light is strongest.
    recent, old = (still.positions[frame, 0, 0] * 20 for frame in (37, 0))
    light = lit.sum(axis=2)[int(row)]
    assert light[int(recent)] > light[int(old)]


def test_trails_turn_at_centers():
    cells = tw.dapple(tw.random_start(8, 6, seed=1), {"H0": 2, "V1": 2}, cyclic=True)
    fast = simulate_flow(cells, [FlowTile("-", 0.7), FlowTile("|", 0.7)], particles=20, steps=30)
    bare, lit = (draw_trails(fast, size=32, trail=t).astype(int) for t in (0, 50))
    y, x = np.argwhere((bare != lit).any(axis=2)).T
    assert len(x) > 5000
    aside = np.minimum(*(np.abs(at % 32 + 0.5 - 16) for at in (x, y)))
    assert aside.max() < 3


def test_the_film_begins_and_ends_almost_empty(flow, tmp_path):
    save_animation(tmp_path / "a.gif", flow, size=10, trail=0)
    with Image.open(tmp_path / "a.gif") as film:
        lit = []
        for frame in (0, 15, 30):
            film.seek(frame)
            bright = np.array(film.convert("RGB")).max(axis=2) > 200
            lit.append(int(bright.sum()))
    assert lit[1] > 10
    assert lit[0] == lit[2] == 0


@pytest.mark.parametrize("size", [1, 8, 9])
def test_the_heat_map_is_lightest_where_density_is_highest(flow, size):
    pixels = draw_density(flow, size=size)
    assert pixels.shape == (6 * size, 9 * size, 3)
    light = pixels.astype(int).sum(axis=2).reshape(6, size, 9, size).max(axis=(1, 3))
    density = flow.density() if size < 4 else flow.arms().max(axis=2)
    assert light.ravel()[density.argmax()] == light.max()
    order = np.argsort(density.ravel())
    half = draw_density(flow, size=size, most=2 * density.max()).astype(int).sum(axis=2).max()
    assert half < light.max() == draw_density(flow, size=size, most=1e-9).astype(int).sum(axis=2).max()
    assert (np.diff(light.ravel()[order]) >= 0).all()


@pytest.mark.parametrize(
    ("ask", "said"),
    [
        (
            lambda f, p: save_animation(p / "a.avi", f),
            "the ending of the file is '.avi'; allowed are .gif, .webp, .mp4",
        ),
        (lambda f, p: save_animation(p / "a.gif", f, rate=0), "rate is 0"),
        (lambda f, p: save_animation(p / "a.gif", f, color="red"), "color is 'red'"),
        (lambda f, p: save_animation(p / "a.gif", f, trail=float("nan")), "trail is nan"),
        (lambda f, p: save_animation(p / "a.gif", "flow"), "flow must be a Flow, not str"),
        (lambda f, p: save_animation(__file__ + "/a.gif", f), "is not a folder"),
        (lambda f, p: draw_trails(f, frame=31), "frame is 31"),
        (lambda f, p: draw_trails(f, size=2), "size is 2"),
        (lambda f, p: draw_density(f, size=65), "size is 65"),
        (lambda f, p: draw_density(f, most=0), "most is 0"),
        (lambda f, p: draw_density(tw), "flow must be a Flow"),
    ],
)
def test_refusals(flow, tmp_path, ask, said):
    with pytest.raises(TilewrightError, match=said):
        ask(flow, tmp_path)
    assert not list(tmp_path.iterdir())


def test_large_pictures_are_refused(tmp_path):
    wide = simulate_flow(np.zeros((2000, 2000), int), particles=1, steps=100)
    with pytest.raises(
        TilewrightError, match="frame is 64000000; allowed are 1 to 16777216; take fewer cells"
    ):
        draw_trails(wide)
    with pytest.raises(TilewrightError, match="pixels is 256000000"):
        draw_density(wide)
    long = simulate_flow(np.zeros((500, 500), int), particles=1, steps=300)
    with pytest.raises(TilewrightError, match="frames times pixels is 1204000000"):
        save_animation(tmp_path / "a.gif", long, size=4)


def test_the_command_saves_what_the_library_makes(tmp_path, capsys):
    size = ("--width", 14, "--height", 9, "--steps", 30, "--particles", 40, "--seed", 3)
    call(
        "-o",
        tmp_path / "a.npz",
        *size,
        "--cyclic",
        "--limit",
        "H0=2",
        "--limit",
        "V1=2",
        "--json",
        "--every",
        7,
    )
    said = json.loads(capsys.readouterr().out)
    cells = tw.dapple(tw.random_start(14, 9, seed=3), {"H0": 2, "V1": 2}, cyclic=True, seed=3)
    tiles = (FlowTile("-", 0.125), FlowTile("|", 0.125))
    flow = simulate_flow(cells, tiles, particles=40, steps=30, every=7, seed=3)
    with np.load(tmp_path / "a.npz") as file:
        assert np.array_equal(file["cells"], cells)
        assert np.array_equal(file["positions"], flow.positions)
        assert file["tile_ways"][:2].tolist() == ["-", "|"]
        assert file["tile_speed"][8] == 0.125 * 2.5
    assert said["frames"] == len(flow.times) == 6
    assert said["alive"] == 40
    assert said["variation"] == pytest.approx(flow.visits().std() / flow.visits().mean(), abs=1e-4)


def test_the_command_strews_tiles_and_balances(tmp_path, capsys):
    extra = ("--emit", 0.2, "--births", 0.1, "--kill", 0.1, "--slow", 0.1, "--fast", 0.1)
    call("-o", tmp_path / "a.npz", "--width", 20, "--height", 12, *extra, "--leave", "--onward", "--json")
    said = json.loads(capsys.readouterr().out)
    assert said["alive"] == said["start"] + said["born"] - said["killed"] - said["left"]
    assert min(said["born"], said["killed"], said["left"]) > 10
    ways = np.load(tmp_path / "a.npz")["cells"] % 2
    limits = {"H0": 3, "V0": 3, "H1": 3, "V1": 3}
    assert not any(bad.any() for bad in find_violations(ways, limits).values())


def test_the_command_follows_a_picture_and_draws_maps(tmp_path, capsys):
    write_image(tmp_path / "p.png", np.tile(np.array([0, 255], np.uint8).repeat(20), (20, 1))[..., None])
    size = ("--input", tmp_path / "p.png", "--width", 20, "--height", 10, "--steps", 60, "--limit", "H0=6")
    call("-o", tmp_path / "a.npz", *size)
    ways = np.load(tmp_path / "a.npz")["cells"] % 2
    assert ways[:, 10:].mean() > 0.9
    assert ways[:, :10].mean() < 0.4
    call("-o", tmp_path / "d.png", *size, "--size", 8)
    call("-o", tmp_path / "t.png", *size, "--size", 8, "--map", "trails", "--color", "particle")
    call("-o", tmp_path / "a.gif", *size, "--size", 6, "--trail", 3, "--fps", 10)
    assert read_image(tmp_path / "d.png").shape == read_image(tmp_path / "t.png").shape == (80, 160, 3)
    with Image.open(tmp_path / "a.gif") as film:
        assert (film.n_frames, film.info["duration"]) == (61, 100)
    assert "60 steps; born 0, killed 0, left 0, alive 250" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (
            ("-o", "a.avi"),
            "which ends in '.avi'; allowed are .gif, .webp, .mp4, .png, .npz",
        ),
        (("--limit", "H2=2"), "--limit is 'H2'; allowed are H0, V0, H1, V1"),
        (("--limit", "H0=x"), "--limit H0 is 'x'"),
        (("-o", "a.npz", "--fps", 3), "--fps has no use with a .npz file"),
        (("-o", "a.png", "--trail", 3), "--trail has no use with a density"),
        (("--map", "trails"), "--map has no use with an animation"),
        (("--dither",), "--dither is about a picture"),
        (("--leave", "--cyclic"), "--leave is about borders"),
        (("--emit", 0.7, "--kill", 0.7), "the sum of the shares is 1.4"),
        (("--speed", 9), "--speed is 9"),
        (("--particles", -1), "particles is -1"),
        (("--width", 0), "--width is 0"),
    ],
)
def test_the_command_refuses(tmp_path, monkeypatch, arguments, said):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(TilewrightError, match=said) as raised:
        call(*arguments)
    assert "\n" not in str(raised.value)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("size", "shown"), [(5, (46, 30)), (8, (72, 48))])
def test_a_video_shows_the_frames_in_even_sides(flow, tmp_path, size, shown):
    ffmpeg = pytest.importorskip("imageio_ffmpeg")
    save_animation(tmp_path / "a.mp4", flow, size=size, rate=30)
    read = [ffmpeg.get_ffmpeg_exe(), "-i", tmp_path / "a.mp4", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    done = subprocess.run(read, capture_output=True, check=True)
    told = done.stderr.decode().partition("Output")[0]
    for word in ("h264", "yuv420p", "bt709", "{}x{}".format(*shown), "30 fps"):
        assert word in told
    frames = np.frombuffer(done.stdout, np.uint8).reshape(len(flow.times), *shown[::-1], 3)
    wanted = draw_trails(flow, frame=15, size=size) @ LUMA
    away = [np.abs(frame[: len(wanted), : len(wanted[0])] @ LUMA - wanted).mean() for frame in frames]
    assert np.argmin(away) == 15
    assert away[15] < 3.5  # of 255; colors have half as many pixels
    mean = draw_trails(flow, frame=15, size=size).mean(axis=(0, 1))
    assert np.allclose(frames[15][: len(wanted), : len(wanted[0])].mean(axis=(0, 1)), mean, atol=3)


def test_a_video_has_the_same_bytes_again_and_no_date(flow, tmp_path):
    pytest.importorskip("imageio_ffmpeg")
    for name in "ab":
        save_animation(tmp_path / f"{name}.mp4", flow, size=8)
    assert (tmp_path / "a.mp4").read_bytes() == (tmp_path / "b.mp4").read_bytes()
    assert b"Lavf" not in (tmp_path / "a.mp4").read_bytes()


def test_a_video_that_is_stopped_or_refused_leaves_nothing(flow, tmp_path, monkeypatch):
    pytest.importorskip("imageio_ffmpeg")

    def stop(done, total, what):
        if done == 5:
            raise tw.Cancelled

    with pytest.raises(tw.Cancelled):
        save_animation(tmp_path / "a.mp4", flow, size=8, progress=stop)
    monkeypatch.setattr("tilewright.export.drawing.videos._THREADS", "many")
    with pytest.raises(TilewrightError, match=r"b\.mp4 could not be written: ffmpeg says: ."):
        save_animation(tmp_path / "b.mp4", flow, size=8)
    assert not list(tmp_path.iterdir())
