"""The three.js export in headless Chromium: Python's pixels, our mip levels, and three's own lighting."""

import base64
import functools
import itertools
import threading
from dataclasses import replace
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import numpy as np
import pytest

import tilewright as tw
from browsing import NEEDS_BROWSER, watched_page
from handmade import handmade, under_clouds
from tilewright.export.engines import save_for_engine
from tilewright.export.engines.kit import prepare
from tilewright.export.ktx2 import write_ktx2
from tilewright.signals.textures import copy_from_sources
from tilewright.signals.textures.tone import Tone

NODE_MODULES = Path(__file__).parents[2] / ".venv" / "node" / "node_modules"
RELEASES = ["three", "three-oldest"]
# The newest, and the oldest that the export promises; what does not hang on the release is seen in one.

pytestmark = [
    *NEEDS_BROWSER,
    pytest.mark.skipif(
        not (NODE_MODULES / "three").exists(), reason="three.js was not found; sh .ci/install-node-tools"
    ),
]

# A page that draws what a test asks for and hands back the pixels, rows from the top.
TEST_PAGE = """<!DOCTYPE html>
<link rel="icon" href="data:,">
<script type="importmap">
{ "imports": {
  "three": "./node_modules/three/build/three.module.js",
  "three/addons/": "./node_modules/three/examples/jsm/"
} }
</script>
<script type="module">
import * as THREE from "three";
import { loadTilewright, SET } from "./tilewright.js";

const renderer = new THREE.WebGLRenderer({ antialias: false });
document.body.append(renderer.domElement);
const tiles = await loadTilewright(undefined, renderer);

function read(scene, camera, width, height, linear) {
  renderer.outputColorSpace = linear ? THREE.LinearSRGBColorSpace : THREE.SRGBColorSpace;
  let upward;
  if (linear === "float") {
    const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.FloatType });
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    upward = new Float32Array(4 * width * height);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, upward);
    renderer.setRenderTarget(null);
    target.dispose();
  } else {
    renderer.setSize(width, height);
    renderer.render(scene, camera);
    upward = new Uint8Array(4 * width * height);
    const gl = renderer.getContext();
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, upward);
    if (gl.getError()) throw new Error("WebGL complains");
  }
  const bytes = new Uint8Array(upward.buffer), row = bytes.length / height;
  let text = "";
  for (let y = height - 1; y >= 0; y--) {
    for (let i = y * row; i < (y + 1) * row; i += 4096) {
      text += String.fromCharCode(...bytes.subarray(i, Math.min(i + 4096, (y + 1) * row)));
    }
  }
  return btoa(text);
}

// A map seen from straight above: cell and texel at the upper left, texels per pixel.
window.flat = ({ map, cell, texel, size, step, width, height, linear }) => {
  const material = tiles.apply(new THREE.MeshBasicMaterial(), { color: map });
  const look = material.userData.tilewright;
  look.origin.set(...cell);
  look.offset.set(texel[0] / size, texel[1] / size);
  look.repeat.set(width * step / size, height * step / size);
  const scene = new THREE.Scene();
  scene.add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 2);
  camera.position.z = 1;
  return read(scene, camera, width, height, linear);
};

// A lit ball, its material by tiles, or with constant textures in three's own slots.
window.ball = ({ type, constants, width, height, side }) => {
  let material = new THREE[type]({ side: THREE[side] });
  if (constants) {
    const texture = (color, colorSpace = THREE.NoColorSpace) => {
      const made = new THREE.DataTexture(new Uint8Array(color), 1, 1);
      return Object.assign(made, { colorSpace, needsUpdate: true });
    };
    const { color, normal, roughness, metallic, occlusion, emission } = constants;
    if (color) material.map = texture(color, THREE.SRGBColorSpace);
    if (normal) material.normalMap = texture(normal);
    if (roughness) { material.roughnessMap = texture(roughness); material.roughness = 1; }
    if (metallic) { material.metalnessMap = texture(metallic); material.metalness = 1; }
    if (occlusion) material.aoMap = texture(occlusion);
    if (emission) {
      material.emissiveMap = texture(emission, THREE.SRGBColorSpace);
      material.emissive = new THREE.Color(1, 1, 1);
    }
  } else {
    if (SET.slots.metallic) material.metalness = 1;
    material = tiles.apply(material);
    material.userData.tilewright.repeat.set(8, 8);
  }
  const scene = new THREE.Scene();
  const sun = new THREE.DirectionalLight("white", 2);
  sun.position.set(2, 3, 1);
  const ball = new THREE.Mesh(new THREE.SphereGeometry(1, 32, 24), material);
  scene.add(sun, new THREE.AmbientLight("white", 0.5), ball);
  const camera = new THREE.PerspectiveCamera(50, width / height, 0.1, 10);
  camera.position.set(...(side === "FrontSide" ? [0.5, 0.4, 2.5] : [0, 0.1, 0.3]));  // else from inside
  camera.lookAt(0, 0, 0);
  return read(scene, camera, width, height, false);
};
// A flat square, lit by one lamp from a direction, white paper of four fifths.
window.slope = ({ light, width, height, linear }) => {
  const material = tiles.apply(new THREE.MeshLambertMaterial());
  material.color.setRGB(0.8, 0.8, 0.8);
  const scene = new THREE.Scene();
  const lamp = new THREE.DirectionalLight("white", Math.PI);
  lamp.position.set(...light);
  scene.add(lamp, new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));
  const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 2);
  camera.position.z = 1;
  return read(scene, camera, width, height, linear);
};
// What three's own loader makes of a file.
window.loadByThree = async (file) => {
  const { KTX2Loader } = await import("three/addons/loaders/KTX2Loader.js");
  const texture = await new KTX2Loader().detectSupport(renderer).loadAsync(file);
  const { format, type, colorSpace, mipmaps } = texture;
  const rgba = format === THREE.RGBAFormat;
  const levels = mipmaps.map(({ width, height, data }) => ({ width, height, data: Array.from(data) }));
  return { rgba, half: type === THREE.HalfFloatType, colorSpace, levels };
};
document.title = "ready";
</script>
"""


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


