"""What files state of their numbers - profiles, gamma, alpha, further pictures - is heeded or noted."""

import io
import struct
import warnings

import numpy as np
import pytest
from PIL import Image, ImageCms, features

import odd_images
import tilewright as tw
from odd_images import HEIGHT, WIDTH, by_pillow, counted, png, smooth, wide
from tilewright.errors import TilewrightError, TilewrightWarning
from tilewright.files.images import open_picture

D50 = {
    "srgb": ((0.4361, 0.2225, 0.0139), (0.3851, 0.7169, 0.0971), (0.1431, 0.0606, 0.7141)),
    "adobe": ((0.6097, 0.3111, 0.0195), (0.2053, 0.6257, 0.0609), (0.1492, 0.0632, 0.7446)),
    "p3": ((0.5151, 0.2412, -0.0011), (0.2920, 0.6922, 0.0419), (0.1571, 0.0666, 0.7841)),
}
"""Columns of the matrices of profiles, XYZ under D50."""


def profile(primaries="p3", curve=b"curv\0\0\0\0\0\0\0\1\2\x33", tables=False, gray=False):
    """An ICC profile of version 2 with a matrix and one curve, by default gamma 2.2; or of gray."""
    name = b"Made here"
    tags = {
        b"desc": b"desc\0\0\0\0" + struct.pack(">I", len(name) + 1) + name + bytes(1 + 4 + 4 + 2 + 1 + 67),
        b"wtpt": b"XYZ \0\0\0\0" + struct.pack(">3i", 63190, 65536, 54061),
    }
    if gray:
        tags[b"kTRC"] = curve
    else:
        for channel, column in zip(b"rgb", D50[primaries], strict=True):
            body = struct.pack(">3i", *(round(v * 65536) for v in column))
            tags[bytes([channel]) + b"XYZ"] = b"XYZ \0\0\0\0" + body
            tags[bytes([channel]) + b"TRC"] = curve
    if tables:
        tags[b"A2B0"] = _table()
    body, listing = b"", struct.pack(">I", len(tags))
    for tag, data in tags.items():
        listing += struct.pack(">4s2I", tag, 128 + 4 + 12 * len(tags) + len(body), len(data))
        body += data + bytes(-len(data) % 4)
    size = 128 + len(listing) + len(body)
    spaces = (b"GRAY" if gray else b"RGB ", b"Lab " if tables else b"XYZ ")
    head = struct.pack(">I4sI4s4s4s12s4s", size, b"none", 2 << 24, b"mntr", *spaces, bytes(12), b"acsp")
    return head.ljust(68, b"\0") + struct.pack(">3i", 63190, 65536, 54061).ljust(60, b"\0") + listing + body


def _table():
    """A table of two steps along each axis, from RGB to L*a*b* of 8 bits (ICC.1:2022, section 10.11)."""
    unit = struct.pack(">9i", *(65536, 0, 0, 0, 65536, 0, 0, 0, 65536))
    same = bytes(range(256)) * 3
    colors = bytes(v for corner in range(8) for v in (corner.bit_count() * 85, 128, 128))
    return b"mft1\0\0\0\0\3\3\2\0" + unit + same + colors + same


PARAMETRIC = b"para\0\0\0\0\0\3\0\0" + struct.pack(
    ">5i", *(round(v * 65536) for v in (2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045))
)
LINEAR = b"curv\0\0\0\0\0\0\0\0"
TABLE = (
    b"curv\0\0\0\0"
    + struct.pack(">I", 1024)
    + (np.linspace(0, 1, 1024) ** 1.8 * 65535).astype(">u2").tobytes()
)


def read(path, note="", **options):
    """The pixels of a file that brings this one note, or none."""
    with warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        pixels = tw.read_image(path, **options)
    said = [str(n.message) for n in notes]
    assert len(said) == bool(note), said
    assert all(note in line and "\n" not in line and path.name in line for line in said), said
    return pixels


def keep(folder, name, data):
    """A file with this content."""
    (folder / name).write_bytes(data)
    return folder / name


def icc_chunk(data):
    import zlib

    return b"iCCP", b"a\0\0" + zlib.compress(data)


