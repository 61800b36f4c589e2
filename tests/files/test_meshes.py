"""Meshes are read as they are, from every kind of file; what is damaged is told in one line."""

import json
import struct
from contextlib import suppress

import numpy as np
import pytest

import tilewright as tw
from meshes import cube, mixed, square
from tilewright.cli.main import run
from tilewright.errors import TilewrightFileError, TilewrightWarning
from tilewright.sameness import same


def as_obj(mesh):
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in mesh.vertices.tolist()]
    lines += [f"f {' '.join(str(v + 1) for v in face)}" for face in mesh.faces]
    return "\n".join(lines).encode() + b"\n"


def as_off(mesh):
    lines = ["OFF", f"{len(mesh.vertices)} {len(mesh)} 0"]
    lines += [" ".join(map(repr, place)) for place in mesh.vertices.tolist()]
    lines += [f"{len(face)} {' '.join(map(str, face))}" for face in mesh.faces]
    return "\n".join(lines).encode() + b"\n"


def as_ply(mesh, kind="ascii", counted="uchar", extra=False):
    head = ["ply", f"format {kind} 1.0", f"element vertex {len(mesh.vertices)}"]
    head += [f"property double {axis}" for axis in "xyz"] + ["property float quality"] * extra
    head += [f"element face {len(mesh)}", f"property list {counted} int vertex_indices", "end_header"]
    if kind == "ascii":
        body = [" ".join(map(repr, [*place, *([0.5] * extra)])) for place in mesh.vertices.tolist()]
        body += [f"{len(face)} {' '.join(map(str, face))}" for face in mesh.faces]
        return "\n".join([*head, *body, ""]).encode()
    mark = "<" if "little" in kind else ">"
    code = {"uchar": "B", "uint": "I"}[counted]
    data = b"".join(
        struct.pack(f"{mark}3d" + "f" * extra, *place, *([0.5] * extra)) for place in mesh.vertices
    )
    data += b"".join(struct.pack(f"{mark}{code}{len(f)}i", len(f), *f) for f in mesh.faces)
    return "\n".join([*head, ""]).encode() + data


KINDS = {
    "obj": as_obj,
    "off": as_off,
    "ascii.ply": as_ply,
    "little.ply": lambda mesh: as_ply(mesh, "binary_little_endian"),
    "big.ply": lambda mesh: as_ply(mesh, "binary_big_endian", "uint"),
}


@pytest.mark.parametrize("mesh", [cube(), mixed(), square(3)], ids=["cube", "mixed", "square"])
@pytest.mark.parametrize("kind", KINDS)
def test_what_was_written_is_read(tmp_path, kind, mesh):
    path = tmp_path / f"mesh.{kind}"
    path.write_bytes(KINDS[kind](mesh))
    assert tw.read_mesh(path) == mesh


@pytest.mark.parametrize("kind", KINDS)
def test_a_file_that_ends_early_is_told(tmp_path, kind):
    """Wherever it is cut; an OBJ file does not say how long it is, but never gives a face it has not."""
    whole, path = KINDS[kind](mixed()), tmp_path / f"mesh.{kind}"
    path.write_bytes(whole)
    number = len(tw.read_mesh(path))
    for length in range(0, len(whole) - 1, 7):
        path.write_bytes(whole[:length])
        if kind == "obj":
            with suppress(TilewrightFileError):
                assert len(tw.read_mesh(path)) <= number
            continue
        if kind in ("off", "ascii.ply") and length > len(whole) - 4:
            continue  # within the last number
        with pytest.raises(TilewrightFileError, match=r"mesh\."):
            tw.read_mesh(path)