@pytest.fixture
def open_folder(browser, tmp_path):
    """Serve an exported folder with a release of three.js in it, and open a page of it.

    Fails on console errors and warnings, on files that are not there, and on requests to any other server.
    """
    opened, complaints = [], []

    def open_(folder, release="three", page_name="test.html", width=160, height=120):
        modules = folder / "node_modules"
        modules.mkdir()
        (modules / "three").symlink_to(NODE_MODULES / release)
        (folder / "test.html").write_text(TEST_PAGE, encoding="utf-8")
        server = ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(_Quiet, directory=str(folder)))
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_port}/"
        page = watched_page(browser, complaints, (address, "data:", "blob:"), width, height)
        opened.append((server, page))
        page.goto(address + page_name)
        if page_name == "test.html":
            page.wait_for_function("document.title === 'ready'")
        return page

    open_.complaints = complaints
    yield open_
    for server, page in opened:
        page.context.close()
        server.shutdown()
        server.server_close()
    # SwiftShader warns that reading pixels back stalls; nothing else may be said.
    assert [c for c in complaints if "ReadPixels" not in c] == []


def export(material, folder, seed=7):
    save_for_engine(material, folder, "threejs", seed=seed)
    return folder


def draw(page, what, width=160, height=120, kind=np.uint8, **wanted):
    told = page.evaluate(f"wanted => window.{what}(wanted)", {"width": width, "height": height, **wanted})
    return np.frombuffer(base64.b64decode(told), kind).reshape(height, width, 4)


CELLS = [(-3, 5), (-1, -1), (2**31 - 40, -(2**31) + 3), (123456789, -987654321)]


@pytest.mark.parametrize(
    ("colors", "variants", "release"),
    [(c, v, "three") for c, v in ((1, 1), (4, 1), (5, 1), (2, 3), (4, 3))] + [(2, 3, "three-oldest")],
)
def test_at_one_texel_per_pixel_the_canvas_shows_what_python_renders(
    open_folder, tmp_path, colors, variants, release
):
    """Texture arrays up to 256 pictures, packed atlases above."""
    seed, tiles = 2**64 - 5, tw.corner_tiles(colors)
    material = handmade(tiles, 16, variants=tw.Variants.uniform(tiles, variants))
    page = open_folder(export(material, tmp_path / "a", seed), release)
    field = tw.TextureField(material, tw.direct(material.tiles, seed))
    for x, y in CELLS:
        shown = draw(page, "flat", map="map0", cell=[x, y], texel=[3, 11], size=16, step=1)
        assert np.array_equal(shown[..., :3], field.render(16 * x + 3, 16 * y + 11, 160, 120))


@pytest.mark.parametrize("release", RELEASES[1:])
def test_the_canvas_lays_the_tone(open_folder, tmp_path, release):
    material = under_clouds(handmade(tw.classed_corner_tiles(2, 5), 32), 2)
    page = open_folder(export(material, tmp_path / "a"), release)
    field = tw.TextureField(material, tw.direct(material.tiles, 7))
    for x, y in CELLS:
        shown = draw(page, "flat", map="map0", cell=[x, y], texel=[3, 11], size=32, step=1).astype(int)
        off = np.abs(shown[..., :3] - field.render(32 * x + 3, 32 * y + 11, 160, 120))
        assert off.max() <= 2
        assert off.mean() < 0.4


