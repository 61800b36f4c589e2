"""What is made of walls: texture tiles, drawings, folders of maps, and the command that writes them."""

import json
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from typer.testing import CliRunner

import tilewright as tw
from tilewright.cli.main import app, names_of
from tilewright.errors import TilewrightError
from tilewright.export.drawing.walls import draw_wall
from tilewright.fields import TextureField
from tilewright.fields.bricks.bonds import BondBricks
from tilewright.fields.bricks.field import FILES, BrickField
from tilewright.fields.bricks.patterns import WangBricks
from tilewright.signals.bricks.style import PALETTES, BrickStyle
from tilewright.signals.bricks.texture import brick_texture_tiles
from tilewright.signals.textures.texture_tiles import copy_from_sources
from tilewright.tiles import wang_tiles
from tilewright.tiles.bricks import brick_tiles
from tilewright.tilings.bricks import endless_brick_tiling
from walls import SMALL, WALLS, Draughtboard, brick_classes, plain


@pytest.mark.parametrize("count", [2, 3])
def test_texture_tiles_agree_wherever_they_may_meet(count):
    tiles, size = brick_tiles(count), 48
    material = brick_texture_tiles(tiles, tile_size=size)
    height = material.maps["height"][..., 0] / 65535.0
    normal = material.maps["normal"].astype(float)
    relief = BrickStyle().fit(size, size - (count - 1) * size // (count + 1)).relief
    steps = max(np.abs(np.diff(height, axis=axis)).max() for axis in (1, 2))
    for axis, (far, near) in enumerate([(1, 3), (2, 0)]):
        h, v = (height, normal) if axis == 0 else (height.swapaxes(1, 2), normal.swapaxes(1, 2))
        for one in range(len(tiles)):
            fitting = tiles.fitting(**{"NESW"[near]: int(tiles.slots[one, far])})
            beyond = h[fitting, :, 0]
            assert np.abs(beyond - h[one, :, -1]).max() <= steps
            # The slope of the last column, from the neighbor's first one, is that of its normals.
            across = (h[one, :, -2] - beyond) * relief / 2
            shown = v[one, :, -1, axis] - 127.5, v[one, :, -1, 2] - 127.5
            slope = shown[0] / shown[1] * (1, -1)[axis]
            assert np.abs(slope - across).max() < 0.03
    # What is beside an edge depends on its color only.
    for color in range(count):
        column = height[tiles.slots[:, 3] == color][:, :, 0]
        assert np.ptp(column, axis=0).max() < 0.02


def test_texture_tiles_are_a_material_like_any_other(tmp_path):
    tiling = Draughtboard(2)
    material = brick_texture_tiles(tiling.tiles, BrickStyle("gray"), tile_size=40, seed=5)
    assert material.kinds == {
        "color": "color",
        "height": "height",
        "normal": "normal-gl",
        "roughness": "roughness",
    }
    tw.save(material, tmp_path / "tiles")
    loaded = tw.load(tmp_path / "tiles")
    copied = copy_from_sources(material.sources, material.origins)
    again = brick_texture_tiles(tiling.tiles, BrickStyle("gray"), tile_size=40, seed=5)
    for name, pixels in material.maps.items():
        assert np.array_equal(loaded.maps[name], pixels)
        assert np.array_equal(copied[name], pixels)
        assert np.array_equal(again.maps[name], pixels)
    picture = TextureField(loaded, tiling).render(0, 0, 80, 80, map="height")
    cells = tiling.indices(0, 0, 2, 2)
    assert np.array_equal(picture[40:, :40], material.maps["height"][cells[1, 0]])
    tw.save_array(material, tmp_path / "array.png")
    tw.save_viewer(material, tmp_path / "page.html")
    with pytest.raises(TilewrightError, match="complete corner sets"):
        tw.save_for_engine(material, tmp_path / "engine", "ktx2")


def test_texture_tiles_show_joints_where_walls_have_them():
    tiling, size = Draughtboard(3), 48
    style = plain(mortar=4)
    walls = BrickField(WangBricks(tiling, (size, size)), style).render_maps(0, 0, 240, 240)
    tiles = brick_texture_tiles(tiling.tiles, style, tile_size=size)
    laid = TextureField(tiles, tiling).render(0, 0, 240, 240, map="height")[..., 0]
    assert np.corrcoef(laid.ravel(), walls["height"].ravel())[0, 1] > 0.98


def test_a_drawing_has_the_bricks_of_the_picture():
    field = BrickField(Draughtboard(), BrickStyle(mortar=5), size=SMALL)
    window = (-60, 1000, 200, 150)
    ids = field.render(*window, map="id").reshape(-1, 2)
    pixels = {
        tuple(brick): int(n) for brick, n in zip(*np.unique(ids, axis=0, return_counts=True), strict=True)
    }
    drawn = {}
    ground, *bricks = ET.fromstring(draw_wall(field, *window)).findall("{http://www.w3.org/2000/svg}rect")
    for brick in bricks:
        x, y, width, height = (float(brick.get(name)) for name in ("x", "y", "width", "height"))
        low, high = np.array([x - 2, y - 2]), np.array([x + width + 3, y + height + 3])
        shown = high.clip(0, window[2:]) - low.clip(0, window[2:])
        drawn[tuple(map(int, brick.get("data-id").split()))] = shown.prod()
        assert len(brick.get("fill")) == 7
    assert drawn == pixels
    assert ground.get("width") == "200"


def test_lines_are_the_joints_each_of_them_once():
    pattern = BondBricks("herringbone", (32, 16))
    path = ET.fromstring(draw_wall(pattern, 3, 5, 160, 120, mode="lines"))[0].get("d")
    index, _ = pattern.locate(3, 5, 160, 120)
    upright, level = np.zeros((120, 161), int), np.zeros((121, 160), int)
    for line in path[1:].split("M"):
        (x, y), (u, v) = (tuple(int(n) for n in end.split()) for end in line.split("L"))
        if x == u:
            upright[y:v, x] += 1
        else:
            level[y, x:u] += 1
    assert np.array_equal(upright[:, 1:-1], index[:, 1:] != index[:, :-1])
    assert np.array_equal(level[1:-1], index[1:] != index[:-1])


def test_a_folder_holds_all_maps(tmp_path):
    field = BrickField(WALLS["wang"]())
    field.save(tmp_path / "wall", -20, 30, 70, 50)
    maps = field.render_maps(-20, 30, 70, 50)
    pictures = {name: tw.read_image(tmp_path / "wall" / file) for name, file in FILES.items()}
    for name in ("color", "height", "normal", "roughness", "mortar"):
        assert np.array_equal(pictures[name], maps[name])
    assert np.array_equal(pictures["preview"], field.render(-20, 30, 70, 50))
    both = np.concatenate([pictures["id"], maps["id"]], axis=2).reshape(-1, 5)
    assert (
        len(np.unique(both, axis=0))
        == len(np.unique(both[:, 3:], axis=0))
        == len(np.unique(both[:, :3], axis=0))
    )
    field.save(tmp_path / "wall", 0, 0, 30, 20)
    assert tw.read_image(tmp_path / "wall" / "height.png").shape == (20, 30, 1)
    field.save(tmp_path / "one.tif", -20, 30, 70, 50, map="normal")
    assert np.array_equal(tw.read_image(tmp_path / "one.tif"), maps["normal"])
    (tmp_path / "wall" / "notes.txt").write_text("mine")
    with pytest.raises(TilewrightError, match=r"notes\.txt"):
        field.save(tmp_path / "wall", 0, 0, 30, 20)


def call(*arguments):
    return CliRunner().invoke(app, ["bricks", *map(str, arguments)])


def test_the_command_writes_what_the_name_says(tmp_path):
    disk = np.hypot(*np.mgrid[-8:8, -6:6]) < 5
    tw.write_image(tmp_path / "disk.png", disk[..., np.newaxis] * np.uint8(255))
    np.savez(tmp_path / "sides.npz", horizontal=np.zeros((5, 7), int), vertical=np.full((4, 8), -1))
    small = ("--width", 3, "--height", 4, "--size", 24, 12)
    for options in (
        ("-o", "a.png", *small, "--x", -5, "--map", "height"),
        ("-o", "folder", *small, "--colors", "gray", "--mortar", 2),
        ("-o", "b.svg", *small, "--lines"),
        ("-o", "c.npy", *small),
        ("-o", "closed.npy", "--width", 12, "--height", 9, "--cyclic", "--longest", 4, 4),
        ("-o", "follows.npy", "--width", 12, "--height", 16, "--input", tmp_path / "disk.png"),
        ("-o", "region.npy", "--mask", tmp_path / "disk.png"),
        ("-o", "sides.npy", "--boundary", tmp_path / "sides.npz"),
        (
            "-o",
            "e.png",
            "--pattern",
            "herringbone",
            "--width",
            4,
            "--height",
            8,
            "--size",
            24,
            12,
            "--cyclic",
        ),
    ):
        done = call(options[0], tmp_path / options[1], *options[2:], "--json")
        assert done.exit_code == 0, done.exception
        assert json.loads(done.stdout)["file"].endswith(options[1])
    loaded = {path.stem: np.load(path) for path in tmp_path.glob("*.npy")}
    assert tw.read_image(tmp_path / "a.png").dtype == np.uint16
    assert tw.read_image(tmp_path / "folder" / "color.png").shape == (48, 72, 3)
    assert np.array_equal(loaded["c"], endless_brick_tiling(3).indices(0, 0, 3, 4))
    tw.array_tiling(brick_tiles(3), loaded["closed"], torus=True)
    classes = brick_classes(brick_tiles(3))
    assert (classes[loaded["follows"]] == disk).mean() > 0.6
    assert np.array_equal(loaded["region"] >= 0, disk)
    assert (brick_tiles(3).slots[loaded["sides"][0], 0] == 0).all()
    assert tw.read_image(tmp_path / "e.png").shape == (96, 96, 3)


@pytest.mark.parametrize(
    ("message", "options"),
    [
        ("--width is 0", ("--width", 0, "--height", 3)),
        ("ask for different walls", ("--boundary", "no.npz", "--cyclic")),
        ("no.npz does not exist", ("--boundary", "no.npz")),
        ("bonds have none", ("--pattern", "herringbone", "--width", 3, "--height", 3)),
    ],
)
def test_the_command_refuses_in_one_line(message, options, tmp_path):
    refused = call("-o", tmp_path / "wall.npy", *options)
    assert isinstance(refused.exception, TilewrightError)
    assert message in refused.exception.told(names_of(["bricks"]))
    assert not list(tmp_path.iterdir())


BAD = {
    "mortar is 22 pixels": lambda: BrickField(WangBricks(Draughtboard(), (48, 40)), BrickStyle(mortar=22)),
    "positions do not fit": lambda: WangBricks(Draughtboard(5), (48, 4)),
    "size must be a width": lambda: WangBricks(Draughtboard(), 48),
    "allowed are 4 to 4096": lambda: WangBricks(Draughtboard(), (48, 3)),
    "a line must traverse each": lambda: WangBricks(tw.direct(wang_tiles(2))),
    "must be brick Wang tiles": lambda: BrickField(tw.direct(tw.corner_tiles(2))),
    "takes a Tiling of brick": lambda: BrickField("wall"),
    "line must traverse": lambda: brick_texture_tiles(wang_tiles(2)),
    "tile_size is 20": lambda: brick_texture_tiles(brick_tiles(2), tile_size=20),
    "style must be a BrickStyle": lambda: BrickField(Draughtboard(), "red"),
    "colors is 'blue'": lambda: BrickStyle("blue"),
    "whole numbers": lambda: BrickStyle([(0.5, 1, 2)]),
    "holds 0 to 300": lambda: BrickStyle([(0, 1, 300)]),
    "wear is nan": lambda: BrickStyle(wear=float("nan")),
    "mortar is 0": lambda: BrickStyle(mortar=0),
    "bond is 'english'": lambda: BondBricks("english"),
    "multiple of its height, 20": lambda: BondBricks("herringbone", (50, 20)),
    "closes after multiples of 6": lambda: BondBricks("herringbone", (48, 16), (2, 4)),
    "this pattern has a size": lambda: BrickField(BondBricks("herringbone"), size=(4, 4)),
    "maps is 'colour'": lambda: BrickField(Draughtboard()).render_maps(maps=["colour"]),
    "width is 0": lambda: BrickField(Draughtboard()).render(0, 0, 0, 5),
    "x is 92233720368547758080": lambda: BrickField(Draughtboard(), size=(40, 20)).render(
        2**61 * 40, 0, 5, 5
    ),
    "map is 'ids'": lambda: BrickField(Draughtboard()).save("wall.png", map="ids"),
    "mode is 'ink'": lambda: draw_wall(Draughtboard(), mode="ink"),
    "allowed are 200,000": lambda: draw_wall(Draughtboard(), width=10**6, height=10**5),
}


@pytest.mark.parametrize("message", BAD)
def test_bad_input_gets_one_clear_line(message):
    with pytest.raises(TilewrightError, match=message) as caught:
        BAD[message]()
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("palette", PALETTES)
def test_palettes_are_of_bricks(palette):
    style = BrickStyle(palette)
    assert style.palette.shape == (7, 3)
    assert abs(style.palette.mean() - style.lime.mean()) < 0.35


def test_colors_are_written_as_people_write_them(tmp_path):
    assert BrickStyle("#aa3333, #884422").colors == ((0xAA, 0x33, 0x33), (0x88, 0x44, 0x22))
    assert BrickStyle("#aa3333").palette.shape == (1, 3)
    with pytest.raises(TilewrightError, match="expected '#' and six digits"):
        BrickStyle("#aa3333,#88")
    with pytest.raises(TilewrightError, match="gray, or colors as '#aa3333,#884422'"):
        BrickStyle("pink")
    call("-o", tmp_path / "w.svg", "--colors", "#10a020", "--pattern", "subway", "--width", 2, "--height", 2)
    fills = {r.get("fill") for r in ET.parse(tmp_path / "w.svg").iter("{http://www.w3.org/2000/svg}rect")}
    greens = [bytes.fromhex(fill[1:]) for fill in fills]
    assert sum(green > 2 * max(red, blue) for red, green, blue in greens) == len(fills) - 1  # and mortar


def test_an_unknown_ending_names_all_that_is_written(tmp_path):
    refused = call("-o", tmp_path / "wall.foo").exception
    assert "allowed are .png, .tif, " in str(refused)
    assert ".webp, .svg, .pdf, .dxf, .npy, and none for a folder of all maps" in str(refused)
