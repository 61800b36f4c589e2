"""Images, streams and tile-set folders: what goes in comes out, and nothing stands half-written."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import msgspec
import numpy as np
import pytest

import tilewright as tw
from handmade import handmade
from tilewright.errors import TilewrightError
from tilewright.files import images, tileset_folder
from tilewright.files.streams import stream_image


def pixels(kind, channels, shape=(21, 34)):
    rng = np.random.default_rng(channels)
    most = 1 if kind is np.float32 else np.iinfo(kind).max
    return (rng.random((*shape, channels)) * most).astype(kind)


FORMATS = [
    (np.uint8, ".png"),
    (np.uint8, ".tif"),
    (np.uint16, ".png"),
    (np.uint16, ".tif"),
    (np.float32, ".tif"),
    (np.float32, ".exr"),
]


@pytest.mark.parametrize("channels", [1, 2, 3, 4])
@pytest.mark.parametrize(("kind", "suffix"), FORMATS)
def test_images_come_back_exactly(tmp_path, kind, suffix, channels):
    given = pixels(kind, channels)
    path = tmp_path / f"a{suffix}"
    tw.write_image(path, given)
    read = tw.read_image(path)
    assert read.dtype == kind
    assert np.array_equal(read, given)
    streamed = tmp_path / f"b{suffix}"
    stream_image(streamed, lambda top, n: given[top : top + n], 21, 34, channels, np.dtype(kind))
    assert np.array_equal(tw.read_image(streamed), given)
    assert sorted(p.name for p in tmp_path.iterdir()) == [path.name, streamed.name]


def test_pillow_reads_what_was_written(tmp_path):
    from PIL import Image

    given = pixels(np.uint8, 4)
    tw.write_image(tmp_path / "a.png", given)
    assert np.array_equal(np.asarray(Image.open(tmp_path / "a.png")), given)
    Image.fromarray(given[..., :3]).convert("P").save(tmp_path / "p.png")
    assert tw.read_image(tmp_path / "p.png").shape == (21, 34, 3)


def test_big_tiffs_are_tiled(tmp_path):
    import tifffile

    given = pixels(np.uint8, 3, (300, 700))
    stream_image(tmp_path / "a.tif", lambda top, n: given[top : top + n], 300, 700, 3, np.dtype(np.uint8))
    with tifffile.TiffFile(tmp_path / "a.tif") as tif:
        assert tif.is_bigtiff
        assert tif.pages[0].is_tiled
        assert np.array_equal(tif.asarray(), given)


def broken_images(folder):
    from PIL import Image

    picture = Image.fromarray(pixels(np.uint8, 3, (200, 300)))
    for name in ("whole.png", "whole.jpg", "whole.tif"):
        picture.save(folder / name)
        data = (folder / name).read_bytes()
        (folder / name.replace("whole", "cut")).write_bytes(data[: len(data) // 2])
    (folder / "text.png").write_text("hello")
    (folder / "empty.jpg").write_bytes(b"")
    (folder / "folder.png").mkdir()
    return {
        "cut.png": "not a whole PNG",
        "cut.jpg": "truncated or damaged",
        "cut.tif": "cut.tif",
        "text.png": "not a whole PNG",
        "empty.jpg": "cannot be read as an image",
        "folder.png": "is a folder",
        "missing.png": "does not exist",
    }


def test_broken_images_get_one_clear_line(tmp_path):
    for name, message in broken_images(tmp_path).items():
        with pytest.raises(TilewrightError) as error:
            tw.read_image(tmp_path / name)
        assert message in str(error.value)
        assert name in str(error.value)
        assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    ("name", "kind", "message"),
    [
        ("a.gif", np.uint8, "allowed are .png"),
        ("a", np.uint8, "ends in 'nothing'"),
        ("a.png", np.float32, "use .tif or .exr"),
        ("a.exr", np.uint8, "use .png or .tif"),
        ("a.png", np.float64, "type float64"),
        ("none/a.png", np.uint8, "does not exist"),
    ],
)
def test_images_that_cannot_be_written(tmp_path, name, kind, message):
    with pytest.raises(TilewrightError, match=message):
        tw.write_image(tmp_path / name, np.zeros((4, 4, 1), kind))
    assert not any(tmp_path.iterdir())


SETS = [
    tw.corner_tiles(2),
    tw.wang_tiles(1, 2),
    tw.cohen_tiles(12),
    tw.corner_coded_tiles(scanline_only=True),
]


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("tiles", SETS, ids=repr)
def test_tile_sets_come_back_exactly(tmp_path, tiles, kind):
    material = handmade(tiles, kind=kind, channels=3, maps=2)
    tw.save(material, tmp_path / "set")
    read = tw.load(tmp_path / "set")
    assert read.tiles.shape is tiles.shape
    assert read.tiles.colors == tiles.colors
    assert np.array_equal(read.tiles.slots, tiles.slots)
    assert np.array_equal(read.origins, material.origins)
    assert read.recipe == material.recipe
    for name, given in material.maps.items():
        assert read.maps[name].dtype == kind
        assert np.array_equal(read.maps[name], given)
        assert all(
            np.array_equal(a[name], b[name]) for a, b in zip(read.sources, material.sources, strict=True)
        )
    assert all(np.array_equal(a, b) for a, b in zip(read.masks, material.masks, strict=True))
    assert [p.name for p in tmp_path.iterdir()] == ["set"]


def test_a_set_is_replaced_but_nothing_else(tmp_path):
    tw.save(handmade(tw.corner_tiles(2)), tmp_path / "set")
    tw.save(handmade(tw.corner_tiles(1)), tmp_path / "set")
    assert len(tw.load(tmp_path / "set").tiles) == 1
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "letter.txt").write_text("dear")
    with pytest.raises(TilewrightError, match="holds other things"):
        tw.save(handmade(tw.corner_tiles(1)), tmp_path / "mine")
    (tmp_path / "file").write_text("x")
    with pytest.raises(TilewrightError, match="is a file"):
        tw.save(handmade(tw.corner_tiles(1)), tmp_path / "file")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["file", "mine", "set"]


def test_map_names_cannot_leave_the_folder(tmp_path):
    material = handmade(tw.corner_tiles(1), maps=1)
    pixels_ = material.maps["map0"]
    names = ("../out", "a/b", "a b", "a_b")
    odd = tw.TextureTiles(
        material.tiles,
        dict.fromkeys(names, pixels_),
        tuple(dict.fromkeys(names, s["map0"]) for s in material.sources),
        material.origins,
    )
    tw.save(odd, tmp_path / "set")
    assert list(tw.load(tmp_path / "set").maps) == list(names)
    assert [p.name for p in tmp_path.iterdir()] == ["set"]


def edit(folder, change):
    manifest = json.loads((folder / "tileset.json").read_text())
    change(manifest)
    (folder / "tileset.json").write_text(json.dumps(manifest))


def harm():
    def drop(folder):
        next((folder / "map0").iterdir()).unlink()

    def touch(folder):
        path = sorted((folder / "origins").iterdir())[0]
        path.write_bytes(path.read_bytes() + b"x")

    def link(folder):
        path = sorted((folder / "map0").iterdir())[0]
        shutil.copy(path, folder.parent / "outside.png")
        path.unlink()
        path.symlink_to(folder.parent / "outside.png")

    def name(value):
        def change(folder):
            edit(folder, lambda m: m["maps"]["map0"].__setitem__(0, value))

        return change

    return {
        "missing tile": (drop, "is missing"),
        "changed file": (touch, "checksum is wrong"),
        "newer schema": (lambda f: edit(f, lambda m: m.update(schema=99)), "schema 99; this version"),
        "no json": (lambda f: (f / "tileset.json").write_text("{"), "is damaged"),
        "no manifest": (lambda f: (f / "tileset.json").unlink(), "cannot be read"),
        "wrong type": (
            lambda f: edit(f, lambda m: m.update(tile_size="big")),
            r"damaged: Expected `int`, got `str` - at `$.tile_size`",
        ),
        "unknown field": (lambda f: edit(f, lambda m: m.update(extra=1)), "unknown field"),
        "another size": (lambda f: edit(f, lambda m: m.update(tile_size=8)), "expected"),
        "fewer tiles": (
            lambda f: edit(f, lambda m: m["maps"]["map0"].pop()),
            "lists 15 tiles; the set has 16",
        ),
        "bad colors": (
            lambda f: edit(f, lambda m: m["tiles"].update(colors=[1, 1, 1, 1])),
            "that slot has 1 colors",
        ),
        "bad shape": (lambda f: edit(f, lambda m: m["tiles"].update(shape="hex")), "shape is 'hex'"),
        "ragged slots": (lambda f: edit(f, lambda m: m["tiles"]["slots"][3].pop()), "4 colors"),
        "no checksum": (lambda f: edit(f, lambda m: m.update(checksums={})), "has no checksum"),
        "parent path": (name("../x.png"), "leaves the folder"),
        "absolute path": (name("/etc/passwd"), "leaves the folder"),
        "link outside": (link, "leaves the folder"),
    }


@pytest.mark.parametrize("case", harm())
def test_harmed_folders_get_one_clear_line(tmp_path, case):
    damage, message = harm()[case]
    tw.save(handmade(tw.corner_tiles(2), size=16), tmp_path / "set")
    damage(tmp_path / "set")
    with pytest.raises(TilewrightError) as error:
        tw.load(tmp_path / "set")
    assert message in str(error.value)
    assert "\n" not in str(error.value)


def test_loading_nothing(tmp_path):
    with pytest.raises(TilewrightError, match="is not a folder"):
        tw.load(tmp_path / "none")


FULL = """
import resource, signal, sys
import numpy as np
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (60000, 60000))
sys.path.insert(0, {tests!r})
import tilewright as tw
from handmade import handmade
from tilewright.files.streams import stream_image
noise = np.random.default_rng(0).integers(0, 255, (256, 1000, 3)).astype(np.uint8)
def stream(name, band):
    stream_image({folder!r} + "/" + name, lambda t, n: band[:n], 1000, 1000, 3, band.dtype)