def by_littlecms(pixels, data):
    """8-bit color by littleCMS, relative colorimetric."""
    transform = ImageCms.buildTransform(
        ImageCms.ImageCmsProfile(io.BytesIO(data)),
        ImageCms.createProfile("sRGB"),
        "RGB",
        "RGB",
        renderingIntent=ImageCms.Intent.RELATIVE_COLORIMETRIC,
    )
    return np.asarray(transform.apply(Image.fromarray(pixels)))


PROFILES = {
    "gamma": profile(),
    "parameters": profile(curve=PARAMETRIC),
    "table": profile(curve=TABLE),
    "linear": profile("srgb", LINEAR),
}


@pytest.mark.parametrize("name", PROFILES)
def test_profiles_are_applied_alike_to_all_types(tmp_path, name):
    data, small = PROFILES[name], counted(3, 255)
    wanted = by_littlecms(small, data).astype(int)
    assert np.abs(wanted - small).max() > 20
    note = "converted from 'Made here'"
    pixels = read(keep(tmp_path, "a.png", png(8, 2, small, icc_chunk(data))), note)
    assert np.array_equal(pixels, wanted)
    large = read(keep(tmp_path, "b.png", png(16, 2, small.astype(np.uint16) * 257, icc_chunk(data))), note)
    assert large.dtype == np.uint16
    assert np.abs(large / 257 - wanted).max() <= 1.5
    alpha = read(keep(tmp_path, "c.png", png(16, 6, wide(4), icc_chunk(data))), note)
    assert np.array_equal(alpha[..., 3], wide(4)[..., 3])
    assert np.array_equal(read(tmp_path / "c.png", color=False), wide(4))


def test_sixteen_bits_are_all_kept(tmp_path):
    ramp = np.repeat(np.arange(65536, dtype=np.uint16).reshape(256, 256, 1), 3, axis=2)
    path = keep(tmp_path, "a.png", png(16, 2, ramp, icc_chunk(profile(curve=PARAMETRIC))))
    # Gray stays gray of the same lightness where the curves are alike, so every step is to be there.
    assert np.abs(read(path, "converted").astype(int) - ramp).max() <= 24
    assert len(np.unique(read(path, "converted")[..., 1])) > 65000


@pytest.mark.parametrize(
    "data", [profile("srgb", PARAMETRIC), ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()]
)
def test_profiles_that_mean_srgb_change_nothing(tmp_path, data):
    for depth, pixels in ((8, counted(3, 255)), (16, wide(3))):
        assert np.array_equal(read(keep(tmp_path, "a.png", png(depth, 2, pixels, icc_chunk(data)))), pixels)
    gray = counted(1, 255)
    assert np.array_equal(read(keep(tmp_path, "b.png", png(8, 0, gray, icc_chunk(data)))), gray)


def test_gray_with_a_profile_stays_gray(tmp_path):
    gray = counted(1, 255)
    linear = np.rint(255 * (1.055 * np.maximum(gray / 255, 0.0031308) ** (1 / 2.4) - 0.055))
    for data in (profile(curve=LINEAR, gray=True), profile("srgb", LINEAR)):
        small = read(keep(tmp_path, "a.png", png(8, 0, gray, icc_chunk(data))), "converted")
        large = read(keep(tmp_path, "b.png", png(16, 0, gray * np.uint16(257), icc_chunk(data))), "converted")
        assert np.abs(small - linear)[gray > 1].max() <= 1
        assert np.abs(large / 257 - linear)[gray > 1].max() <= 1


def test_floats_become_linear_light(tmp_path):
    import tifffile

    light = (counted(3, 255) / 128).astype(np.float32)  # up to twice white
    for data, note, wanted in (
        (profile("srgb", LINEAR), "", light),
        (profile("srgb"), "to linear light of sRGB", light ** (0x233 / 256)),
        (profile("srgb", TABLE), "to linear", np.where(light < 1, light**1.8, 1 + 1.8 * (light - 1))),
        (profile("p3", LINEAR), "to linear light of sRGB", None),
    ):
        tifffile.imwrite(tmp_path / "a.tif", light, photometric="rgb", iccprofile=data, metadata=None)
        shown = read(tmp_path / "a.tif", note)
        assert shown.dtype == np.float32
        if wanted is not None:
            assert (np.abs(shown - wanted) < 0.005 * np.maximum(wanted, 1)).all()
        else:
            matrix = np.linalg.solve(np.array(D50["srgb"]).T, np.array(D50["p3"]).T)
            assert np.abs(shown - light @ matrix.T).max() < 0.004


