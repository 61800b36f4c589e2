"""NPZ files that are damaged, or made to fill the memory: one clear line, from every reader."""

import json
import struct
import zipfile
import zlib

import numpy as np
import pytest

import tilewright as tw
from tilewright.errors import TilewrightFileError
from tilewright.files.archives import read_archive
from tilewright.files.tables import read_arrays


def damaged(path, how):
    """A point file whose member is spoilt in one way."""
    if how == "lzma":
        with zipfile.ZipFile(path, "w", zipfile.ZIP_LZMA) as archive:
            archive.writestr("points.npy", bytes(2000))
    else:
        np.savez_compressed(path, points=np.random.default_rng(1).random((400, 2)))
    data = bytearray(path.read_bytes())
    local, central = data.index(b"PK\x03\x04"), data.index(b"PK\x01\x02")
    if how == "encrypted":
        data[local + 6] |= 1
        data[central + 8] |= 1
    elif how == "method":
        data[local + 8 : local + 10] = data[central + 10 : central + 12] = struct.pack("<H", 97)
    else:
        start = local + 30 + sum(struct.unpack_from("<2H", data, local + 26))
        data[start + 4 : start + 40] = b"\xff" * 36
    path.write_bytes(data)


@pytest.mark.parametrize("how", ["deflate", "lzma", "encrypted", "method"])
def test_damage_is_one_line(tmp_path, how):
    path = tmp_path / "p.npz"
    damaged(path, how)
    for read in (
        lambda: read_archive(path, lambda names: names),
        lambda: read_arrays(path, ["points"], "points"),
        lambda: tw.read_points(path),
    ):
        with pytest.raises(TilewrightFileError) as refusal:
            read()
        assert "\n" not in str(refusal.value)


@pytest.mark.parametrize("how", ["deflate", "encrypted", "method"])
def test_damaged_point_tiles_with_a_right_checksum_are_one_line(tmp_path, how):
    import hashlib

    tw.save(tw.ready_tiles(3), tmp_path / "set")
    damaged(tmp_path / "set" / "points.npz", how)
    manifest = json.loads((tmp_path / "set" / "tileset.json").read_text())
    digest = hashlib.sha256((tmp_path / "set" / "points.npz").read_bytes()).hexdigest()
    old = manifest["checksums"]["points.npz"]
    manifest["checksums"]["points.npz"] = old[: len(old) - 64] + digest
    (tmp_path / "set" / "tileset.json").write_text(json.dumps(manifest))
    with pytest.raises(TilewrightFileError, match=r"damaged|does not hold"):
        tw.load(tmp_path / "set")


def test_an_archive_that_would_fill_the_memory_is_refused(tmp_path):
    path, size = tmp_path / "p.npz", 2**31
    packer, packed = zlib.compressobj(9, zlib.DEFLATED, -15), 0
    header = np.lib.format.magic(1, 0)
    with path.open("wb") as stream:
        stream.write(struct.pack("<4s5H3L2H", b"PK\x03\x04", 20, 0, 8, 0, 0, 0, 0, 0, 10, 0) + b"points.npy")
        body = packer.compress(header + bytes(2**20)) + packer.flush()
        stream.write(body)
        packed, at = len(body), stream.tell()
        stream.write(
            struct.pack(
                "<4s6H3L5H2L", b"PK\x01\x02", 20, 20, 0, 8, 0, 0, 0, packed, size, 10, 0, 0, 0, 0, 0, 0
            )
            + b"points.npy"
        )
        stream.write(struct.pack("<4s4H2LH", b"PK\x05\x06", 0, 0, 1, 1, 56, at, 0))
    for read in (lambda: tw.read_points(path), lambda: read_archive(path, lambda names: names)):
        with pytest.raises(TilewrightFileError, match="fill the memory"):
            read()


def test_many_members_are_told_briefly(tmp_path):
    np.savez(tmp_path / "p.npz", **{f"array_{k}": k for k in range(3000)})
    with pytest.raises(TilewrightFileError, match="expected an array called points") as refusal:
        tw.read_points(tmp_path / "p.npz")
    assert len(str(refusal.value)) < 400
