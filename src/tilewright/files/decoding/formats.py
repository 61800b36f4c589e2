"""Which format a file has, told by its first bytes, and what is said of those that are not read."""

from pathlib import Path

from tilewright.errors import TilewrightFileError

READ = "PNG, JPEG, TIFF, EXR, WebP, AVIF, JPEG 2000, JPEG XL, GIF, BMP, TGA, DDS, PSD, HDR and PNM"
"""The formats that people are told of; OpenImageIO reads a few more."""
ADVICE = "save it as PNG, JPEG, TIFF or EXR"
RAW = "a camera's raw file, which holds no picture yet"
RAW_ADVICE = "develop it, and save it as TIFF or PNG"

_BEGINNINGS = {
    b"\x89PNG\r\n\x1a\n": "png",
    b"\xff\xd8\xff": "jpeg",
    b"MM\0*": "tiff",
    b"II*\0": "tiff",
    b"MM\0+": "tiff",
    b"II+\0": "tiff",
    b"v/1\x01": "exr",
    b"GIF8": "gif",
    b"BM": "bmp",
    b"\0\0\1\0": "ico",
    b"\0\0\2\0": "ico",
    b"DDS ": "dds",
    b"8BPS": "psd",
    b"\0\0\0\x0cjP  ": "jpeg 2000",
    b"\xff\x4f\xff\x51": "jpeg 2000",
    b"\0\0\0\x0cJXL ": "jpeg xl",
    b"\xff\x0a": "jpeg xl",
    b"#?R": "hdr",
    # What can be named, and is not read.
    b"II*\0\x10\0\0\0CR": "raw",
    b"IIU\0": "raw",
    b"IIRO": "raw",
    b"IIRS": "raw",
    b"MMOR": "raw",
    b"FUJIFILMCCD-RAW": "raw",
    b"FOVb": "raw",
    b"\0MRM": "raw",
    b"II\x1a\0\0\0HEAPCCDR": "raw",
    b"%PDF": "PDF",
    b"%!PS": "PostScript",
    b"<svg": "SVG",
    b"<?xml": "XML",
    b"gimp xcf": "GIMP's own format",
    b"\xabKTX": "KTX",
    b"PK\x03\x04": "a zip file",
}
_BRANDS = {
    **dict.fromkeys((b"avif", b"avis"), "avif"),
    b"crx ": "raw",
    **dict.fromkeys((b"heic", b"heix", b"heim", b"heis", b"hevc", b"hevx", b"mif1", b"msf1"), "HEIC"),
}
"""Major brands of ISO base media files."""
_RAW_SUFFIXES = {
    *(".3fr", ".arw", ".cr2", ".cr3", ".crw", ".dng", ".erf", ".iiq", ".kdc", ".mef", ".mos", ".mrw"),
    *(".nef", ".nrw", ".orf", ".pef", ".raf", ".raw", ".rw2", ".rwl", ".sr2", ".srf", ".srw", ".x3f"),
}
_UNSAFE_SUFFIXES = {".null", ".nul", ".term"}
"""Names to which OpenImageIO answers without looking at the file."""


def tell_format(path: Path) -> str:
    """The format of a file; one of which nothing is known is named "other".

    Raises
    ------
    TilewrightFileError
        A format that is not read.
    """
    with path.open("rb") as file:
        start = file.read(64)
    found = _recognize(start, path)
    if found == "raw" or path.suffix.lower() in _RAW_SUFFIXES:
        raise raw_error(path)
    if found[0].isupper() or found.startswith("a "):
        raise TilewrightFileError(
            f"{path} is {found}, which is not read; allowed are {READ}",
            value=path,
            allowed=READ,
            advice=ADVICE,
        )
    return found


def _recognize(start: bytes, path: Path) -> str:
    if start[4:8] == b"ftyp":
        brands = [
            start[i : i + 4] for i in range(8, min(int.from_bytes(start[:4]), len(start)), 4) if i != 12
        ]
        # The first brand may be a general one, and a later one says what is in the file.
        named = [_BRANDS[brand] for brand in brands if brand in _BRANDS]
        return "avif" if "avif" in named else next(iter(named), "A video or another media file")
    if start[:4] == b"RIFF":
        return "webp" if start[8:12] == b"WEBP" else "other"
    if start[:4] == b"\0\0\2\0" and start[4:6] == b"\0\0":  # no cursors: a TGA file begins like this
        return "tga"
    matches = [beginning for beginning in _BEGINNINGS if start.startswith(beginning)]
    if matches:
        return _BEGINNINGS[max(matches, key=len)]
    if path.suffix.lower() in _UNSAFE_SUFFIXES:
        raise unknown_error(path)
    return "tga" if path.suffix.lower() in (".tga", ".tpic") else "other"


def raw_error(path: Path) -> TilewrightFileError:
    """The error of a camera's raw file."""
    return TilewrightFileError(f"{path} is {RAW}", value=path, advice=RAW_ADVICE)


def unknown_error(path: Path) -> TilewrightFileError:
    """The error of a file that no decoder knows."""
    return TilewrightFileError(
        f"{path} cannot be read as an image; allowed are {READ}", value=path, allowed=READ
    )


def damaged_error(path: Path, reason: str = "not all of its pixels can be read") -> TilewrightFileError:
    """The error of a file whose beginning is good and whose pixels are not."""
    return TilewrightFileError(f"{path} is truncated or damaged ({reason})", value=path)
