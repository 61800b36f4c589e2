"""Image files of many kinds, each with the pixels it holds: what was written, or Pillow's word."""

import io
import struct
import zlib

import numpy as np

HEIGHT, WIDTH = 33, 37
"""Odd, so that rows end within bytes, blocks and tiles."""


def counted(channels, most, kind=np.uint8):
    """Pixels that differ in every place."""
    y, x = np.mgrid[:HEIGHT, :WIDTH]
    planes = [(x * (3 + c) + y * (5 + 2 * c) + 11 * c) % (most + 1) for c in range(channels)]
    return np.stack(planes, axis=-1).astype(kind)


def wide(channels):
    """The same of 16 bits, both bytes in use."""
    return (counted(channels, 65535, np.int64) * 3571 % 65536).astype(np.uint16)


def smooth(channels=3):
    """Pixels that survive compression with loss."""
    y, x = np.mgrid[:HEIGHT, :WIDTH] / 40
    planes = [128 + 100 * np.sin(2 * x + c) * np.cos(3 * y - c) for c in range(channels)]
    return np.stack(planes, axis=-1).astype(np.uint8)


def png(depth, color_type, pixels, *chunks, interlaced=False):
    """A PNG file by the book (section 9 and 10), each row without a filter."""
    passes = [
        (0, 0, 8, 8),
        (4, 0, 8, 8),
        (0, 4, 4, 8),
        (2, 0, 4, 4),
        (0, 2, 2, 4),
        (1, 0, 2, 2),
        (0, 1, 1, 2),
    ]
    parts = [pixels[y::dy, x::dx] for x, y, dx, dy in passes] if interlaced else [pixels]
    data = b"".join(b"\0" + _packed(row, depth) for part in parts if part.size for row in part)
    header = struct.pack(">2I5B", pixels.shape[1], pixels.shape[0], depth, color_type, 0, 0, interlaced)
    whole = [(b"IHDR", header), *chunks, (b"IDAT", zlib.compress(data)), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        for kind, body in whole
    )


def _packed(row, depth):
    if depth >= 8:
        return row.astype(">u2" if depth == 16 else np.uint8).tobytes()
    bits = (row.reshape(-1, 1) >> np.arange(depth - 1, -1, -1)) & 1
    return np.packbits(bits.astype(np.uint8)).tobytes()


PALETTE = (np.arange(256)[:, np.newaxis] * (7, 29, 101) % 256).astype(np.uint8)
HOLES = (np.arange(256) * 37 % 256).astype(np.uint8)


def _with_hole(pixels, color, most):
    """Pixels with alpha, 0 where they have one color."""
    alpha = np.where((pixels == color).all(axis=-1, keepdims=True), 0, most).astype(pixels.dtype)
    return np.concatenate([pixels, alpha], axis=-1)