def test_profiles_that_cannot_be_applied_are_named(tmp_path):
    pixels = wide(3)
    for data, note in (
        (
            profile(tables=True),
            "'Made here' holds tables, which are applied to 8 bit alone; its numbers are taken",
        ),
        (profile(gray=True), "'Made here' is for GRAY, not for its channels"),
        (b"nothing of a profile" * 20, "its color profile is damaged"),
    ):
        shown = read(keep(tmp_path, "a.png", png(16, 2, pixels, icc_chunk(data))), note)
        assert np.array_equal(shown, pixels)
    small = counted(3, 255)
    shown = read(keep(tmp_path, "b.png", png(8, 2, small, icc_chunk(profile(tables=True)))), "converted")
    assert np.array_equal(shown, by_littlecms(small, profile(tables=True)))
    assert np.ptp(shown, axis=-1).max() <= 2  # the table turns all colors gray


def test_a_pillow_image_brings_its_profile(tmp_path):
    data = profile()
    path = keep(tmp_path, "a.jpg", by_pillow(smooth(), format="JPEG", quality=95, icc_profile=data))
    wanted = read(path, "converted")
    with Image.open(path) as image, pytest.warns(TilewrightWarning, match="photo: its colors were converted"):
        assert np.array_equal(open_picture("photo", image), wanted)
    with Image.open(path) as image:
        assert not np.array_equal(open_picture("photo", image, color=False), wanted)


def test_one_photograph_is_shown_as_every_other_method_shows_it(tmp_path):
    path = keep(tmp_path, "a.png", png(8, 2, counted(3, 255), icc_chunk(profile())))
    wanted = read(path, "converted")
    with Image.open(path) as image, pytest.warns(TilewrightWarning, match="converted"):
        assert np.array_equal(tw.RepeatField(image).photo, wanted)
    with Image.open(path) as image:
        assert np.array_equal(tw.RepeatField(image, kind="data").photo, counted(3, 255))


def chromaticities(*xy):
    white, *primaries = np.array(xy).reshape(4, 2)[[3, 0, 1, 2]]
    return b"cHRM", struct.pack(">8I", *(round(v * 100_000) for v in (*white, *np.ravel(primaries))))


SRGB_XY = (0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329)
P3_XY = (0.68, 0.32, 0.265, 0.69, 0.15, 0.06, 0.3127, 0.329)


def test_png_chunks_of_color_are_heeded_in_their_order(tmp_path):
    pixels = counted(3, 255)
    p3 = by_littlecms(pixels, profile(curve=PARAMETRIC)).astype(int)

    def shown(note, *chunks):
        return read(keep(tmp_path, "a.png", png(8, 2, pixels, *chunks)), note)

    gamma = (b"gAMA", struct.pack(">I", 45455))
    assert np.array_equal(shown("", gamma, chromaticities(*SRGB_XY)), pixels)
    assert np.abs(shown("gAMA and cHRM", gamma, chromaticities(*P3_XY)) - p3).max() <= 2
    assert np.array_equal(shown("", (b"sRGB", b"\0"), gamma, chromaticities(*P3_XY)), pixels)
    assert np.abs(shown("Display P3", (b"cICP", bytes([12, 13, 0, 1]))) - p3).max() <= 2
    assert np.array_equal(shown("", (b"cICP", bytes([1, 13, 0, 1]))), pixels)
    assert np.array_equal(shown("primaries 9, transfer 16", (b"cICP", bytes([9, 16, 0, 1]))), pixels)
    linear = shown("gAMA", (b"gAMA", struct.pack(">I", 100_000)))
    assert np.abs(linear - by_littlecms(pixels, profile("srgb", LINEAR)).astype(int)).max() <= 1
    assert np.array_equal(shown("", (b"gAMA", bytes(4))), pixels)