jobs = {{
    "set": lambda: tw.save(handmade(tw.corner_tiles(2), size=200), {folder!r} + "/set"),
    "png": lambda: tw.write_image({folder!r} + "/a.png", noise),
    "stream png": lambda: stream("b.png", noise),
    "stream tif": lambda: stream("b.tif", noise),
    "stream exr": lambda: stream("b.exr", np.random.default_rng(0).random((256, 1000, 3)).astype(np.float32)),
}}
for name, job in jobs.items():
    try:
        job()
        print(name, "was written")
    except tw.TilewrightError as error:
        print(name, "refused:", error)
"""


def test_a_disk_full_half_way_leaves_nothing(tmp_path):
    """Files may not grow over 60,000 bytes here, which the system reports as it does a full disk."""
    code = FULL.format(tests=str(Path(__file__).parent), folder=str(tmp_path))
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    lines = done.stdout.strip().splitlines()
    assert len(lines) == 5
    assert all("refused:" in line and "could not be written" in line for line in lines), done.stdout
    assert not any(tmp_path.iterdir())


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_an_unwritable_folder(tmp_path):
    tmp_path.chmod(0o500)
    with pytest.raises(TilewrightError, match="permission denied"):
        tw.save(handmade(tw.corner_tiles(1)), tmp_path / "set")


def test_the_manifest_can_be_read_without_tilewright(tmp_path):
    tw.save(handmade(tw.corner_tiles(2)), tmp_path / "set")
    manifest = msgspec.json.decode((tmp_path / "set" / "tileset.json").read_bytes())
    assert manifest["schema"] == tileset_folder.SCHEMA
    assert manifest["tiles"]["slot_names"] == ["NE", "SE", "SW", "NW"]
    assert images.lossless_suffix(np.dtype(np.uint8)) == ".png"
    assert (tmp_path / "set" / manifest["maps"]["map0"][0]).is_file()


def peak_memory(code):
    """Largest resident size in MB of a process that runs ``code``.

    Read from the process's own memory map: the figure of getrusage starts from its parent's.
    """
    ends = "; print(next(line for line in open('/proc/self/status') if line.startswith('VmHWM')))"
    done = subprocess.run([sys.executable, "-c", code + ends], capture_output=True, text=True, check=True)
    return float(done.stdout.split()[1]) / 1024


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="no /proc to read memory from")
def test_streaming_memory_does_not_grow(tmp_path):
    tw.save(handmade(tw.corner_tiles(2), size=128), tmp_path / "set")
    peaks = []
    for height in (1024, 8192):
        path = str(tmp_path / "a.tif")
        code = (
            f"import tilewright as tw; m = tw.load({str(tmp_path / 'set')!r}); "
            f"tw.TextureField(m, tw.direct(m.tiles)).save({path!r}, width=4096, height={height})"
        )
        peaks.append(peak_memory(code))
    assert max(peaks) < 500
    assert peaks[1] < peaks[0] + 40
