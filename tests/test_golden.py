"""The bytes of what the library gives, pinned: moving code about must not change them.

``golden.json`` holds a SHA-256 digest (its first half) of each output, by group and name. Only names of the
public face are used, so these tests outlive any move of modules.

What is digested: integers, texts and files as they are. Numbers with a fraction are rounded to six digits of
the largest of their array, and so are those written in texts, because processors that fuse a product and a
sum differ in the last ones; sets of points found by a long search may still differ on another family of
processors. Where every pixel passes through powers and exponentials, whose last digits belong to the
processor, some lie near the middle between two numbers: of such a picture, an `About`, the means of sixteen
parts are kept, and compared to five digits. Pictures count as their pixels beside all that is said of them,
not as compressed bytes, which belong to a version of a library. Program version, checksums of compressed
files and timings are left out.

``python tests/test_golden.py --write`` writes the table anew; ``--write NAME`` one group of it.
"""

import base64
import hashlib
import importlib.util
import json
import re
import struct
import sys
import zlib
from math import ceil, log10
from pathlib import Path

import numpy as np
import pytest

import golden_files
import golden_points
import golden_textures
import golden_tilings
import tilewright as tw
from golden_textures import About

TABLE = Path(__file__).with_name("golden.json")
GROUPS = {
    **golden_tilings.GROUPS,
    **golden_points.GROUPS,
    **golden_textures.GROUPS,
    **golden_files.GROUPS,
}
NEEDS_SOLVER = {"solved tilings"}
_VERSION = f"tilewright {tw.__version__}"
_FRACTION = re.compile(r"-?\d+\.\d{6,}(?:e[+-]?\d+)?|-?\d(?:\.\d+)?e-\d+")
_PNG_TEXT = re.compile(r"iVBORw0KGgo[A-Za-z0-9+/=]+")
_LEFT_OUT = re.compile(r'"checksums": ?\{[^}]*\}|"(?:version|program)": ?"[^"]*"')
_TEXTS = {".html", ".md", ".txt", ".json", ".svg", ".csv", ".glsl", ".hlsl", ".wgsl", ".osl", ".py", ".js"}
_DIGITS = 6


def digest(value):
    """A value as hex digits; see above for what counts."""
    return hashlib.sha256(plain(value)).hexdigest()[:32]


def plain(value):
    """The bytes that count of an array, a text, a file or figures."""
    if isinstance(value, Path):
        return plain_file(value)
    if isinstance(value, np.ndarray):
        value = rounded(value) if value.dtype.kind == "f" else value
        return f"{value.dtype.str} {value.shape}".encode() + np.ascontiguousarray(value).tobytes()
    if isinstance(value, list) and all(isinstance(one, Path) for one in value):
        return b"".join(path.name.encode() + plain_file(path) for path in value)
    if isinstance(value, (dict, list)):
        return json.dumps(rounded_figures(value)).encode()
    if isinstance(value, str):
        return plain_text(value).encode()
    if isinstance(value, bytes):
        return value.replace(_VERSION.encode(), b"tilewright")
    raise TypeError(f"no digest of {type(value).__name__}")


def rounded(array):
    """Numbers rounded to six digits of the largest; one zero and one NaN."""
    finite = array[np.isfinite(array)].astype(np.float64)
    most = np.abs(finite).max(initial=0.0)
    if most == 0:
        return array + 0.0
    made = np.round(array.astype(np.float64), _DIGITS - ceil(log10(most))) + 0.0
    return np.where(np.isnan(made), np.nan, made).astype(array.dtype)


def rounded_figures(value):
    """Figures rounded to nine digits, without timings and sizes of files."""
    if isinstance(value, dict):
        left_out = ("seconds", "milliseconds", "construction_seconds", "bytes")
        return {k: rounded_figures(v) for k, v in value.items() if k not in left_out}
    if isinstance(value, (list, tuple)):
        return [rounded_figures(v) for v in value]
    return float(f"{value:.9g}") if isinstance(value, float) else value


def plain_text(text):
    """A text without version, checksums and timings, its long fractions rounded."""

    def picture(found):
        return hashlib.sha256(plain_png(base64.b64decode(found[0]))).hexdigest()

    def number(found):
        value = float(found[0])
        return f"{value:.{_DIGITS}g}" if abs(value) > 1e-9 else "0"

    text = _PNG_TEXT.sub(picture, text.replace(_VERSION, "tilewright"))
    return _FRACTION.sub(number, _LEFT_OUT.sub("", text))