def test_cameras_state_adobe_rgb_by_exif(tmp_path):
    part = struct.pack(">HHHI4sI", 1, 1, 2, 4, b"R03\0", 0)
    space = struct.pack(">HHHIHHHHIII", 2, 0xA001, 3, 1, 65535, 0, 0xA005, 4, 1, 56, 0)
    exif = b"Exif\0\0MM\0*" + struct.pack(">IHHHIII", 8, 1, 0x8769, 4, 1, 26, 0) + space + part
    shown = read(
        keep(tmp_path, "a.jpg", by_pillow(smooth(), format="JPEG", quality=95, exif=exif)), "Adobe RGB"
    )
    plain = read(keep(tmp_path, "b.jpg", by_pillow(smooth(), format="JPEG", quality=95)))
    assert np.abs(shown - by_littlecms(plain, profile("adobe")).astype(int)).max() <= 2
    other = exif.replace(b"R03", b"R98")
    read(keep(tmp_path, "c.jpg", by_pillow(smooth(), format="JPEG", quality=95, exif=other)), "not sRGB")
    read(tmp_path / "c.jpg", color=False)


def exr(path, names, pixels, **attributes):
    import OpenImageIO as oiio

    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], "float")
    spec.channelnames = names
    for name, value in attributes.items():
        spec.attribute(name, "float[8]", value)
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), spec)
    output.write_image(pixels)
    output.close()
    return path


def test_channels_are_what_they_are_called(tmp_path):
    light = (counted(6, 255) / 255).astype(np.float32)
    path = tmp_path / "a.exr"
    one = np.ones((HEIGHT, WIDTH, 1), np.float32)
    mixed = exr(path, ("R", "G", "B", "Z", "normal.X"), light[..., :5])
    assert np.array_equal(read(mixed, "in channels Z, normal.X"), light[..., :3])
    layered = exr(
        path, ("R", "G", "B", "A", "Z"), np.concatenate([light[..., :3], one, light[..., :1]], axis=-1)
    )
    assert np.array_equal(read(layered, "in channel Z"), np.concatenate([light[..., :3], one], axis=-1))
    assert np.array_equal(read(exr(path, ("Z",), light[..., :1])), light[..., :1])
    for names in (("R", "G"), ("X", "Y.1", "Z"), ("u", "v", "w", "t")):
        path = exr(path, names, light[..., : len(names)])
        with pytest.raises(TilewrightError, match=r"has the channels .*; allowed are R, G and B"):
            tw.read_image(path)
        stored = read(path, color=False)  # in the order of the file
        assert np.array_equal(np.sort(stored), np.sort(light[..., : len(names)]))
    with pytest.raises(TilewrightError, match="6 channels; allowed are 1 to 4"):
        tw.read_image(exr(path, ("a", "b", "c", "d", "e", "f"), light))


def test_exr_primaries_are_heeded(tmp_path):
    light = (counted(3, 255) / 255).astype(np.float32)
    path = exr(tmp_path / "a.exr", ("R", "G", "B"), light, chromaticities=P3_XY)
    matrix = np.linalg.solve(np.array(D50["srgb"]).T, np.array(D50["p3"]).T)
    assert np.abs(read(path, "primaries") - light @ matrix.T).max() < 0.004
    path = exr(tmp_path / "a.exr", ("R", "G", "B"), light, chromaticities=SRGB_XY)
    assert np.array_equal(read(path), light)


def test_further_channels_of_tiff_are_no_alpha(tmp_path):
    import tifffile

    pixels = counted(5, 255)
    path = tmp_path / "a.tif"
    for count, extra, kept, note in (
        (4, ["unspecified"], [0, 1, 2], "in channel channel3"),
        (5, ["unassalpha", "unspecified"], [0, 1, 2, 3], "in channel channel4"),
        (2, ["unspecified"], [0], "in channel channel1"),
    ):
        photometric = "rgb" if count > 2 else "minisblack"
        given = pixels[..., :count]
        tifffile.imwrite(path, given, photometric=photometric, planarconfig="contig", extrasamples=extra)
        assert np.array_equal(read(path, note), pixels[..., kept])


@pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float32])
def test_associated_alpha_is_divided_out(tmp_path, kind):
    import tifffile

    most = 1 if kind is np.float32 else np.iinfo(kind).max
    straight = np.empty((HEIGHT, WIDTH, 4))
    straight[..., :3] = (0.8, 0.2, 0.1)
    straight[..., 3] = np.linspace(0, 1, WIDTH)
    associated = straight.copy()
    associated[..., :3] *= straight[..., 3:]
    stored = associated * most if kind is np.float32 else np.rint(associated * most)
    stored = stored.astype(kind)
    tifffile.imwrite(tmp_path / "a.tif", stored, photometric="rgb", extrasamples=["assocalpha"])
    pixels = read(tmp_path / "a.tif")
    dense = slice(WIDTH // 3, None)
    assert np.abs(pixels[:, dense, :3] / most - (0.8, 0.2, 0.1)).max() < 0.01
    assert not pixels[:, 0].any()
    assert np.array_equal(pixels[..., 3], stored[..., 3])
    assert np.array_equal(read(tmp_path / "a.tif", color=False), stored)
    stored[:, 0, 0] = most
    tifffile.imwrite(tmp_path / "a.tif", stored, photometric="rgb", extrasamples=["assocalpha"])
    assert (read(tmp_path / "a.tif", "light where its alpha is 0")[:, 0, 0] == most).all()


@pytest.mark.parametrize("channels", [2, 4])
def test_colors_go_to_exr_and_back(tmp_path, channels):
    pixels = (counted(channels, 255) / 255).astype(np.float32)
    tw.write_image(tmp_path / "a.exr", pixels)
    stored = read(tmp_path / "a.exr", color=False)
    assert np.array_equal(stored[..., :-1], pixels[..., :-1] * pixels[..., -1:])
    seen = pixels[..., -1] > 0
    assert np.abs(read(tmp_path / "a.exr") - pixels)[seen].max() < 1e-6


@pytest.mark.parametrize(
    ("descriptor", "kind", "channels"), [(0, None, 3), (8, None, 4), (8, 3, 4), (8, 2, 3)]
)
def test_the_fourth_byte_of_tga_is_alpha_where_it_is_said(tmp_path, descriptor, kind, channels):
    pixels = counted(4, 255)
    head = struct.pack("<3B5x4HBB", 0, 0, 2, 0, 0, WIDTH, HEIGHT, 32, descriptor | 0x20)
    body = pixels[..., [2, 1, 0, 3]].tobytes()
    extension = b"" if kind is None else struct.pack("<H", 495).ljust(494, b"\0") + bytes([kind])
    end = b"" if kind is None else struct.pack("<II", len(head + body), 0) + b"TRUEVISION-XFILE.\0"
    path = keep(tmp_path, "a.tga", head + body + extension + end)
    note = "states that it has no alpha" if channels == 3 else ""
    assert np.array_equal(read(path, note), pixels[..., :channels])


def test_premultiplied_tga_comes_straight(tmp_path):
    pixels = np.zeros((HEIGHT, WIDTH, 4), np.uint8)
    pixels[...] = (100, 50, 25, 128)
    head = struct.pack("<3B5x4HBB", 0, 0, 2, 0, 0, WIDTH, HEIGHT, 32, 0x28)
    body = pixels[..., [2, 1, 0, 3]].tobytes()
    end = struct.pack("<II", len(head + body), 0) + b"TRUEVISION-XFILE.\0"
    path = keep(tmp_path, "a.tga", head + body + struct.pack("<H", 495).ljust(494, b"\0") + b"\4" + end)
    assert (read(path)[0, 0] == (199, 100, 50, 128)).all()


def frames(format, **options):
    pictures = [Image.fromarray(np.roll(counted(3, 255), n, axis=1)) for n in (0, 5, 9)]
    target = io.BytesIO()
    pictures[0].save(target, format=format, save_all=True, append_images=pictures[1:], **options)
    return target.getvalue()


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("a.png", frames("PNG", default_image=False)),
        ("a.webp", frames("WEBP", lossless=True)),
        ("a.tif", frames("TIFF")),
    ],
)
def test_the_first_of_several_pictures_is_taken(tmp_path, name, data):
    note = "an animation; the first of 3" if name == "a.png" else "several pictures; the first of 3"
    assert np.array_equal(read(keep(tmp_path, name, data), note)[..., :3], counted(3, 255))


