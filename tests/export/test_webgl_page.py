"""The WebGL 2 page of the GLSL export in headless Chromium, opened from disk: the same pixels as Python's."""

import base64
from dataclasses import replace

import numpy as np
import pytest

import tilewright as tw
from browsing import NEEDS_BROWSER, watched_page
from handmade import handmade, of_numbers, under_clouds
from tilewright.export.engines import save_for_engine

READ = """wanted => {
  Object.assign(view, wanted);
  draw();
  const { width, height } = canvas, upward = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, upward);
  if (gl.getError()) throw new Error("WebGL complains");
  let text = "";
  for (let y = height - 1; y >= 0; y--) {
    text += String.fromCharCode(...upward.subarray(4 * width * y, 4 * width * (y + 1)));
  }
  return btoa(text);
}"""

pytestmark = NEEDS_BROWSER


@pytest.fixture
def open_page(browser, tmp_path):
    """Export a material and open its page; fails on console messages and on requests but to the folder."""
    pages, complaints = [], []

    def open_(material, seed=7, width=160, height=120):
        folder = tmp_path / f"glsl{len(pages)}"
        save_for_engine(material, folder, "glsl", seed=seed)
        page = watched_page(browser, complaints, (folder.as_uri(), "data:"), width, height)
        pages.append(page)
        page.goto((folder / "index.html").as_uri())
        return page

    yield open_
    for page in pages:
        page.context.close()
    # SwiftShader warns that reading pixels back stalls; nothing else may be said.
    assert [c for c in complaints if "ReadPixels" not in c] == []


def read(page, width=160, height=120, **wanted):
    told = base64.b64decode(page.evaluate(READ, wanted))
    return np.frombuffer(told, np.uint8).reshape(height, width, 4)[..., :3]


@pytest.mark.parametrize(
    ("tiles", "variants"),
    [
        *((tw.corner_tiles(c), v) for c, v in ((1, 1), (3, 1), (4, 1), (7, 1), (8, 1), (2, 3), (4, 3))),
        (tw.classed_corner_tiles(2, 5), 1),
    ],
    ids=lambda v: getattr(v, "colors", v),
)
def test_at_one_texel_per_pixel_the_page_shows_what_python_renders(open_page, tiles, variants):
    """Texture arrays up to 256 pictures, packed atlases of an even and an odd number above."""
    material = handmade(tiles, 16, variants=tw.Variants.uniform(tiles, variants))
    seed = 2**64 - len(tiles)
    page = open_page(material, seed)
    field = tw.TextureField(material, tw.direct(material.tiles, seed))
    for x, y in ((-3, 5), (-1, -1), (2**31 - 40, -(2**31) + 9), (123456789, -987654321)):
        shown = read(page, cell=[x, y], place=[3 / 16, 11 / 16], zoom=1)
        assert np.array_equal(shown, field.render(16 * x + 3 - 80, 16 * y + 11 - 60, 160, 120))


@pytest.mark.parametrize("span", [1, 3])
def test_the_page_lays_the_tone(open_page, span):
    material = under_clouds(handmade(tw.classed_corner_tiles(2, 5), 32, maps=2), span)
    page = open_page(material)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))
    for x, y in ((-3, 5), (-1, -1), (2**31 - 40, -(2**31) + 9), (123456789, -987654321)):
        place = 32 * x + 3 - 80, 32 * y + 11 - 60, 160, 120
        shown = read(page, cell=[x, y], place=[3 / 32, 11 / 32], zoom=1, map="map0").astype(int)
        off = np.abs(shown - field.render(*place))
        assert off.max() <= 2
        assert off.mean() < 0.4
        shown = read(page, cell=[x, y], place=[3 / 32, 11 / 32], zoom=1, map="map1")
        assert np.array_equal(shown, field.render(*place, map="map1"))


@pytest.mark.parametrize("kind", ["roughness", "height"])
def test_the_page_lays_the_tone_of_numbers(open_page, kind):
    material = of_numbers(under_clouds(handmade(tw.classed_corner_tiles(2, 5), 32), 2), kind)
    shown = read(open_page(material), cell=[-3, 5], place=[3 / 32, 11 / 32], zoom=1, map="map0").astype(int)
    wanted = tw.TextureField(material, tw.direct(material.tiles, 7)).render(
        -96 + 3 - 80, 160 + 11 - 60, 160, 120
    )
    assert np.abs(shown - wanted).max() <= 2


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_maps_of_numbers_keep_their_bytes(open_page, channels):
    material = handmade(tw.corner_tiles(2), 16, channels=channels, maps=2)
    material = replace(material, kinds={"map0": "data", "map1": "data"})
    page = open_page(material)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))
    few = min(channels, 3)
    for map in ("map0", "map1"):
        shown = read(page, cell=[0, 0], place=[0, 0], map=map)
        assert np.array_equal(shown[..., :few], field.render(-80, -60, 160, 120, map=map)[..., :few])


