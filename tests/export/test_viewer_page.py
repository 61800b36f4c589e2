"""The viewer page in headless Chromium: the same pixels as Python's, and controls that work."""

import base64
import dataclasses

import numpy as np
import pytest

import tilewright as tw
from browsing import NEEDS_BROWSER, watched_page
from handmade import handmade, of_numbers, under_clouds
from tilewright.analysis import compare_textures
from tilewright.errors import TilewrightError
from tilewright.fields.photos.contenders import side_by_side
from tilewright.signals.textures.patch_names import PatchNames

READ = """() => {
  const p = tilewright.pixels();
  let text = "";
  for (let i = 0; i < p.data.length; i += 8192) text += String.fromCharCode(...p.data.subarray(i, i + 8192));
  return { width: p.width, height: p.height, data: btoa(text) };
}"""

pytestmark = NEEDS_BROWSER


@pytest.fixture
def open_page(browser, tmp_path):
    """Open a viewer of a material; fails on console errors and on any request but the file itself."""
    pages, complaints = [], []

    def open_(material, seed=0, width=160, height=120, compare=None):
        path = tmp_path / f"view{len(pages)}.html"
        tw.save_viewer(material, path, seed=seed, compare=compare)
        page = watched_page(browser, complaints, ("file:", "data:", "blob:"), width, height)
        pages.append(page)
        page.goto(path.as_uri())
        page.evaluate("tilewright.ready")
        return page

    yield open_
    for page in pages:
        page.context.close()
    # SwiftShader warns that reading pixels back stalls; nothing else may be said.
    assert [c for c in complaints if "ReadPixels" not in c] == []


def read(page):
    got = page.evaluate(READ)
    data = np.frombuffer(base64.b64decode(got["data"]), np.uint8)
    return data.reshape(got["height"], got["width"], 4)[..., :3]


def view(page, **wanted):
    return page.evaluate("wanted => tilewright.view(wanted)", wanted)


def wait_until(page, holds):
    """Give the page time; the page's own policy forbids waiting inside it."""
    for _ in range(50):
        if holds():
            return
        page.wait_for_timeout(100)
    pytest.fail("the page did not follow")


def origin(state, size):
    corner = state["corner"]
    return int(corner["cellX"]) * size + round(corner["texelX"]), int(corner["cellY"]) * size + round(
        corner["texelY"]
    )


SETS = {
    "corner": tw.corner_tiles(3),
    "classed": tw.classed_corner_tiles(2, 5),
    "wang": tw.wang_tiles(2, 3),
    "summed": tw.summed_wang_tiles(3),
    "shifted": tw.shifted_wang_tiles(4),
    "coded": tw.corner_coded_tiles(),
}


@pytest.mark.parametrize("name", SETS)
def test_at_one_texel_per_pixel_the_page_shows_what_python_renders(open_page, name):
    material = handmade(SETS[name], 16)
    page = open_page(material, seed=7)
    for seed, x, y in ((7, -3, 5), (2**64 - 1, 2**40, -(2**40)), (123, 2**32, -1)):
        state = view(page, seed=str(seed), cellX=str(x), cellY=str(y), pixelsPerTile=16)
        shown = read(page)
        field = tw.TextureField(material, tw.direct(material.tiles, seed))
        assert np.array_equal(shown, field.render(*origin(state, 16), shown.shape[1], shown.shape[0]))


@pytest.mark.parametrize(
    ("name", "weighted"), [("corner", True), ("wang", False), ("coded", True), ("cohen", True)]
)
def test_the_page_draws_the_variants_that_python_draws(open_page, name, weighted):
    tiles = SETS.get(name) or tw.cohen_tiles(18)
    variants = tw.Variants.uniform(tiles, 3)
    if weighted:
        variants = tw.Variants.weighted([([1], [0, 2.5, 1], [3, 1])[t % 3] for t in range(len(tiles))])
    material = handmade(tiles, 16, variants=variants)
    page = open_page(material, seed=7)
    places = ((7, -3, 5), (2**64 - 1, 2**40, -(2**40)), (123, 2**32, -1))
    if name == "cohen":  # a stored patch, which stays with its seed
        places = ((7, 20, 30), (7, 200, 180))
    for seed, x, y in places:
        tiling = tw.stochastic(tiles, 256, 256, seed)
        state = view(page, seed=str(seed), cellX=str(x), cellY=str(y), pixelsPerTile=16)
        shown = read(page)
        field = tw.TextureField(material, tiling)
        assert np.array_equal(shown, field.render(*origin(state, 16), shown.shape[1], shown.shape[0]))
        placed = tiling.placements(x, y, 9, 4, variants=variants)
        told = page.evaluate(
            "([x, y]) => [...Array(36).keys()].map((n) => {"
            "  const at = [BigInt(x) + BigInt(n % 9), BigInt(y) + BigInt(Math.floor(n / 9))];"
            "  return [tilewright.tileAt(...at), tilewright.variantAt(...at)]; })",
            [str(x), str(y)],
        )
        assert told == np.stack([placed.indices.ravel(), placed.variants.ravel()], axis=1).tolist()