def test_avif_that_cannot_be_read_is_named(tmp_path, monkeypatch):
    monkeypatch.setattr(features, "check", lambda name: False)
    with pytest.raises(TilewrightError, match="is AVIF, which this Pillow does not read; install"):
        tw.read_image(keep(tmp_path, "a.avif", b"\0\0\0\x18ftypavif\0\0\0\0mif1avif" + bytes(40)))


def test_the_first_picture_of_a_gif_is_taken(tmp_path):
    shown = read(keep(tmp_path, "a.gif", frames("GIF")), "several pictures; the first of 3")
    assert np.abs(shown[..., :3].astype(int) - counted(3, 255)).mean() < 30


def test_previews_in_a_tiff_are_passed_over(tmp_path):
    import tifffile

    with tifffile.TiffWriter(tmp_path / "a.tif") as file:
        file.write(counted(3, 255)[:9, :9], photometric="rgb", subfiletype=1)
        file.write(counted(3, 255), photometric="rgb")
    assert np.array_equal(read(tmp_path / "a.tif"), counted(3, 255))
    tifffile.imwrite(tmp_path / "b.tif", counted(3, 255), photometric="rgb", subfiletype=1)
    with pytest.raises(TilewrightError, match="holds a preview and no whole picture"):
        tw.read_image(tmp_path / "b.tif")


def test_the_largest_picture_of_an_icon_is_taken(tmp_path):
    target = io.BytesIO()
    Image.fromarray(np.tile(counted(4, 255), (2, 2, 1))[:64, :64]).save(
        target, "ICO", sizes=[(16, 16), (64, 64)]
    )
    assert read(keep(tmp_path, "a.ico", target.getvalue()), "2 sizes; the largest").shape == (64, 64, 4)


@pytest.mark.skipif(not features.check("avif"), reason="Pillow is built without AVIF")
def test_avif_is_read(tmp_path):
    options = {"format": "AVIF", "quality": 95, "subsampling": "4:4:4"}
    shown = read(keep(tmp_path, "a.avif", by_pillow(smooth(4), **options)))
    assert np.abs(shown.astype(int) - smooth(4)).max() <= 8
    data = by_pillow(smooth(), **options)
    at = data.index(b"colrnclx") + 8
    p3 = data[:at] + struct.pack(">HH", 12, 13) + data[at + 4 :]
    assert not np.array_equal(read(keep(tmp_path, "b.avif", p3), "Display P3"), smooth())


@pytest.mark.parametrize(
    ("name", "data", "message"),
    [
        ("a.heic", b"\0\0\0\x18ftypheic\0\0\0\0mif1heic" + bytes(40), "is HEIC, which is not read"),
        ("a.jpg", b"\0\0\0\x18ftypmif1\0\0\0\0mif1heic" + bytes(40), "is HEIC, which is not read"),
        ("a.svg", b"<svg xmlns='http://www.w3.org/2000/svg'/>", "is SVG"),
        ("a.pdf", b"%PDF-1.7", "is PDF"),
        ("a.png", b"hello", "cannot be read as an image; allowed are PNG, JPEG"),
        ("a.null", b"hello", "cannot be read as an image"),
        ("a.cr3", b"\0\0\0\x18ftypcrx \0\0\0\1crx isom" + bytes(40), "a camera's raw file"),
        ("a.raf", b"FUJIFILMCCD-RAW 0201" + bytes(40), "a camera's raw file"),
        ("a.nef", b"MM\0*" + bytes(40), "a camera's raw file"),
        ("a.mp4", b"\0\0\0\x18ftypisom\0\0\0\0isommp41" + bytes(40), "A video"),
        ("a.bmp", b"BM" + bytes(60), "truncated or damaged|cannot be read as an image"),
        ("a.avif", b"\0\0\0\x18ftypavif\0\0\0\0mif1avif" + bytes(40), "damaged|cannot be read as an image"),
        ("a.tga", bytes(30), "cannot be read as an image|damaged"),
        ("a.dds", b"DDS " + bytes(140), "cannot be read as an image|damaged"),
    ],
)
def test_what_is_not_read_is_named(tmp_path, name, data, message):
    with pytest.raises(TilewrightError, match=message) as error:
        tw.read_image(keep(tmp_path, name, data))
    line = str(error.value)
    assert "\n" not in line
    assert "OpenImageIO" not in line
    assert name in line