@pytest.mark.parametrize("release", RELEASES[:1])
@pytest.mark.parametrize("channels", [1, 2, 3, 4])
def test_maps_of_numbers_keep_their_bytes(open_folder, tmp_path, channels, release):
    material = handmade(tw.corner_tiles(2), 16, channels=channels)
    material = replace(material, kinds={"map0": "data"})
    page = open_folder(export(material, tmp_path / "a"), release)
    shown = draw(page, "flat", map="map0", cell=[0, 0], texel=[0, 0], size=16, step=1, linear=True)
    wanted = tw.TextureField(material, tw.direct(material.tiles, 7)).render(0, 0, 160, 120)
    few = min(channels, 3)
    assert np.array_equal(shown[..., :few], wanted[..., :few])


@pytest.mark.parametrize("release", RELEASES[:1])
@pytest.mark.parametrize("kind", [np.uint16, np.float32])
def test_deep_maps_arrive_as_half_floats(open_folder, tmp_path, kind, release):
    material = replace(handmade(tw.corner_tiles(2), 16, kind), kinds={"map0": "data"})
    page = open_folder(export(material, tmp_path / "a"), release)
    shown = draw(
        page, "flat", map="map0", cell=[0, 0], texel=[0, 0], size=16, step=1, linear="float", kind=np.float32
    )
    wanted = tw.TextureField(material, tw.direct(material.tiles, 7)).render(0, 0, 160, 120)
    half = (wanted / np.float32(1 if kind is np.float32 else 65535)).astype(np.float16)
    # Half floats below 1 are 5e-4 apart; the rest is the texture unit's own rounding.
    assert np.abs(shown[..., :3] - half).max() < 1e-5


@pytest.mark.parametrize("release", RELEASES[:1])
@pytest.mark.parametrize("colors", [2, 5])
def test_the_levels_on_the_gpu_are_those_in_the_file(open_folder, tmp_path, colors, release):
    """Each level is given a color of its own; seen from afar, that color shows."""
    material = replace(handmade(tw.corner_tiles(colors), 16, channels=1), kinds={"map0": "data"})
    folder = export(material, tmp_path / "a")
    kit = prepare(material, 7)
    levels = [np.full_like(level, 9 * k + 5) for k, level in enumerate(kit.levels("map0")[0])]
    levels = levels if colors == 2 else [level[0] for level in levels]
    write_ktx2(folder / "map0.ktx2", levels, srgb=False)
    page = open_folder(folder, release)
    for k in range(len(levels)):
        shown = draw(page, "flat", map="map0", cell=[0, 0], texel=[0, 0], size=16, step=2**k, linear=True)
        assert set(np.unique(shown[..., 0])) == {9 * k + 5}, k


@pytest.mark.parametrize("release", RELEASES[:1])
@pytest.mark.parametrize("kind", [np.uint8, np.float32])
def test_threes_own_loader_reads_atlases(open_folder, tmp_path, kind, release):
    """Arrays it reads as their first layer, so that the export has a loader of its own."""
    material = handmade(tw.corner_tiles(5), 4, kind)
    page = open_folder(export(material, tmp_path / "a"), release)
    read = page.evaluate("loadByThree('map0.ktx2')")
    levels, _ = prepare(material, 7).levels("map0")
    assert (read["rgba"], read["half"]) == (True, kind is np.float32)
    assert read["colorSpace"] == ("srgb" if kind is np.uint8 else "")
    assert len(read["levels"]) == len(levels)
    for told, level in zip(read["levels"], levels, strict=True):
        assert (told["height"], told["width"]) == level.shape[1:3]
        assert np.array_equal(told["data"], level.view(f"u{level.itemsize}").ravel())


def constant(values, kinds):
    """Tiles that are one color all over, one for each map."""
    material = handmade(tw.corner_tiles(2), 16)
    shape = material.pixels.shape[:3]
    maps = {name: np.broadcast_to(np.uint8(v), (*shape, len(v))).copy() for name, v in values.items()}
    return replace(material, maps=maps, kinds=kinds)


