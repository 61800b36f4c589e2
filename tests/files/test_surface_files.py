"""Points of surfaces in files, and the command that writes them."""

import json

import numpy as np
import pytest

import tilewright as tw
from meshes import cube, square
from tilewright.cli.main import run
from tilewright.errors import TilewrightFileError, TilewrightWarning
from tilewright.sameness import same


def as_obj(mesh):
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in mesh.vertices.tolist()]
    lines += [f"f {' '.join(str(v + 1) for v in face)}" for face in mesh.faces]
    return "\n".join(lines).encode() + b"\n"


def as_ply(mesh):
    """As text, with a number of every vertex that no mesh has."""
    head = ["ply", "format ascii 1.0", f"element vertex {len(mesh.vertices)}"]
    head += [*(f"property double {axis}" for axis in "xyz"), "property float quality"]
    head += [f"element face {len(mesh)}", "property list uchar int vertex_indices", "end_header"]
    body = [" ".join(map(repr, [*place, 0.5])) for place in mesh.vertices.tolist()]
    body += [f"{len(face)} {' '.join(map(str, face))}" for face in mesh.faces]
    return "\n".join([*head, *body, ""]).encode()


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
        with pytest.warns(TilewrightWarning, match="z was left out"):
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
    text = as_ply(flat).decode().split("end_header\n")
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