@pytest.mark.parametrize("span", [1, 3])
def test_the_page_lays_the_tone_that_python_lays(open_page, span):
    material = under_clouds(handmade(tw.classed_corner_tiles(2, 5), 32, maps=2), span)
    page = open_page(material, seed=7)
    for seed, x, y in ((7, -3, 5), (2**64 - 1, 2**40 + 1, -(2**40)), (123, 2**32, -1)):
        state = view(page, seed=str(seed), cellX=str(x), cellY=str(y), pixelsPerTile=32)
        shown = read(page).astype(int)
        field = tw.TextureField(material, tw.direct(material.tiles, seed))
        wanted = field.render(*origin(state, 32), shown.shape[1], shown.shape[0])
        assert np.abs(shown - wanted).max() <= 2
        assert np.abs(shown - wanted).mean() < 0.3
        bare = dataclasses.replace(material, tone=None)
        without = tw.TextureField(bare, field.tiling).render(*origin(state, 32), *shown.shape[1::-1])
        assert np.abs(shown - without).mean() > 3
    page.select_option("#map", "map1")
    wait_until(page, lambda: view(page)["map"] == "map1")
    shown = read(page)
    assert np.array_equal(shown, field.render(*origin(state, 32), *shown.shape[1::-1], map="map1"))


def test_roughness_below_zero_stretches_nothing(open_page):
    """Tiles of floats have it where dark specks lost their tone."""
    material = of_numbers(
        under_clouds(handmade(tw.classed_corner_tiles(2, 5), 32, np.float32), 2), "roughness"
    )
    specks = {
        name: np.where(pixels < 0.41, np.float32(-0.1), pixels) for name, pixels in material.maps.items()
    }
    material = dataclasses.replace(material, maps=specks)
    page = open_page(material, seed=7)
    state = view(page, seed="7", cellX="-3", cellY="5", pixelsPerTile=32)
    shown = read(page).astype(int)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))
    wanted = 255 * field.render(*origin(state, 32), shown.shape[1], shown.shape[0])
    assert np.median(np.abs(shown - wanted)) <= 1
    assert (np.abs(shown - wanted) > 2).mean() < 0.12  # the specks


@pytest.mark.parametrize("kind", [np.uint8, np.float32])
def test_the_page_lays_the_tone_of_heights(open_page, kind):
    """In floats they reach beyond 1, and the page shows what their tone needs too."""
    material = of_numbers(under_clouds(handmade(tw.classed_corner_tiles(2, 5), 32, kind), 2), "height")
    page = open_page(material, seed=7)
    state = view(page, seed="7", cellX="-3", cellY="5", pixelsPerTile=32)
    shown = read(page)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))
    wanted = field.render(*origin(state, 32), shown.shape[1], shown.shape[0]).astype(float)
    slope, base = np.polyfit(wanted.ravel(), shown.ravel().astype(float), 1)
    assert np.abs(slope * wanted + base - shown).max() < 3
    if kind is np.float32:
        assert np.ptp(wanted) < 255 / slope < 2 * np.ptp(wanted)
    else:
        assert slope == pytest.approx(1, abs=0.01)


@pytest.mark.parametrize("tiles", [tw.corner_tiles(3, 2), tw.cohen_tiles(18)], ids=repr)
def test_a_stored_patch_keeps_its_tone(open_page, tiles):
    material = under_clouds(handmade(tiles, 32), 1)
    page = open_page(material, seed=3)
    state = view(page, cellX="20", cellY="30", pixelsPerTile=32)
    shown = read(page).astype(int)
    field = tw.TextureField(material, tw.stochastic(tiles, 256, 256, 3))
    assert np.abs(shown - field.render(*origin(state, 32), *shown.shape[1::-1])).max() <= 2