@pytest.mark.parametrize(
    ("green", "side", "release"),
    [
        *itertools.product(("normal-gl", "normal-dx"), ("FrontSide", "DoubleSide", "BackSide"), RELEASES[:1]),
        ("normal-dx", "DoubleSide", RELEASES[1]),
    ],
)
def test_lit_as_by_threes_own_slots(open_folder, tmp_path, green, side, release):
    """Constant maps, so that three's own texture slots must show the same."""
    values = {
        "color": [200, 120, 40],
        "normal": [160, 200, 227],  # of length 1, so that mip levels are equal
        "roughness": [90],
        "metal": [70],
        "ao": [128],
        "emissive": [10, 0, 60],
    }
    kinds = {"color": "color", "normal": green, "emissive": "color", "roughness": "roughness"}
    page = open_folder(export(constant(values, kinds), tmp_path / "a"), release)
    if green == "normal-dx":
        values["normal"][1] = 255 - values["normal"][1]
    slots = {"metal": "metallic", "ao": "occlusion", "emissive": "emission"}
    constants = {slots.get(name, name): [*(v * 3 if len(v) == 1 else v), 255] for name, v in values.items()}
    for kind in ("MeshStandardMaterial", "MeshPhysicalMaterial", "MeshPhongMaterial", "MeshLambertMaterial"):
        if kind in ("MeshPhongMaterial", "MeshLambertMaterial"):
            constants = {name: v for name, v in constants.items() if name not in ("roughness", "metallic")}
        ours = draw(page, "ball", type=kind, side=side).astype(int)
        theirs = draw(page, "ball", type=kind, side=side, constants=constants).astype(int)
        assert np.ptp(theirs[..., 0]) > 50
        # A pixel or two at the rim, where the light grazes, may differ.
        assert (np.abs(ours - theirs) > 2).mean() < 5e-4, kind


@pytest.mark.parametrize("release", RELEASES)
def test_roughness_takes_its_tone(open_folder, tmp_path, release):
    """A tone of 0 changes nothing, and one that smooths the surface makes highlights."""
    dull = constant({"roughness": [250]}, {"roughness": "roughness"})
    balls = []
    for n, tone in enumerate((None, 0, -200)):
        texels = {"roughness": np.full((4, 4, 1), tone or 0, np.float32)}
        material = dull if tone is None else replace(dull, tone=Tone(16, 1, texels))
        page = open_folder(export(material, tmp_path / f"a{n}"), release)
        balls.append(draw(page, "ball", type="MeshStandardMaterial", side="FrontSide").astype(int))
    assert np.abs(balls[0] - balls[1]).max() <= 1
    assert np.abs(balls[2] - balls[0]).max() > 20


@pytest.mark.parametrize("release", RELEASES[:1])
def test_heights_tilt_the_surface_where_there_is_no_normal_map(open_folder, tmp_path, release):
    """A slope of s along a tile, lit from one side: Lambert's cosine says how bright it must be."""
    material = handmade(tw.corner_tiles(1), 64)
    east = np.arange(64, dtype=np.uint8)[:, None] * 4
    for axis, toward in enumerate(([1, 0], [0, -1])):  # rises to the east; to the south
        tile = np.broadcast_to(east if axis else east.T, (1, 64, 64))[..., None].copy()
        sloped = replace(material, maps={"height": tile}, kinds={})
        page = open_folder(export(sloped, tmp_path / f"a{axis}"), release)
        rise = 0.05 * 4 * 64 / 255
        for sign in (-1, 1):
            light = np.array([sign * toward[0], sign * toward[1], 1]) / np.sqrt(2)
            shown = draw(page, "slope", light=light.tolist(), width=64, height=64, linear=True)
            normal = np.array([-rise * toward[0], -rise * toward[1], 1]) / np.hypot(rise, 1)
            assert np.abs(shown[16:48, 16:48, 0] - 255 * 0.8 * (normal @ light)).max() <= 2


@pytest.fixture(scope="module")
def stones(gravel, gravel_tiles):
    """Gravel with three maps."""
    maps = {"color": np.repeat(gravel, 3, axis=2), "height": gravel, "roughness": 255 - gravel // 2}
    maps = copy_from_sources((maps,), gravel_tiles.origins)
    return replace(gravel_tiles, maps=maps, kinds={})


@pytest.mark.parametrize("release", RELEASES[:1])
def test_the_scene_is_up_within_five_seconds(open_folder, tmp_path, stones, release):
    page = open_folder(export(stones, tmp_path / "a"), release, "index.html", width=640, height=400)
    page.wait_for_function("performance.getEntriesByName('first frame').length")
    assert page.evaluate("performance.getEntriesByName('first frame')[0].startTime") < 5000
    shown = page.screenshot()
    assert len(shown) > 100_000  # an empty page would be small
    (tmp_path / "scene.png").write_bytes(shown)
    page.mouse.move(400, 250)
    page.mouse.down()
    page.mouse.move(300, 250, steps=2)
    page.mouse.up()
    assert page.screenshot() != shown


def test_a_damaged_file_is_named(open_folder, tmp_path):
    folder = export(handmade(tw.corner_tiles(2), 16), tmp_path / "a")
    (folder / "map0.ktx2").write_bytes(bytes(200))
    page = open_folder(folder, page_name="index.html")
    page.wait_for_function("document.getElementById('failure').textContent")
    told = "map0.ktx2 is not a KTX 2.0 file as tilewright writes them"
    assert page.inner_text("#failure") == told
    assert open_folder.complaints.pop() == told