@pytest.mark.parametrize("kind", [np.uint16, np.float32])
def test_deep_maps_show_the_nearest_byte(open_page, kind):
    material = replace(handmade(tw.corner_tiles(2), 16, kind), kinds={"map0": "data"})
    page = open_page(material)
    shown = read(page, cell=[0, 0], place=[0, 0])
    wanted = tw.TextureField(material, tw.direct(material.tiles, 7)).render(-80, -60, 160, 120)
    half = (wanted / np.float32(1 if kind is np.float32 else 65535)).astype(np.float16)
    assert np.abs(shown - half.astype(np.float64) * 255).max() < 0.501


def rolling(colors, size=32, border=4):
    """Tiles that match: gray that runs from corner to corner, and noise of their own off the borders."""
    material = handmade(tw.corner_tiles(colors), size, channels=1)
    rng = np.random.default_rng(colors)
    ne, se, sw, nw = np.linspace(0.2, 0.8, colors)[material.tiles.slots.T][..., None, None]
    east = (np.arange(size) + 0.5) / size
    south = east[:, None]
    gray = (nw * (1 - east) + ne * east) * (1 - south) + (sw * (1 - east) + se * east) * south
    inside = slice(border, size - border)
    noise = rng.uniform(-0.15, 0.15, gray.shape)
    gray[:, inside, inside] += noise[:, inside, inside]
    pixels = np.rint(255 * gray).astype(np.uint8)[..., None]
    return replace(material, maps={"color": pixels}, kinds={})


@pytest.mark.parametrize("shrink", [2, 16])
@pytest.mark.parametrize("colors", [2, 5])
def test_seen_from_afar_no_line_shows_at_tile_borders(open_page, colors, shrink):
    """Steps across tile borders are no larger than in a supersampled picture, and the page is near that."""
    material = rolling(colors)
    n = material.tile_size
    side = 128
    page = open_page(material, width=side, height=side)
    # One pixel off, so that borders run through the squares of 2 x 2 pixels that gradients come from.
    place = [shrink / n, shrink / n]
    shown = read(page, side, side, cell=[5, 9], place=place, zoom=1 / shrink)[..., 0].astype(float)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))
    left, top, wide = (5 * n - 63 * shrink, 9 * n - 63 * shrink, side * shrink)
    fine = field.render(left, top, wide, wide)[..., 0] / 255
    light = np.where(fine <= 0.04045, fine / 12.92, ((fine + 0.055) / 1.055) ** 2.4)
    mean = light.reshape(side, shrink, side, shrink).mean(axis=(1, 3))
    wanted = np.where(mean <= 0.0031308, mean * 12.92, 1.055 * mean ** (1 / 2.4) - 0.055) * 255
    quality = 10 * np.log10(255**2 / np.mean((shown - wanted) ** 2))
    border = ((np.arange(side - 1) + 1) * shrink + left) % n < shrink

    def steps_over_borders(picture):
        return np.abs(np.diff(picture, axis=1))[:, border].mean()

    assert steps_over_borders(shown) < 1.1 * steps_over_borders(wanted) + 0.25
    # Where a tile is two texels wide, most of it is what all tiles share.
    assert quality > {2: 47, 4: 36, 8: 32, 16: 22}[shrink]


def test_the_page_moves_zooms_tilts_and_changes_the_map(open_page):
    page = open_page(handmade(tw.corner_tiles(2), 16, maps=2), width=320, height=240)
    page.mouse.move(200, 100)
    page.mouse.down()
    page.mouse.move(72, 132, steps=4)
    page.mouse.up()
    cell, place = page.evaluate("[view.cell, view.place]")
    assert np.allclose(np.add(cell, place), [8, -2])
    page.mouse.wheel(0, -400)
    page.wait_for_function("view.zoom > 1.9")
    flat = read(page, 320, 240)
    page.locator("#tilt").fill("60")
    assert page.evaluate("view.tilt") == pytest.approx(np.pi / 3)
    tilted = read(page, 320, 240)
    assert not np.array_equal(tilted, flat)
    page.select_option("#map", "map1")
    assert not np.array_equal(read(page, 320, 240), tilted)