def test_a_set_without_a_direct_tiling_is_shown_as_a_patch(open_page):
    material = handmade(tw.cohen_tiles(18), 16)
    page = open_page(material, seed=3)
    state = view(page, cellX="20", cellY="30", pixelsPerTile=16)
    shown = read(page)
    field = tw.TextureField(material, tw.scanline(material.tiles, 256, 256, 3))
    assert np.array_equal(shown, field.render(*origin(state, 16), shown.shape[1], shown.shape[0]))


def test_controls(open_page):
    page = open_page(handmade(tw.corner_tiles(2), 16, maps=2), width=120, height=160)
    view(page, pixelsPerTile=32)
    first = read(page)
    page.fill("#seed", "99")
    assert view(page)["seed"] == "99"
    assert not np.array_equal(read(page), first)
    page.fill("#seed", "not a number")
    assert "whole number" in page.inner_text("#seed-note")
    assert view(page)["seed"] == "99"
    before = read(page)
    for name, key in (("borders", "b"), ("repeat", "r")):
        page.check(f"#{name}")
        assert view(page)[name] is True
        assert not np.array_equal(read(page), before)
        page.focus("#plane")
        page.keyboard.press(key)
        assert view(page)[name] is False
        assert np.array_equal(read(page), before)
    page.select_option("#map", "map1")
    wait_until(page, lambda: view(page)["map"] == "map1")
    assert not np.array_equal(read(page), before)


def test_pan_zoom_and_tilt(open_page):
    page = open_page(handmade(tw.corner_tiles(2), 16), width=320, height=400)
    view(page, pixelsPerTile=32)
    before = view(page)
    page.mouse.move(300, 150)
    page.mouse.down()
    page.mouse.move(236, 118, steps=2)
    page.mouse.up()
    after = view(page)

    def place(state):
        return np.array([int(state["cellX"]) + state["x"], int(state["cellY"]) + state["y"]])

    assert np.allclose(place(after) - place(before), (2, 1), atol=0.05)
    page.mouse.wheel(0, -400)
    wait_until(page, lambda: view(page)["pixelsPerTile"] > after["pixelsPerTile"])
    flat = read(page)
    page.locator("#tilt").fill("60")
    assert view(page)["tilt"] == pytest.approx(np.pi / 3, abs=0.02)
    assert not np.array_equal(read(page), flat)
    page.click("#reset")
    assert view(page)["tilt"] == 0


NAMED = {
    "corner": (tw.corner_tiles(2), {"method": "nested"}),
    "variants": (tw.corner_tiles(2), {"method": "ng", "variants": 2}),
    "wang": (tw.wang_tiles(2), {}),
    "squares": (tw.corner_tiles(2), {"method": "squares"}),
    "stored": (tw.cohen_tiles(8), {}),
    "default": (None, {}),
}


