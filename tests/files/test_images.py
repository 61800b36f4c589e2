"""Images and streams: what goes in comes out, and nothing stands half-written."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import tilewright as tw
from handmade import handmade
from tilewright.errors import TilewrightError
from tilewright.files.image_streams import stream_image


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
    exact = suffix != ".exr" or channels in (1, 3)  # light is multiplied by alpha there
    tw.write_image(path, given, color=exact)
    read = tw.read_image(path, color=exact)
    assert read.dtype == kind
    assert np.array_equal(read, given)
    streamed = tmp_path / f"b{suffix}"
    stream_image(
        streamed,
        lambda left, top, w, h: given[top : top + h, left : left + w],
        21,
        34,
        channels,
        np.dtype(kind),
        exact,
    )
    assert np.array_equal(tw.read_image(streamed, color=exact), given)
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
    stream_image(
        tmp_path / "a.tif",
        lambda left, top, w, h: given[top : top + h, left : left + w],
        300,
        700,
        3,
        np.dtype(np.uint8),
    )
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
        "text.png": "cannot be read as an image",
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
        ("a", np.uint8, "has no suffix"),
        ("a.png", np.float32, "use .tif or .exr"),
        ("a.exr", np.uint8, "use .png or .tif"),
        ("a.png", np.float64, "type float64"),
        ("file/a.png", np.uint8, "file is not a folder"),
    ],
)
def test_images_that_cannot_be_written(tmp_path, name, kind, message):
    (tmp_path / "file").write_text("")
    with pytest.raises(TilewrightError, match=message):
        tw.write_image(tmp_path / name, np.zeros((4, 4, 1), kind))
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


FULL = """
import resource, signal, sys
import numpy as np
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (60000, 60000))
sys.path.insert(0, {tests!r})
import tilewright as tw
from handmade import handmade
from handmade import handmade
from tilewright.files.image_streams import stream_image
noise = np.random.default_rng(0).integers(0, 255, (256, 1000, 3)).astype(np.uint8)
def stream(name, band):
    stream_image({folder!r} + "/" + name, lambda x, y, w, h: band[:h], 1000, 1000, 3, band.dtype)
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
    code = FULL.format(tests=str(Path(__file__).parents[1] / "helpers"), folder=str(tmp_path))
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    lines = done.stdout.strip().splitlines()
    assert len(lines) == 5
    assert all("refused:" in line and "could not be written" in line for line in lines), done.stdout
    assert not any(tmp_path.iterdir())


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


@pytest.mark.parametrize("suffix", [".png", ".tif", ".exr"])
def test_pictures_wider_than_a_block_are_streamed_whole(tmp_path, suffix):
    kind = np.float32 if suffix == ".exr" else np.uint8
    wide = pixels(kind, 3, (96, 70_000))
    asked = []

    def block(left, top, width, height):
        asked.append(width * height * 3 * wide.itemsize)
        return wide[top : top + height, left : left + width]

    path = tmp_path / f"a{suffix}"
    stream_image(path, block, 96, 70_000, 3, wide.dtype)
    assert np.array_equal(tw.read_image(path), wide)
    assert max(asked) <= 16 << 20


@pytest.mark.parametrize("orientation", range(1, 9))
@pytest.mark.parametrize("suffix", [".tif", ".png"])
def test_photographs_come_upright(tmp_path, orientation, suffix):
    from PIL import Image, ImageOps

    exif = Image.Exif()
    exif[0x112] = orientation
    path = tmp_path / f"a{suffix}"
    Image.fromarray(pixels(np.uint8, 3)).save(path, exif=exif)
    with Image.open(path) as image:
        assert np.array_equal(tw.read_image(path), np.asarray(ImageOps.exif_transpose(image)))


def test_images_of_other_kinds_are_refused(tmp_path):
    import tifffile

    six = np.zeros((40, 40, 6), np.uint8)
    tifffile.imwrite(tmp_path / "six.tif", six, photometric="minisblack", planarconfig="contig")
    tifffile.imwrite(tmp_path / "int.tif", np.zeros((40, 40), np.int32))
    tw.write_image(tmp_path / "bent.png", pixels(np.uint8, 3, (200, 300)))
    data = bytearray((tmp_path / "bent.png").read_bytes())
    data[len(data) // 2] ^= 0xFF
    (tmp_path / "bent.png").write_bytes(data)
    for name, message in {
        "six.tif": "6 channels; allowed are 1 to 4",
        "int.tif": "allowed are 8-bit, 16-bit, half and float",
        "bent.png": "checksum of its chunk 'IDAT' is wrong",
    }.items():
        with pytest.raises(TilewrightError) as error:
            tw.read_image(tmp_path / name)
        assert message in str(error.value)


def test_output_names_that_are_no_files(tmp_path):
    (tmp_path / "real").mkdir()
    (tmp_path / "link.png").symlink_to(tmp_path / "real" / "a.png")
    tw.write_image(tmp_path / "link.png", pixels(np.uint8, 3))
    assert (tmp_path / "link.png").is_symlink()
    assert (tmp_path / "real" / "a.png").is_file()
    for path, message in ((tmp_path / "real", "has no suffix"), (tmp_path / "a\0.png", "embedded null")):
        with pytest.raises(TilewrightError, match=message):
            tw.write_image(path, pixels(np.uint8, 3))