def test_obj_as_it_is_found(tmp_path):
    path = tmp_path / "found.obj"
    path.write_bytes(
        b"# made by hand\r\nmtllib a.mtl\r\nv 0 0 0 1 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 \\\r\n0\r\n"
        b"vt 0 0\r\nvt 1 0 0\r\nvt 1 1\r\nvt 0 1\r\nvn 0 0 1\r\ng one\r\nusemtl red\r\ns 1\r\n"
        b"f -4/1/1 -3/2/1 -2/3/1 4/4/1 # all\r\nl 1 2\r\n"
    )
    with pytest.warns(TilewrightWarning, match="1 line"):
        mesh = tw.read_mesh(path)
    assert mesh.faces[0].tolist() == [0, 1, 2, 3]
    assert mesh.texcoords.tolist() == [[0, 0], [1, 0], [1, 1], [0, 1]]
    path.write_bytes(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1//1 2//1 3//1\n")
    assert tw.read_mesh(path).texcoords is None


@pytest.mark.parametrize(
    ("name", "data", "words"),
    [
        ("a.obj", b"v 0 0 0\nf 1 2 3\n", "names vertex 2; there are 1"),
        ("a.obj", b"v 0 0 0\nf 1 0 1\n", "line 2"),
        ("a.obj", b"v 0 0\nf 1 1 1\n", "fewer than 3 numbers"),
        ("a.obj", b"v 0 x 0\n", "line 1"),
        ("a.obj", b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "finite"),
        ("a.obj", b"v 0 0 0\nv 1 0 0\nf 1 2\n", "2 corners"),
        ("a.obj", b"v 0 0 0\n", "no faces"),
        ("a.obj", b"", "is empty"),
        ("a.obj", bytes(range(256)) * 8, "is no text"),
        ("a.off", b"OFF 1000000000000 5 0\n", "ends before"),
        ("a.off", b"PFF 3 1 0", "not with OFF"),
        ("a.off", b"OFF BINARY\n", "in binary"),
        ("a.off", b"OFF 3 1 0  0 0 0 1 0 0 0 1 0  3 0 1 5", "names vertex 5"),
        ("a.ply", b"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
         b"property float z\nend_header\n0 0 0\n", "points and no faces"),
        ("a.ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 9000000000000000000\n"
         b"property float x\nend_header\n", "ends before"),
        ("a.ply", b"ply\nformat ascii 1.0\nelement face 1\nproperty list half int vertex_index\nend_header\n",
         "list half int"),
        ("a.ply", b"PK\x03\x04", "does not begin as a PLY"),
        ("a", b"solid", "no suffix that says what it is; .obj, .off, .ply"),
    ],
)  # fmt: skip
def test_what_is_no_mesh_is_told_in_one_line(tmp_path, name, data, words):
    path = tmp_path / name
    path.write_bytes(data)
    with pytest.raises(TilewrightFileError, match=words) as told:
        tw.read_mesh(path)
    assert "\n" not in str(told.value)
    assert name in str(told.value)
    with pytest.raises(TilewrightFileError, match="is not a file"):
        tw.read_mesh(tmp_path / "none.obj")
    (tmp_path / "folder.ply").mkdir()
    with pytest.raises(TilewrightFileError, match="is a folder"):
        tw.read_mesh(tmp_path / "folder.ply")


def test_further_properties_are_passed_over(tmp_path):
    path = tmp_path / "more.ply"
    path.write_bytes(as_ply(cube(), "binary_little_endian", extra=True))
    assert tw.read_mesh(path) == cube()
    text = as_ply(cube()).replace(
        b"property double z\n", b"property double z\nproperty float s\nproperty float t\n"
    )
    head, _, body = text.partition(b"end_header\n")
    rows = body.splitlines()
    rows[:8] = [row + b" 0.25 0.5" for row in rows[:8]]
    path.write_bytes(head + b"end_header\n" + b"\n".join(rows))
    assert tw.read_mesh(path).texcoords.tolist() == [[0.25, 0.5]] * 24


@pytest.mark.parametrize("suffix", ["npy", "ply", "csv", "parquet", "usda"])
def test_points_are_written_and_say_how_they_were_made(tmp_path, suffix):
    points = tw.surface_points(cube(), 300, seed=4)
    path = tmp_path / f"points.{suffix}"
    tw.write_surface_points(path, points)
    first = path.read_bytes()
    tw.write_surface_points(path, points)
    assert path.read_bytes() == first
    columns = points.columns()
    if suffix == "npy":
        assert np.array_equal(np.load(path), points.positions)
    elif suffix == "csv":
        table = np.genfromtxt(path, delimiter=",", names=True)
        assert list(table.dtype.names) == list(columns)
        assert all(
            np.array_equal(table[name].astype(values.dtype), values) for name, values in columns.items()
        )
    elif suffix == "parquet":
        pyarrow = pytest.importorskip("pyarrow.parquet")
        table = pyarrow.read_table(path)
        assert all(same(table[name].to_numpy(), values) for name, values in columns.items())
        assert json.loads(table.schema.metadata[b"points of a surface"])["seed"] == 4
    elif suffix == "ply":
        assert len(tw.read_points(path)) == 300
        head, _, body = first.partition(b"end_header\n")
        assert b'"seed": 4' in head
        assert len(body) == 300 * (9 * 8 + 5 * 4 + 4 - 4 + 4 - 3)
    else:
        assert first.startswith(b"#usda 1.0\n")
        assert first.count(b"(") - first.count(b"\\(") > 600
    with pytest.raises(TilewrightFileError, match=r"use \.npy"):
        tw.write_surface_points(tmp_path / "a.xyz", points)
    with pytest.raises(tw.TilewrightError, match="points of a surface"):
        tw.write_surface_points(path, np.zeros((3, 3)))


def call(*arguments):
    with pytest.raises(SystemExit) as ended:
        run([str(a) for a in arguments])
    return ended.value.code


def test_the_command_writes_what_the_library_does(tmp_path, capsys):
    (tmp_path / "cube.obj").write_bytes(as_obj(cube()))
    mesh, out = tmp_path / "cube.obj", tmp_path / "out" / "points.npy"
    assert call("surface", mesh, "--count", "2e2", "--seed", 3, "-o", out, "--json") == 0
    told = json.loads(capsys.readouterr().out)
    assert np.array_equal(np.load(out), tw.surface_points(mesh, 200, seed=3).positions)
    assert told["count"] == 200
    assert told["pairs_left"] == 0
    assert call("surface", mesh, "--count", 5, "-o", out) == 2  # is there already
    assert call("surface", mesh, "-o", out, "--force") == 2
    assert "--count" in capsys.readouterr().err
    assert call("surface", mesh, "--count", 5, "-o", tmp_path / "a.xyz") == 2
    assert call("surface", tmp_path / "none.obj", "--count", 5, "-o", tmp_path / "a.npy") == 2
    assert "is not a file" in capsys.readouterr().err
    assert sorted(p.name for p in tmp_path.iterdir()) == ["cube.obj", "out"]
    assert call("surface", mesh, "--count", 5, "-o", tmp_path / "b.npy", "--dry-run") == 0
    assert not (tmp_path / "b.npy").exists()


def test_a_density_by_a_property_of_the_mesh_or_by_a_picture(tmp_path, capsys):
    """On a square whose east is three times as dense as its west."""
    flat, out = square(4), tmp_path / "points.npy"
    east = flat.vertices[:, 0] > flat.vertices[:, 0].mean()
    text = as_ply(flat, extra=True).decode().split("end_header\n")
    rows = text[1].splitlines()
    rows[: len(east)] = [row[:-3] + ("3" if e else "1") for row, e in zip(rows, east, strict=False)]
    mesh = tmp_path / "square.ply"
    mesh.write_bytes((text[0] + "end_header\n" + "\n".join(rows)).encode())
    assert call("surface", mesh, "--count", 400, "--density", "quality", "-o", out, "-q") == 0
    weights = np.where(east, 3.0, 1.0)
    assert np.array_equal(np.load(out), tw.surface_points(flat, 400, density=weights).positions)
    assert call("surface", mesh, "--count", 400, "--density", "worth", "-o", tmp_path / "a.npy") == 2
    assert "holds no property 'worth'; it holds x, y, z, quality" in capsys.readouterr().err

    low, high = flat.vertices[:, :2].min(axis=0), flat.vertices[:, :2].max(axis=0)
    coords = (flat.vertices[:, :2] - low) / (high - low)
    obj = as_obj(flat).decode() + "".join(f"vt {u!r} {v!r}\n" for u, v in coords.tolist())
    obj = "\n".join(
        "f " + " ".join(f"{w}/{w}" for w in line[2:].split()) if line.startswith("f ") else line
        for line in obj.splitlines()
    )
    (tmp_path / "square.obj").write_text(obj)
    picture = np.full((8, 16, 4), 255, np.uint8)
    picture[:, :8, :3] = 85
    tw.write_image(tmp_path / "density.png", picture)
    mesh = tmp_path / "square.obj"
    told = ("--density", tmp_path / "density.png", "-o", out, "--force", "-q")
    assert call("surface", mesh, "--count", 400, *told) == 0
    share = (np.load(out)[:, 0] > (low + high)[0] / 2).mean()
    assert 0.7 < share < 0.8
    assert call("surface", mesh, "--count", 9, "--density", "no.png", "-o", tmp_path / "a.npy") == 2
    assert "only .ply name properties; no.png is no picture file either" in capsys.readouterr().err


def test_usd_promises_no_width_where_there_is_no_least_distance(tmp_path):
    for kind in ("even", "tiles"):
        points, path = tw.surface_points(square(2), 60, kind=kind), tmp_path / f"{kind}.usda"
        tw.write_surface_points(path, points)
        assert (b"widths" in path.read_bytes()) == (points.distance > 0)