def name_at(field, x, y):
    """What the readout says of a pixel of the plane: the tile, and the patch in the middle of the square."""
    material, size = field.material, field.material.tile_size
    placed = field.tiling.placements(x // size, y // size, 1, 1, variants=material.variants)
    tile, variant = int(placed.indices[0, 0]), int(placed.variants[0, 0])
    index, names = PatchNames(material).of_picture(int(material.variants.starts[tile]) + variant)
    number = index[y % size // 4 * 4 + 2, x % size // 4 * 4 + 2]
    told = f"tile {tile}" + (f", variant {variant}" if len(material.variants) > len(material.tiles) else "")
    return told + (f": {names[number]}" if number >= 0 else "")


@pytest.mark.parametrize("name", NAMED)
def test_the_readout_names_tile_and_patch_under_the_pointer(open_page, gravel, name):
    """As Python does, near and far, panned and tilted; the middle of the view where there is no pointer."""
    tiles, options = NAMED[name]
    material = tw.texture_tiles(gravel[:200, :200], tiles, tile_size=32, seed=1, **options)
    page = open_page(material, seed=7, width=800, height=300)  # small: it is drawn by the processor
    field = tw.TextureField(material, tw.stochastic(material.tiles, 256, 256, 7))
    seen = set()
    for pixels, tilt, cell in ((32, 0, (200, 180)), (96, 0.6, (7, 9))):
        view(page, cellX=str(cell[0]), cellY=str(cell[1]), pixelsPerTile=pixels, tilt=tilt)
        for at in ((40, 160), (433, 122), (333, 222)):
            page.mouse.move(*at)
            place = page.evaluate("([x, y]) => tilewright.locate(x, y)", at)
            x, y = (int(place[f"cell{a}"]) * 32 + int(place[f"texel{a}"]) for a in "XY")
            told = page.inner_text("#tile")
            assert told == name_at(field, x, y)
            seen.add(told.partition(": ")[2])
            if not tilt and pixels == 32:
                corner = origin(view(page), 32)
                assert (x, y) == (corner[0] + at[0], corner[1] + at[1])
    assert len(seen - {""}) > (1 if name == "squares" else 3)  # which has no others
    assert seen - {""} <= material.recipe["patches"].keys()


def test_a_patch_is_named_to_the_squares_that_are_told(open_page, gravel):
    material = tw.texture_tiles(gravel[:200, :200], tw.corner_tiles(2), tile_size=64, seed=1)
    page = open_page(material, seed=7)
    tile = page.evaluate("tilewright.tileAt(5, 6)")
    told = page.evaluate(
        "[...Array(4096).keys()].map((n) => tilewright.patchAt(5, 6, n % 64, Math.floor(n / 64)))"
    )
    index, names = PatchNames(material).of_picture(tile)
    exact = [names[number] if number >= 0 else "" for number in index.ravel()]
    assert np.mean(np.array(told) == np.array(exact)) > 0.9
    assert page.evaluate("tilewright.patchAt(5, 6, 32, 32)") == f"center:{tile}"


def test_what_the_pointer_is_on_is_announced_when_it_stays(open_page, gravel):
    material = tw.texture_tiles(gravel[:200, :200], tw.corner_tiles(2), tile_size=32, seed=1)
    page = open_page(material, seed=7, width=400, height=300)
    page.wait_for_timeout(900)
    assert page.inner_text("#told") == ""  # nobody is on the plane
    page.focus("#plane")
    told = page.evaluate(  # at once, however slow the machine is
        """() => ["ArrowRight", "ArrowDown", "ArrowRight"].map((key) => {
          document.activeElement.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
          return document.getElementById("told").textContent;
        })"""
    )
    assert told == ["", "", ""]
    wait_until(page, lambda: page.text_content("#told"))
    assert page.text_content("#told") == f"{page.inner_text('#cell')}, {page.inner_text('#tile')}"
    assert page.get_attribute("#told", "role") == "status"


def test_names_of_patches_add_little(tmp_path, gravel):
    material = tw.texture_tiles(gravel[:200, :200], tw.corner_tiles(2), tile_size=64, seed=1)
    tw.save_viewer(material, tmp_path / "a.html")
    tw.save_viewer(dataclasses.replace(material, recipe={}), tmp_path / "b.html")
    with_names, without = ((tmp_path / name).stat().st_size for name in ("a.html", "b.html"))
    assert 1 < with_names / without < 1.03


@pytest.mark.parametrize("shrink", [2, 16])
def test_no_line_shows_at_tile_borders_when_minified(open_page, gravel_tiles, shrink):
    """Steps across tile borders are those inside, and the picture is near a supersampled one."""
    material, side = gravel_tiles, 128
    page = open_page(material, seed=5, width=side, height=side)
    state = view(page, cellX="4", cellY="6", pixelsPerTile=64 / shrink)
    shown = read(page)[..., 0].astype(float)
    corner = state["corner"]
    x = int(corner["cellX"]) * 64 + corner["texelX"]
    y = int(corner["cellY"]) * 64 + corner["texelY"]
    assert x == round(x)
    assert y == round(y)
    field = tw.TextureField(material, tw.direct(material.tiles, 5))
    fine = field.render(round(x), round(y), side * shrink, side * shrink)[..., 0] / 255
    light = np.where(fine <= 0.04045, fine / 12.92, ((fine + 0.055) / 1.055) ** 2.4)
    mean = light.reshape(side, shrink, side, shrink).mean(axis=(1, 3))
    wanted = np.where(mean <= 0.0031308, mean * 12.92, 1.055 * mean ** (1 / 2.4) - 0.055) * 255
    error = np.mean((shown - wanted) ** 2)
    assert 10 * np.log10(255**2 / error) > 45
    columns = (np.arange(side - 1) + 1) * shrink + round(x)
    border = columns % 64 < shrink

    def excess(picture):
        steps = np.abs(np.diff(picture, axis=1))
        return steps[:, border].mean() / steps[:, ~border].mean()

    # Few tiles meet here, so their content alone makes steps differ: the supersampled picture says how much.
    assert excess(shown) < 1.05 * excess(wanted)


@pytest.fixture(scope="module")
def pair(gravel):
    """A colored oblong photograph by five methods."""
    color = np.stack([gravel[:150, :190, 0], gravel[9:159, 7:197, 0], gravel[300:450, 50:240, 0]], axis=2)
    material = tw.synthesize(tw.Exemplar([{"albedo": color}]), tw.corner_tiles(2), tile_size=32, seed=1)
    return compare_textures(material, seed=7)


def show(page, method, beside=None):
    page.evaluate("([method, beside]) => tilewright.show(method, beside)", [method, beside])


def seen(state, shown):
    """Where the pixels that are shown lie on the plane."""
    return *origin(state, 32), shown.shape[1], shown.shape[0]


def test_each_method_shows_the_pixels_of_its_twin(open_page, pair):
    page = open_page(pair.material, seed=7, compare=pair)
    for method in ("repeat", "hex", "noise", "wang", "corner"):
        show(page, method)
        for x, y in ((0, 0), (-5, 3), (2**33, -(2**45))):
            state = view(page, cellX=str(x), cellY=str(y), pixelsPerTile=32)
            shown = read(page).astype(int)
            off = np.abs(shown - pair.contenders[method].field.render(*seen(state, shown)))
            assert off.max() <= (0 if method in ("repeat", "wang", "corner") else 1), method
            assert off.mean() < 0.01, method


def test_tone_is_compared_too(open_page, gravel):
    color = np.stack([gravel[:150, :190, 0], gravel[9:159, 7:197, 0], gravel[300:450, 50:240, 0]], axis=2)
    material = tw.texture_tiles(color, method="faithful", tone=True, tile_size=32, seed=1)
    both = side_by_side(material, seed=2)
    page = open_page(material, seed=2, compare=both)
    assert (both.contenders["corner"].fetches, len(both.contenders["wang"].field.material.tiles)) == (4, 16)
    for method in ("corner", "wang"):
        show(page, method)
        state = view(page, pixelsPerTile=32)
        shown = read(page).astype(int)
        exact = both.contenders[method].field.render(*seen(state, shown))
        assert np.abs(shown - exact).max() <= (2 if method == "corner" else 0)


def test_gray_and_16_bit_photographs_are_compared_as_8_bit(open_page, gravel):
    for photo in (gravel[:96, :96], gravel[:96, :128].astype(np.uint16) * 257):
        material = tw.synthesize(tw.Exemplar([{"a": photo}]), tw.wang_tiles(2), tile_size=32, seed=1)
        both = side_by_side(material, seed=2)
        page = open_page(material, seed=2, compare=both)
        for method, one in both.contenders.items():
            show(page, method)
            state = view(page, pixelsPerTile=32)
            shown = read(page)
            exact = one.field.render(*seen(state, shown)) / (1 if photo.dtype == np.uint8 else 257)
            assert np.abs(shown - exact).max() <= (1.01 if photo.dtype == np.uint8 else 2.5)


def test_seen_from_afar_each_method_keeps_the_mean_color(open_page, pair):
    page = open_page(pair.material, seed=7, width=120, height=120, compare=pair)
    for method, one in pair.contenders.items():
        show(page, method)
        plane = one.field.render(0, 0, 400, 400) / 255
        light = np.where(plane <= 0.04045, plane / 12.92, ((plane + 0.055) / 1.055) ** 2.4).mean(axis=(0, 1))
        wanted = 255 * (1.055 * light ** (1 / 2.4) - 0.055)
        for size in (8, 2):
            view(page, pixelsPerTile=size)
            # The table of by-example noise averages encoded colors, which are darker than light.
            assert np.abs(read(page).mean(axis=(0, 1)) - wanted).max() < (12 if method == "noise" else 5)


def test_two_methods_side_by_side(open_page, pair):
    page = open_page(pair.material, seed=7, width=800, height=60, compare=pair)
    assert view(page)["method"] == "corner"
    alone = {}
    for method in ("hex", "wang"):
        show(page, method)
        alone[method] = read(page)
    page.select_option("#method", "wang")
    page.select_option("#beside", "hex")
    wait_until(page, lambda: view(page)["beside"] == "hex")
    both = read(page)
    assert np.array_equal(both[:, :400], alone["wang"][:, :400])
    assert np.array_equal(both[:, 400:], alone["hex"][:, 400:])
    page.mouse.move(400, 30)
    page.mouse.down()
    page.mouse.move(200, 30, steps=3)
    page.mouse.up()
    assert view(page)["split"] == pytest.approx(0.25, abs=0.01)
    moved = read(page)
    assert np.array_equal(moved[:, 202:], alone["hex"][:, 202:])
    page.focus("#divider")
    page.keyboard.press("ArrowRight")
    assert view(page)["split"] == pytest.approx(0.27, abs=0.01)
    page.focus("#plane")
    page.keyboard.press("x")
    assert (view(page)["method"], view(page)["beside"]) == ("hex", "wang")
    page.keyboard.press("v")
    assert view(page)["beside"] is None
    page.keyboard.press("c")
    wait_until(page, lambda: view(page)["method"] == "noise")
    page.click("tr[data-method=repeat]")
    wait_until(page, lambda: view(page)["method"] == "repeat")


def test_the_table_shows_what_was_measured(open_page, pair):
    page = open_page(pair.material, width=400, height=100, compare=pair)
    rows = page.locator("#methods tbody tr").all_inner_texts()
    assert len(rows) == 5
    assert rows[0].split("\t")[:3] == ["Plain repeat", "1", f"{pair.figures['repeat']['repetition']:.2f}"]
    assert rows[2].split("\t")[1] == "3 + 3"
    for name, row in zip(pair.contenders, rows, strict=True):
        assert f"{pair.figures[name]['strangeness']:.2f}" in row


def test_the_page_is_small_and_whole(tmp_path):
    material = handmade(tw.corner_tiles(2), 128)
    tw.save_viewer(material, tmp_path / "a.html")
    assert (tmp_path / "a.html").stat().st_size < 1.5e6
    assert "://" not in (tmp_path / "a.html").read_text().replace("http://www.w3.org", "")


def test_bad_viewers_get_one_clear_line(tmp_path):
    material = handmade(tw.corner_tiles(1))
    for path, options, message in (
        ("a.png", {}, "a viewer is an .html file"),
        ("a.html", {"seed": -1}, "seed is -1"),
        ("a.html", {"compare": True}, "compare must be what compare_textures"),
    ):
        with pytest.raises(TilewrightError, match=message):
            tw.save_viewer(material, tmp_path / path, **options)
    assert not any(tmp_path.iterdir())


def test_a_comparison_goes_with_its_material(tmp_path, pair):
    with pytest.raises(TilewrightError, match="compare is about another material"):
        tw.save_viewer(handmade(tw.corner_tiles(1)), tmp_path / "a.html", compare=pair)
    assert not any(tmp_path.iterdir())


def test_atlas_and_array(tmp_path):
    material = handmade(tw.corner_tiles(3), 16, np.uint16)
    picture, packed = tw.make_atlas(material)
    for tile in range(81):
        x, y = packed.place(tile)
        assert np.array_equal(picture[16 * y : 16 * y + 16, 16 * x : 16 * x + 16], material.pixels[tile])
    tw.save_atlas(material, tmp_path / "a.png")
    assert np.array_equal(tw.read_image(tmp_path / "a.png"), picture)
    tw.save_array(material, tmp_path / "b.png")
    assert np.array_equal(tw.read_image(tmp_path / "b.png").reshape(81, 16, 16, 3), material.pixels)
    with pytest.raises(TilewrightError, match="packings are for complete sets"):
        tw.save_atlas(handmade(tw.cohen_tiles(8)), tmp_path / "c.png")


def test_an_atlas_of_tiles_in_classes_is_a_grid():
    tiles = tw.classed_corner_tiles(2, 5)
    material = handmade(tiles, 16, variants=tw.Variants.uniform(tiles, 2))
    picture, grid = tw.make_atlas(material)
    assert (picture.shape, grid.size) == ((9 * 16, 2 * 9 * 16, 3), (9, 9))
    for tile in range(80):
        x, y = grid.place(tile)
        for variant in range(2):
            there = picture[16 * y :, 16 * (x + 9 * variant) :][:16, :16]
            assert np.array_equal(there, material.pixels[2 * tile + variant])