def plain_png(data):
    """All chunks of a PNG, the pixels' inflated."""
    parts, pixels, at = [], b"", 8
    while at < len(data):
        size, kind = int.from_bytes(data[at : at + 4]), data[at + 4 : at + 8]
        body = data[at + 8 : at + 8 + size]
        if kind == b"IDAT":
            pixels += body
        else:
            parts += [kind, body]
        at += 12 + size
    return b"".join([*parts, zlib.decompress(pixels)])


def plain_ktx2(data):
    """The parts of a KTX 2.0 file, wherever they lie: the writer's name moves them."""
    count = struct.unpack_from("<I", data, 40)[0]
    spans = [struct.unpack_from("<2I", data, 48 + 8 * k) for k in range(2)]
    spans += [struct.unpack_from("<2Q", data, 80 + 24 * k) for k in range(count)]
    described, said, *levels = (data[start : start + size] for start, size in spans)
    words = re.sub(rb".{4}KTXwriter\0[^\0]*\0+", b"", said, flags=re.DOTALL)
    return b"".join([data[:48], described, words, *levels])


def plain_file(path):
    """A file by what it holds."""
    suffix = path.suffix.lower()
    if suffix == ".png":
        return plain_png(path.read_bytes())
    if suffix in (".tif", ".exr"):
        return plain(tw.read_image(path))
    if suffix == ".gif":
        return plain_animation(path)
    if suffix == ".ktx2":
        return plain_ktx2(path.read_bytes())
    if suffix == ".npy":
        return plain(np.load(path))
    if suffix == ".npz":
        with np.load(path) as stored:
            return b"".join(name.encode() + plain(stored[name]) for name in stored)
    if suffix == ".parquet":
        return plain(tw.read_points(path).points)
    data = path.read_bytes()
    return plain(data.decode()) if suffix in _TEXTS else plain(data)


def plain_animation(path):
    """Frames and how long each is shown."""
    from PIL import Image, ImageSequence

    with Image.open(path) as picture:
        frames = [(f.info.get("duration"), f.convert("RGB")) for f in ImageSequence.Iterator(picture)]
    return b"".join(f"{shown} {frame.size}".encode() + frame.tobytes() for shown, frame in frames)


def find_digests(group):
    """The digests of a group, by name."""
    found = {}
    for name, value in GROUPS[group]():
        assert name not in found, f"two outputs are called {name!r}"
        found[name] = value.sketch() if isinstance(value, About) else digest(value)
    return found


def agrees(found, known):
    """Whether an output is that of the table: a digest, or a sketch up to its last digits."""
    if isinstance(found, str) or isinstance(known, str) or len(found) != len(known):
        return found == known
    return bool(np.allclose(found, known, rtol=1e-5, atol=1e-5 * max(map(abs, known))))


@pytest.mark.parametrize("group", GROUPS)
def test_outputs_are_those_of_the_table(group):
    if group in NEEDS_SOLVER:
        pytest.importorskip("pysat")
    known, found = json.loads(TABLE.read_text())[group], find_digests(group)
    wrong = [f"{name}: differs" for name in known if name in found and not agrees(found[name], known[name])]
    wrong += [f"{name}: no longer made" for name in known if name not in found]
    wrong += [f"{name}: not in {TABLE.name}" for name in found if name not in known]
    if wrong:
        pytest.fail("\n".join([f"outputs of {group!r}:", *wrong]), pytrace=False)


def write(names):
    """Write the table anew, or some groups of it."""
    table = json.loads(TABLE.read_text()) if TABLE.exists() and names else {}
    for group in names or GROUPS:
        if group in NEEDS_SOLVER and importlib.util.find_spec("pysat") is None:
            sys.exit("python-sat is needed to write the table")
        table[group] = find_digests(group)
    table = {group: table[group] for group in GROUPS if group in table}
    TABLE.write_text(json.dumps(table, indent=1) + "\n")


if __name__ == "__main__":
    if sys.argv[1:2] != ["--write"]:
        sys.exit(__doc__)
    write(sys.argv[2:])