def png_files():
    """PNG of all depths and color types."""
    for depth in (1, 2, 4):
        gray = counted(1, 2**depth - 1)
        yield f"gray{depth}.png", png(depth, 0, gray), gray * (255 // (2**depth - 1))
        yield f"gray{depth}-adam7.png", png(depth, 0, gray, interlaced=True), gray * (255 // (2**depth - 1))
    for depth in (1, 2, 4, 8):
        chosen, count = counted(1, 2**depth - 1), 2**depth
        palette = (b"PLTE", PALETTE[:count].tobytes())
        colors = PALETTE[chosen[..., 0]]
        yield f"palette{depth}.png", png(depth, 3, chosen, palette), colors
        holed = png(depth, 3, chosen, palette, (b"tRNS", HOLES[:count].tobytes()))
        yield f"palette{depth}-alpha.png", holed, np.concatenate([colors, HOLES[chosen]], axis=-1)
    for color_type, channels in ((0, 1), (4, 2), (2, 3), (6, 4)):
        small, large = counted(channels, 255), wide(channels)
        yield f"{channels}x8.png", png(8, color_type, small), small
        yield f"{channels}x16.png", png(16, color_type, large), large
        yield f"{channels}x8-adam7.png", png(8, color_type, small, interlaced=True), small
        yield f"{channels}x16-adam7.png", png(16, color_type, large, interlaced=True), large
        if color_type in (0, 2):
            for depth, pixels in ((8, small), (16, large)):
                hole = (b"tRNS", pixels[5, 7].astype(">u2").tobytes())
                holed = _with_hole(pixels, pixels[5, 7], 2**depth - 1)
                yield f"{channels}x{depth}-hole.png", png(depth, color_type, pixels, hole), holed


def by_pillow(pixels, **options):
    """A file that Pillow writes."""
    from PIL import Image

    mode = options.pop("mode", None)
    image = Image.fromarray(pixels[..., 0] if pixels.shape[-1] == 1 else pixels)
    target = io.BytesIO()
    (image.convert(mode) if mode else image).save(target, **options)
    return target.getvalue()


def pillow_files():
    """Formats that Pillow writes without loss."""
    from PIL import Image

    gray, color, alpha = counted(1, 255), counted(3, 255), counted(4, 255)
    for name, pixels in (("gray", gray), ("color", color), ("alpha", alpha)):
        yield f"{name}.tga", by_pillow(pixels, format="TGA"), pixels
        yield f"{name}-rle.tga", by_pillow(pixels, format="TGA", compression="tga_rle"), pixels
        yield f"{name}.dds", by_pillow(pixels, format="DDS"), pixels
        yield f"{name}.jp2", by_pillow(pixels, format="JPEG2000", irreversible=False), pixels
        for way in ("tiff_lzw", "tiff_adobe_deflate", "packbits"):
            yield f"{name}-{way}.tif", by_pillow(pixels, format="TIFF", compression=way), pixels
        predicted = by_pillow(pixels, format="TIFF", compression="tiff_lzw", tiffinfo={317: 2})
        yield f"{name}-predictor.tif", predicted, pixels
        if name != "alpha":
            yield f"{name}.bmp", by_pillow(pixels, format="BMP"), pixels
            yield f"{name}.pnm", by_pillow(pixels, format="PPM"), pixels
            yield f"{name}.sgi", by_pillow(pixels, format="SGI"), pixels
        if name != "gray":
            yield f"{name}.webp", by_pillow(pixels, format="WEBP", lossless=True, exact=True), pixels
    bits = counted(1, 1) * 255
    for format in ("BMP", "TIFF", "PPM"):
        yield f"bits.{format.lower()}", by_pillow(bits, mode="1", format=format), bits
    yield "group4.tif", by_pillow(bits, mode="1", format="TIFF", compression="group4"), bits
    few = Image.fromarray(counted(3, 255)).quantize(16)
    shown = np.asarray(few.convert("RGB"))
    for format in ("BMP", "TIFF"):
        target = io.BytesIO()
        few.save(target, format=format)
        yield f"palette.{format.lower()}", target.getvalue(), shown
    target = io.BytesIO()
    few.save(target, format="GIF")
    full = np.full((HEIGHT, WIDTH, 1), 255, np.uint8)
    yield "opaque.gif", target.getvalue(), np.concatenate([shown, full], axis=-1)


def bitmap(bits, rows, masks=(), top_down=False, compression=0):
    """A BMP file with this header, its rows as they are stored."""
    stride = -(-WIDTH * bits // 32) * 4
    body = b"".join(row + bytes(stride - len(row)) for row in (rows if top_down else rows[::-1]))
    extra = struct.pack(f"<{len(masks)}I", *masks)
    start = 54 + len(extra)
    high = -HEIGHT if top_down else HEIGHT
    info = struct.pack("<IiiHHIIiiII", 40, WIDTH, high, 1, bits, compression, len(body), 0, 0, 0, 0)
    return struct.pack("<2sIHHI", b"BM", start + len(body), 0, 0, start) + info + extra + body


def bitmap_files():
    """BMP of depths and orders that paint programs write."""
    color = counted(3, 255)
    rows = [row[:, ::-1].tobytes() for row in color]
    yield "top-down.bmp", bitmap(24, rows, top_down=True), color
    for name, shifts in (("xrgb", (16, 8, 0)), ("bgrx", (8, 16, 24)), ("rxgb", (24, 8, 0))):
        texels = sum(color[..., c].astype("<u4") << np.uint32(shift) for c, shift in enumerate(shifts))
        masks = [255 << shift for shift in shifts]
        stored = [row.astype("<u4").tobytes() for row in texels]
        yield f"masks-{name}.bmp", bitmap(32, stored, masks, compression=3), color
        yield f"masks-{name}-top-down.bmp", bitmap(32, stored, masks, True, compression=3), color
    for name, sizes in (("565", (5, 6, 5)), ("444", (4, 4, 4)), ("555", (5, 5, 5))):
        shifts = (sizes[1] + sizes[2], sizes[2], 0)
        small = [counted(3, 255)[..., c] >> (8 - size) for c, size in enumerate(sizes)]
        texels = sum(s.astype("<u2") << np.uint16(shift) for s, shift in zip(small, shifts, strict=True))
        masks = [(2**size - 1) << shift for size, shift in zip(sizes, shifts, strict=True)]
        shown = [np.rint(s * 255.0 / (2**size - 1)) for s, size in zip(small, sizes, strict=True)]
        stored = [row.astype("<u2").tobytes() for row in texels]
        wanted = np.stack(shown, axis=-1).astype(np.uint8)
        yield f"masks-{name}.bmp", bitmap(16, stored, masks, compression=3), wanted


def tiff_files():
    """TIFF of types and layouts that scanners, surveys and programs write, by tifffile."""
    import tifffile

    def tiff(pixels, **options):
        target = io.BytesIO()
        tifffile.imwrite(target, pixels, metadata=None, **options)
        return target.getvalue()

    color = counted(3, 255)
    options = {
        "big-endian": {"byteorder": ">"},
        "bigtiff": {"bigtiff": True},
        "tiled": {"tile": (16, 16)},
        "strips": {"rowsperstrip": 5},
        "deflate": {"compression": "zlib"},
    }
    for name, chosen in options.items():
        for bits, pixels in ((8, color), (16, wide(3))):
            yield f"{name}{bits}.tif", tiff(pixels, photometric="rgb", **chosen), pixels
    planes = np.moveaxis(color, -1, 0)
    yield "planar.tif", tiff(planes, photometric="rgb", planarconfig="separate"), color
    gray = counted(1, 255)[..., 0]
    yield "white-is-zero.tif", tiff(gray, photometric="miniswhite"), 255 - gray[..., np.newaxis]
    yield "gray16.tif", tiff(wide(1)[..., 0], photometric="minisblack"), wide(1)
    for kind in (np.float16, np.float32):
        light = (counted(3, 255) / 64 - 1).astype(kind)
        yield f"{np.dtype(kind)}.tif", tiff(light, photometric="rgb"), light.astype(np.float32)
    for bits, pixels in ((8, counted(4, 255)), (16, wide(4))):
        yield f"alpha{bits}.tif", tiff(pixels, photometric="rgb", extrasamples=["unassalpha"]), pixels
    both = counted(2, 255)
    options = {"photometric": "minisblack", "planarconfig": "contig", "extrasamples": ["unassalpha"]}
    yield "gray-alpha.tif", tiff(both, **options), both


def plain_files():
    """Formats that are simple enough to be written by hand."""
    color, gray = counted(3, 255), counted(1, 255)
    size = f"{WIDTH} {HEIGHT}\n"
    text = " ".join(str(v) for v in color.ravel())
    yield "text.ppm", f"P3\n# drawn by hand\n{size}255\n{text}\n".encode(), color
    yield "text.pgm", f"P2\n{size}255\n{' '.join(str(v) for v in gray.ravel())}\n".encode(), gray
    yield "16bit.pgm", f"P5\n{size}65535\n".encode() + wide(1).astype(">u2").tobytes(), wide(1)
    yield "16bit.ppm", f"P6\n{size}65535\n".encode() + wide(3).astype(">u2").tobytes(), wide(3)
    light = (counted(3, 255) / 64).astype(np.float32)
    yield "light.pfm", f"PF\n{size}-1.0\n".encode() + light[::-1].astype("<f4").tobytes(), light
    shared = np.concatenate([counted(3, 127) + 128, np.full((HEIGHT, WIDTH, 1), 130, np.uint8)], axis=-1)
    head = f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {HEIGHT} +X {WIDTH}\n".encode()
    yield "light.hdr", head + shared.tobytes(), (shared[..., :3] / 256 * 4).astype(np.float32)
    for bits, pixels in ((8, color), (16, wide(3))):
        header = struct.pack(">4sH6xHIIHH", b"8BPS", 1, 3, HEIGHT, WIDTH, bits, 3)
        planes = np.moveaxis(pixels, -1, 0).astype(">u2" if bits == 16 else np.uint8)
        yield f"{bits}bit.psd", header + bytes(12) + bytes(2) + planes.tobytes(), pixels


def exr_files(folder):
    """EXR by OpenImageIO, which is no independent word, of numbers that are."""
    import OpenImageIO as oiio

    for name, channels, kind, tile in (
        ("half", 3, "half", 0),
        ("float", 3, "float", 0),
        ("tiled", 3, "half", 16),
        ("gray", 1, "float", 0),
    ):
        light = (counted(channels, 255) / 64).astype(np.float32)
        spec = oiio.ImageSpec(WIDTH, HEIGHT, channels, kind)
        spec.tile_width = spec.tile_height = tile
        path = str(folder / "written.exr")
        output = oiio.ImageOutput.create(path)
        output.open(path, spec)
        output.write_image(light)
        output.close()
        yield f"{name}.exr", (folder / "written.exr").read_bytes(), light


def lossy_files():
    """Files compressed with loss; what they hold is Pillow's word."""
    color = smooth()
    exif = b"Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0%c\0\0\0\0\0\0"
    files = {
        "plain.jpg": by_pillow(color, format="JPEG", quality=90),
        "gray.jpg": by_pillow(smooth(1), format="JPEG", quality=90),
        "progressive.jpg": by_pillow(color, format="JPEG", quality=80, progressive=True),
        "444.jpg": by_pillow(color, format="JPEG", quality=80, subsampling=0),
        "422.jpg": by_pillow(color, format="JPEG", quality=80, subsampling=1),
        "restarts.jpg": by_pillow(color, format="JPEG", quality=80, restart_marker_blocks=1),
        "rgb.jpg": by_pillow(color, format="JPEG", quality=80, keep_rgb=True),
        "cmyk.jpg": by_pillow(color, mode="CMYK", format="JPEG", quality=95),
        "cmyk.tif": by_pillow(color, mode="CMYK", format="TIFF"),
        "jpeg.tif": by_pillow(color, format="TIFF", compression="jpeg", quality=90),
        "lossy.webp": by_pillow(color, format="WEBP", quality=80),
        "dxt1.dds": by_pillow(smooth(4), format="DDS", pixel_format="DXT1"),
        "dxt5.dds": by_pillow(smooth(4), format="DDS", pixel_format="DXT5"),
    }
    for turned in range(1, 9):
        files[f"exif{turned}.jpg"] = by_pillow(color, format="JPEG", quality=90, exif=exif % turned)
    return files