@pytest.mark.parametrize(
    "name", ["gray.tga", "color-rle.tga", "color.bmp", "color.dds", "color.webp", "color.jp2"]
)
def test_files_that_are_cut_off_are_refused(tmp_path, name):
    data = next(data for stored, data, _ in odd_images.pillow_files() if stored == name)
    with pytest.raises(TilewrightError) as error:
        tw.read_image(keep(tmp_path, name, data[: len(data) // 2]))
    assert "\n" not in str(error.value)
    assert "OpenImageIO" not in str(error.value)


def test_bitmaps_may_be_as_large_as_photographs_are(tmp_path):
    row = np.packbits(np.arange(20_000) % 3 == 0).tobytes()
    row += bytes(-len(row) % 4)
    info = struct.pack("<IiiHHIIiiII", 40, 20_000, 10_000, 1, 1, 0, 0, 0, 0, 0, 0)
    head = struct.pack("<2sIHHI", b"BM", 0, 0, 0, 62) + info + bytes(4) + b"\xff\xff\xff\0"
    usual = Image.MAX_IMAGE_PIXELS
    shown = read(keep(tmp_path, "a.bmp", head + row * 10_000))
    assert shown.shape == (10_000, 20_000, 1)
    assert (shown[:, :4, 0] == (255, 0, 0, 255)).all()
    assert usual == Image.MAX_IMAGE_PIXELS


def test_damaged_jpeg_is_no_jpeg_with_stray_bytes(tmp_path):
    data = by_pillow(counted(3, 255), format="JPEG", quality=90)
    at = data.index(b"\xff\xdb")
    stray = data[:at] + bytes(7) + data[at:]
    wanted = read(keep(tmp_path, "a.jpg", data))
    assert np.array_equal(read(keep(tmp_path, "b.jpg", stray), "stray bytes"), wanted)
    for whole in (data, stray):
        with pytest.raises(TilewrightError, match="truncated or damaged"):
            tw.read_image(keep(tmp_path, "c.jpg", whole[: len(whole) * 2 // 3]))


def test_pictures_of_nothing_get_a_note(tmp_path):
    pixels = np.tile(counted(4, 255), (2, 2, 1))
    pixels[..., 3] = 0
    tw.write_image(tmp_path / "a.png", pixels)
    with pytest.warns(TilewrightWarning, match="the photograph is wholly transparent"):
        tw.open_exemplar(tmp_path / "a.png")
    tw.write_image(tmp_path / "b.png", np.full((64, 64, 3), (0, 7, 0), np.uint8))
    with pytest.warns(TilewrightWarning, match=r"b\.png is 0, 7, 0 everywhere"):
        tw.open_exemplar({"albedo": tmp_path / "b.png"})


def test_maps_without_color_keep_their_numbers(tmp_path):
    pixels = np.tile(counted(3, 255), (2, 2, 1))
    path = keep(tmp_path, "a.png", png(8, 2, pixels, icc_chunk(profile())))
    with pytest.warns(TilewrightWarning, match="converted"):
        exemplar = tw.open_exemplar({"albedo": path, "mask": path})
    assert np.array_equal(exemplar.sources[0]["mask"], pixels)
    assert not np.array_equal(exemplar.sources[0]["albedo"], pixels)
    told = tw.open_exemplar({"albedo": path}, kinds={"albedo": "data"})
    assert np.array_equal(told.sources[0]["albedo"], pixels)


def test_sides_that_no_format_takes_are_refused_before_rendering(tmp_path):
    from tilewright.files.image_streams import stream_image

    for name, width, allowed in (("a.png", 1_000_001, "1,000,000"), ("a.exr", 1_048_577, "1,048,576")):
        kind = np.dtype(np.uint8 if name == "a.png" else np.float32)
        with pytest.raises(TilewrightError, match=f"at most {allowed} on a side; write a .tif"):
            stream_image(tmp_path / name, pytest.fail, 1, width, 3, kind)
        with pytest.raises(TilewrightError, match=f"at most {allowed} on a side; write a .tif"):
            tw.write_image(tmp_path / name, np.zeros((width, 1, 1), kind))
    assert not any(tmp_path.iterdir())
