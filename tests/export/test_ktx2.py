"""KTX 2.0 files: read back by a small parser written from the specification, and by ktx-parse."""

import json
import shutil
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightError
from tilewright.export.ktx2 import GPU_FORMATS, gpu_bytes, write_ktx2

NODE_TOOLS = Path(__file__).parents[2] / ".venv" / "node"
PARSE = """
import { readFileSync } from "node:fs";
import { read } from "ktx-parse";
const file = read(new Uint8Array(readFileSync(process.argv[1])));
file.levels = file.levels.map((level) => Buffer.from(level.levelData).toString("hex"));
console.log(JSON.stringify(file));
"""


def pyramid(kind, channels, layers=3, rows=20, columns=12):
    """Random levels down to 1 x 1; no layers where ``layers`` is 0."""
    rng = np.random.default_rng([channels, layers, rows, columns])
    levels = []
    for k in range(max(rows, columns).bit_length()):
        shape = (max(1, rows >> k), max(1, columns >> k), channels)
        if layers:
            shape = (layers, *shape)
        values = rng.random(shape)
        levels.append((values * (1 if kind().dtype.kind == "f" else np.iinfo(kind).max)).astype(kind))
    return levels


def read_ktx2(path):
    """Header, descriptor, keys and levels after the Khronos specification, with its demands asserted."""
    data = path.read_bytes()
    assert data[:12] == bytes([0xAB, 0x4B, 0x54, 0x58, 0x20, 0x32, 0x30, 0xBB, 0x0D, 0x0A, 0x1A, 0x0A])
    names = ("vkFormat", "typeSize", "width", "height", "depth", "layers", "faces", "levels", "scheme")
    names += ("dfd", "dfdSize", "kvd", "kvdSize")
    header = dict(zip(names, struct.unpack_from("<13I", data, 12), strict=True))
    assert struct.unpack_from("<2Q", data, 64) == (0, 0)
    assert (header["depth"], header["faces"], header["scheme"]) == (0, 1, 0)
    index = [struct.unpack_from("<3Q", data, 80 + 24 * k) for k in range(header["levels"])]

    # Data format descriptor: one basic block.
    assert header["dfd"] == 80 + 24 * len(index)
    total, vendor, version = struct.unpack_from("<3I", data, header["dfd"])
    assert total == header["dfdSize"] == header["kvd"] - header["dfd"]
    assert (vendor, version & 0xFFFF, version >> 16) == (0, 2, total - 4)
    model, primaries, transfer, flags, *rest = struct.unpack_from("<16B", data, header["dfd"] + 12)
    assert (model, flags, rest[:4], rest[5:]) == (1, 0, [0] * 4, [0] * 7)
    header.update(primaries=primaries, transfer=transfer, texel=rest[4])
    assert (total - 28) % 16 == 0
    header["samples"] = [
        struct.unpack_from("<H2BIII", data, header["dfd"] + 28 + 16 * k) for k in range((total - 28) // 16)
    ]

    # Keys and values, sorted, each padded to four bytes.
    at, keys = header["kvd"], []
    while at < header["kvd"] + header["kvdSize"]:
        (size,) = struct.unpack_from("<I", data, at)
        keys.append(data[at + 4 : at + 4 + size].split(b"\0"))
        assert not any(data[at + 4 + size : at + 4 + size + -size % 4])
        at += 4 + size + -size % 4
    assert at == header["kvd"] + header["kvdSize"]
    assert [k for k, *_ in keys] == sorted(k for k, *_ in keys)
    header["keys"] = {key.decode(): value.decode() for key, value, _ in keys}

    # Levels from the smallest on, aligned, with nothing but padding between them and nothing after.
    step = np.lcm(header["texel"], 4)
    for offset, length, unpacked in reversed(index):
        assert offset % step == 0
        assert length == unpacked
        assert 0 <= offset - at < step
        assert not any(data[at:offset])
        at = offset + length
    assert at == len(data)
    return header, [data[offset : offset + length] for offset, length, _ in index]


def read_by_ktx_parse(path):
    node = shutil.which("node")
    if node is None or not (NODE_TOOLS / "node_modules" / "ktx-parse").exists():
        pytest.skip("ktx-parse was not found; sh .ci/install-node-tools")
    told = subprocess.run(
        [node, "--input-type=module", "-e", PARSE, str(path)],
        cwd=NODE_TOOLS,
        capture_output=True,
        text=True,
        check=True,
    )
    return json.loads(told.stdout)


def expected_bytes(level, srgb):
    """What the file must hold, said in another way: with three channels, or light, always four."""
    if level.dtype == np.float32:
        level = level.astype(np.float16)
    channels = np.moveaxis(level, -1, 0)
    one = np.full(channels[0].shape, 1 if level.dtype.kind == "f" else np.iinfo(level.dtype).max, level.dtype)
    if len(channels) == 3:
        channels = [*channels, one]
    elif srgb and len(channels) < 3:
        channels = [channels[0]] * 3 + [channels[1] if len(channels) == 2 else one]
    return np.stack(channels, axis=-1).tobytes()


FORMATS = {
    # type, channels, light: VkFormat
    (np.uint8, 1, False): 9,
    (np.uint8, 2, False): 16,
    (np.uint8, 3, False): 37,
    (np.uint8, 4, False): 37,
    (np.uint8, 1, True): 43,
    (np.uint8, 2, True): 43,
    (np.uint8, 3, True): 43,
    (np.uint8, 4, True): 43,
    (np.uint16, 1, False): 70,
    (np.uint16, 2, False): 77,
    (np.uint16, 3, False): 91,
    (np.uint16, 3, True): 91,
    (np.float32, 1, False): 76,
    (np.float32, 2, False): 83,
    (np.float32, 3, False): 97,
    (np.float16, 4, False): 97,
}


@pytest.mark.parametrize("layers", [0, 1, 5])
@pytest.mark.parametrize(("kind", "channels", "srgb"), FORMATS)
def test_files_follow_the_specification(tmp_path, kind, channels, srgb, layers):
    levels = pyramid(kind, channels, layers)
    write_ktx2(tmp_path / "a.ktx2", levels, srgb=srgb)
    header, read = read_ktx2(tmp_path / "a.ktx2")
    assert header["vkFormat"] == FORMATS[kind, channels, srgb]
    assert (header["width"], header["height"]) == (12, 20)
    assert (header["layers"], header["levels"]) == (layers, 5)
    assert header["keys"] == {"KTXorientation": "rd", "KTXwriter": f"tilewright {tw.__version__}"}
    assert read == [expected_bytes(level, srgb) for level in levels]
    size = 1 if kind is np.uint8 else 2
    assert header["typeSize"] == size
    assert header["texel"] == size * len(header["samples"])
    assert (header["primaries"], header["transfer"]) == ((1, 2) if srgb else (0, 1))
    for number, (offset, bits, channel, position, low, high) in enumerate(header["samples"]):
        assert (offset, bits + 1, position) == (8 * size * number, 8 * size, 0)
        assert channel & 15 == (15 if number == 3 else number)
        assert channel >> 4 == (12 if kind().dtype.kind == "f" else int(srgb and number == 3))
        limits = (0xBF800000, 0x3F800000) if kind().dtype.kind == "f" else (0, 256**size - 1)
        assert (low, high) == limits


@pytest.mark.parametrize(("kind", "channels", "srgb"), FORMATS)
def test_ktx_parse_reads_the_same(tmp_path, kind, channels, srgb):
    levels = pyramid(kind, channels)
    write_ktx2(tmp_path / "a.ktx2", levels, srgb=srgb)
    read = read_by_ktx_parse(tmp_path / "a.ktx2")
    assert [bytes.fromhex(level) for level in read["levels"]] == [expected_bytes(x, srgb) for x in levels]
    assert read["vkFormat"] == FORMATS[kind, channels, srgb]
    assert (read["pixelWidth"], read["pixelHeight"], read["layerCount"], read["levelCount"]) == (12, 20, 3, 5)
    (block,) = read["dataFormatDescriptor"]
    assert (block["colorModel"], block["transferFunction"]) == (1, 2 if srgb else 1)
    assert len(block["samples"]) == (channels if channels < 3 and not srgb else 4)
    assert read["keyValue"]["KTXorientation"] == "rd"


def test_half_floats_keep_every_number_they_have(tmp_path):
    every = np.arange(65536, dtype=np.uint16).view(np.float16)
    finite = every[np.isfinite(every)].reshape(1, 248, 256, 1)
    for kind in (np.float16, np.float32):
        write_ktx2(tmp_path / "a.ktx2", [finite.astype(kind)], srgb=False)
        _, (level,) = read_ktx2(tmp_path / "a.ktx2")
        assert np.array_equal(np.frombuffer(level, "<u2"), finite.view(np.uint16).ravel())


def test_bytes_on_the_gpu():
    array = pyramid(np.uint8, 3, layers=7, rows=20, columns=12)
    texels = 7 * (20 * 12 + 10 * 6 + 5 * 3 + 2 * 1 + 1)
    blocks4 = 7 * (5 * 3 + 3 * 2 + 2 * 1 + 1 + 1)
    blocks6 = 7 * (4 * 2 + 2 * 1 + 1 + 1 + 1)
    wanted = {"R8": texels, "RGBA8": 4 * texels, "RGBA16F": 8 * texels, "BC4": 8 * blocks4}
    wanted |= {"BC5": 16 * blocks4, "BC7": 16 * blocks4, "ASTC 4x4": 16 * blocks4, "ASTC 6x6": 16 * blocks6}
    assert {name: gpu_bytes(array, name) for name in wanted} == wanted
    assert set(wanted) < set(GPU_FORMATS)
    assert gpu_bytes([level[0] for level in array], "RGBA8") == 4 * texels // 7


def test_bytes_on_the_gpu_are_those_in_the_file(tmp_path):
    levels = pyramid(np.float32, 3)
    write_ktx2(tmp_path / "a.ktx2", levels, srgb=False)
    _, read = read_ktx2(tmp_path / "a.ktx2")
    assert gpu_bytes(levels, "RGBA16F") == sum(map(len, read))


good = pyramid(np.uint8, 3)
high = [np.full((1, 1, 1), 70000, np.float32)]
missing = [np.full((1, 1, 1), np.nan, np.float16)]


@pytest.mark.parametrize(
    ("path", "levels", "srgb", "message"),
    [
        ("a.ktx", good, True, r"a.ktx ends in '.ktx'; a KTX 2.0 file ends in .ktx2"),
        ("a.ktx2", [], True, "levels is empty"),
        ("a.ktx2", [level.astype(np.int32) for level in good], True, "levels hold int32"),
        ("a.ktx2", [good[0][0, 0]], True, "level 0 has shape .12, 3."),
        ("a.ktx2", [np.zeros((4, 4, 5), np.uint8)], True, "1 to 4 channels"),
        ("a.ktx2", good[::2], True, r"level 1 is uint8 .3, 5, 3, 3.; expected uint8 .3, 10, 6, 3."),
        ("a.ktx2", [*good, good[-1]], True, "levels are 6; a texture of this size has at most 5"),
        ("a.ktx2", pyramid(np.float32, 3), True, "pass srgb=False"),
        ("a.ktx2", high, False, "levels hold 70000.0; half floats are finite and end at 65504"),
        ("a.ktx2", missing, False, "levels hold nan"),
        (f"{__file__}/a.ktx2", good, True, "is not a folder"),
    ],
)
def test_bad_levels_get_one_clear_line(tmp_path, path, levels, srgb, message):
    with pytest.raises(TilewrightError, match=message) as told:
        write_ktx2(tmp_path / path, levels, srgb=srgb)
    assert "\n" not in str(told.value)
    assert not any(tmp_path.iterdir())


def test_an_unknown_gpu_format_gets_one_clear_line():
    with pytest.raises(TilewrightError, match="format is 'RGB8'; allowed are R8, RG8"):
        gpu_bytes(good, "RGB8")
