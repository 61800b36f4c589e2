"""Meshes that people bring: every way of writing them is read, and whatever is no mesh is one clear line."""

import time
import warnings

import numpy as np
import pytest

import tilewright as tw
from conftest import SHARED
from mesh_bytes import ALIKE, MIXED, VERTICES, obj, off, ply, stl
from tilewright.errors import TilewrightError, TilewrightFileError, TilewrightWarning
from tilewright.extras import MissingExtra

TWO_FORMS = {"faces alike": ALIKE, "faces of several sizes": MIXED}


def put(folder, name, data):
    path = folder / name
    path.write_bytes(data if isinstance(data, bytes) else data.encode())
    return path


def faces_of(mesh):
    return [tuple(face.tolist()) for face in mesh.faces]


def refused(path, words):
    with pytest.raises(TilewrightFileError) as caught:
        tw.read_mesh(path)
    told = str(caught.value)
    assert told.startswith(str(path)), told
    assert words in told, told
    assert "\n" not in told
    assert len(told) < len(str(path)) + 250


def read_or_refusal(path):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", TilewrightWarning)
        try:
            return tw.read_mesh(path)
        except TilewrightFileError as error:
            return str(error)


@pytest.mark.parametrize("faces", TWO_FORMS.values(), ids=TWO_FORMS)
@pytest.mark.parametrize("kind", ["obj", "off", "ply"])
def test_faces_keep_their_corners(tmp_path, kind, faces):
    mesh = tw.read_mesh(put(tmp_path, f"a.{kind}", {"obj": obj, "off": off, "ply": ply}[kind](faces)))
    assert faces_of(mesh) == faces
    np.testing.assert_array_equal(mesh.vertices, VERTICES)
    assert mesh.texcoords is None


@pytest.mark.parametrize("faces", TWO_FORMS.values(), ids=TWO_FORMS)
@pytest.mark.parametrize("order", ["<", ">", ""], ids=["little", "big", "ascii"])
@pytest.mark.parametrize("extra", [False, True], ids=["plain", "with more"])
def test_ply_of_all_orders(tmp_path, order, faces, extra):
    mesh = tw.read_mesh(put(tmp_path, "a.ply", ply(faces, order=order, extra=extra)))
    assert faces_of(mesh) == faces
    np.testing.assert_array_equal(mesh.vertices, VERTICES)


@pytest.mark.parametrize("length", ["char", "uchar", "short", "ushort", "int", "uint"])
@pytest.mark.parametrize("index", ["uchar", "short", "uint"])
def test_ply_of_all_kinds_of_lists(tmp_path, length, index):
    data = ply(MIXED, order=">", length=length, index=index, name="vertex_index")
    assert faces_of(tw.read_mesh(put(tmp_path, "a.ply", data))) == MIXED


def test_ply_heads_end_as_on_any_system(tmp_path):
    head, _, body = ply(MIXED).partition(b"end_header\n")
    for ends in (b"\r\n", b"\r"):
        data = head.replace(b"\n", ends) + b"end_header" + ends + body
        assert faces_of(tw.read_mesh(put(tmp_path, "a.ply", data))) == MIXED


def test_ply_texture_coordinates_of_vertices_and_of_faces(tmp_path):
    head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    of_face = head + (
        "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
        "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 .25 0 .5 0 .75 1\n"
    )
    mesh = tw.read_mesh(put(tmp_path, "a.ply", of_face))
    np.testing.assert_array_equal(mesh.texcoords, [(0.25, 0), (0.5, 0), (0.75, 1)])
    lists = "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
    for s, t in (("s", "t"), ("u", "v"), ("texture_u", "texture_v")):
        of_vertex = head + f"property float {s}\nproperty float {t}\n" + lists
        of_vertex += "0 0 0 .25 0\n1 0 0 .5 0\n0 1 0 .75 1\n3 2 1 0\n"
        mesh = tw.read_mesh(put(tmp_path, "a.ply", of_vertex))
        np.testing.assert_array_equal(mesh.texcoords, [(0.75, 1), (0.5, 0), (0.25, 0)])


OBJ_FACES = {
    "numbers": "f 1 2 3 4\nf 4 3 5",
    "texture": "vt 0 0\nvt 1 0\nf 1/1 2/2 3/1 4/2\nf 4/1 3/2 5/1",
    "normals": "vn 0 0 1\nf 1//1 2//1 3//1 4//1\nf 4//1 3//1 5//1",
    "both": "vt 0 0\nvt 1 0\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1 4/2/1\nf 4/1/1 3/2/1 5/1/1",
    "mixed": "vn 0 0 1\nf 1//1 2 3//1 4\nf 4 3//1 5",
    "backwards": "f -6 -5 -4 -3\nv 9 9 9\nf -4 -5 -3",
    "continued": "f 1 2 \\\n3 4\nf 4 3 \\\n 5",
    "tabs and remarks": "  f\t1 2\t3 4 # four\n\n# f 1 2 5\nf 4 3 5 ",
}


@pytest.mark.parametrize("text", OBJ_FACES.values(), ids=OBJ_FACES)
@pytest.mark.parametrize("ends", ["\n", "\r\n"], ids=["unix", "windows"])
def test_obj_faces_of_all_forms(tmp_path, text, ends):
    vertices = "\n".join(f"v {x} {y} {z} 0.5 0.25 1" for x, y, z in VERTICES)
    mesh = tw.read_mesh(put(tmp_path, "a.obj", f"# made by hand\n{vertices}\n{text}\n".replace("\n", ends)))
    assert faces_of(mesh) == [(0, 1, 2, 3), (3, 2, 4)]
    np.testing.assert_array_equal(mesh.vertices[:6], VERTICES)
    assert (mesh.texcoords is not None) == ("vt" in text)
    if mesh.texcoords is not None:
        np.testing.assert_array_equal(mesh.texcoords[:, 0], [0, 1, 0, 1, 0, 1, 0])


def test_obj_texture_coordinates_count_backwards_too(tmp_path):
    text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt .1\nvt .2 1\nvt .3 1 7\nf -3/-3 -2/-2 -1/-1\nvt 9 9\n"
    np.testing.assert_array_equal(
        tw.read_mesh(put(tmp_path, "a.obj", text)).texcoords, [(0.1, 0), (0.2, 1), (0.3, 1)]
    )


def test_what_a_file_states_besides_is_told_once(tmp_path):
    more = b"l 1 2\nl 2 3\np 4\ng a\ng b\nusemtl one\nusemtl two\no x\ns off\nvn 0 0 1\nshine 3\n"
    with pytest.warns(TilewrightWarning, match="2 lines; 1 free point; 2 groups; 2 materials; 1 line"):
        tw.read_mesh(put(tmp_path, "a.obj", obj() + more))
    usual = b"mtllib a.mtl\no Cube\ng Cube\nusemtl Gray\ns 1\nvn 0 0 1\n"
    tw.read_mesh(put(tmp_path, "b.obj", usual + obj()))
    half = b"vt 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/1 3/1\nf 1 3 2\n"
    with pytest.warns(TilewrightWarning, match="texture coordinates, which some of its faces lack"):
        assert tw.read_mesh(put(tmp_path, "c.obj", half)).texcoords is None
    with pytest.warns(TilewrightWarning, match="1 line after the last face"):
        tw.read_mesh(put(tmp_path, "d.off", off() + b"3 0 1 2\n"))
    edge = ply(order="").replace(b"end_header", b"element edge 1\nproperty int vertex1\nend_header") + b"0\n"
    with pytest.warns(TilewrightWarning, match="1 edge"):
        tw.read_mesh(put(tmp_path, "e.ply", edge))
    with pytest.warns(TilewrightWarning, match="what follows its last element"):
        tw.read_mesh(put(tmp_path, "f.ply", ply() + b"\0"))


OFF_HEADS = {
    "next line": "OFF\n{} {} 0", "same line": "OFF {} {} 0", "no edges": "OFF\n{} {}", "none": "{} {} 0",
    "remarks": "# made\nOFF # yes\n\n# counts\n{} {} 0 # of all",
}  # fmt: skip


@pytest.mark.parametrize("head", OFF_HEADS.values(), ids=OFF_HEADS)
def test_off_heads(tmp_path, head):
    assert faces_of(tw.read_mesh(put(tmp_path, "a.off", off(head=head)))) == MIXED


def test_off_without_lines(tmp_path):
    for data in (off(), off(ALIKE, head="OFF {} {} 0")):
        mesh = tw.read_mesh(put(tmp_path, "a.off", data.replace(b"\n", b"  ")))
        assert mesh == tw.read_mesh(put(tmp_path, "b.off", data))
        refused(put(tmp_path, "c.off", data.replace(b"\n", b" ")[:-4]), "ends before the last of 6 vertices")


def test_off_with_more_in_each_line(tmp_path):
    rows = [(*v, 0, 0, 1, 255, 0, 0, 255, k / 8, 1) for k, v in enumerate(VERTICES)]
    data = off([(*face,) for face in MIXED], rows, "STCNOFF\n{} {} 0").replace(
        b"4 0 1 2 3", b"4 0 1 2 3 0.5 1 0"
    )
    mesh = tw.read_mesh(put(tmp_path, "a.off", data))
    assert faces_of(mesh) == MIXED
    np.testing.assert_array_equal(mesh.vertices, VERTICES)
    np.testing.assert_array_equal(mesh.texcoords[:, 0], np.concatenate(MIXED) / 8)
    for word in ("COFF", "NOFF", "CNOFF"):
        data = off(MIXED, [(*v, 9, 9, 9, 9) for v in VERTICES], word + "\n{} {} 0")
        np.testing.assert_array_equal(tw.read_mesh(put(tmp_path, "b.off", data)).vertices, VERTICES)


BAD = {
    "empty.obj": (b"", "is empty"),
    "nothing.off": (b"\n# nothing\n", "holds no numbers"),
    "text.obj": (b"Dear Sir,\nplease find\n", "holds no vertices and faces as an OBJ file does"),
    "text.off": (b"Dear Sir,\n", "begins with 'Dear', not with OFF"),
    "text.ply": (b"Dear Sir,\n", "does not begin as a PLY file does"),
    "picture.obj": (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "is no text"),
    "picture.off": (b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", "is no text"),
    "points.obj": (b"v 0 0 0\nv 1 0 0\n", "holds 2 vertices and no faces"),
    "points.off": (off([]), "holds 6 vertices and no faces"),
    "points.ply": (ply([]), "holds 6 points and no faces; read_points reads them"),
    "nan.obj": (obj().replace(b"0.25", b"nan"), "vertices[4] is at [0.5, 2.0, nan]"),
    "nan.off": (off().replace(b"0.25", b"nan"), "vertices[4] is at [0.5, 2.0, nan]"),
    "nan.ply": (ply(order="").replace(b"0.25", b"nan"), "vertices[4] is at [0.5, 2.0, nan]"),
    "inf.ply": (ply(vertices=[*VERTICES[:5], (2, float("inf"), 0)]), "vertices[5] is at [2.0, inf, 0.0]"),
    "beyond.obj": (obj([(0, 1, 6)]), "line 7, 'f 1 2 7', names vertex 7; there are 6"),
    "zero.obj": (obj([(0, 1, 2), (-1, 1, 2)]), "line 8, 'f 0 2 3', names vertex 0; they count from 1"),
    "before.obj": (obj([(0, 1, -8)]), "line 7, 'f 1 2 -7', names vertex -7; there are 6"),
    "texture.obj": (b"vt 0 0\n" + obj([]) + b"f 4/1 3/2 5/1\n", "names texture coordinates 2; there are 1"),
    "beyond.off": (off([(0, 1, 6)]), "faces[0] names vertex 6; there are 6, numbered from 0"),
    "beyond.ply": (ply([(0, 1, 2), (0, 1, 99)]), "faces[1] names vertex 99; there are 6, numbered from 0"),
    "negative.ply": (ply([(0, 1, -2)]), "faces[0] names vertex -2"),
    "two.obj": (obj([(0, 1, 2), (0, 1)]), "faces[1] has 2 corners; a face has three or more"),
    "two.off": (off([(0, 1)]), "faces[0] has 2 corners"),
    "two.ply": (ply([(0, 1)]), "faces[0] has 2 corners"),
    "word.obj": (obj().replace(b"f 4 3 5", b"f 4 3 x"), "line 8, 'f 4 3 x', names corners by something else"),
    "word.off": (off().replace(b"3 3 2 4", b"3 3 2 x"), "something else than a whole number"),
    "word.ply": (ply(order="").replace(b"3 3 2 4", b"3 3 2 x"), "vertex_indices that are no whole numbers"),
    "huge.obj": (obj([(0, 1, 10**30)]), "names corners by something else"),
    "huge.off": (off([(0, 1, 10**30)]), "beyond 64 bits"),
    "huge.ply": (ply([(0, 1, 10**30)], order=""), "no whole numbers"),
    "short.obj": (b"v 0 0\n" + obj(), "line 1, 'v 0 0', has fewer than 3 numbers"),
    "short.off": (off().replace(b"0.5 2 0.25", b"0.5 2"), "vertex 4, '0.5 2', has too few numbers"),
    "lacks.off": (off().replace(b"3 3 2 4", b"3 3 2"), "face 1, '3 3 2', names other than the 3 corners"),
    "many vertices.off": (off(head="OFF 999999999999 {1} 0"), "last of 999999999999 vertices"),
    "many faces.off": (off(head="OFF {0} 999999999999 0"), "ends before the last of 999999999999 faces"),
    "binary.off": (b"OFF BINARY\n1 2 3", "binary"),
    "space.off": (b"4OFF\n1 1 0\n", "is 4OFF, not of three dimensions"),
    "counts.off": (b"OFF\n6 x 0\n", "something else than a whole number for its counts"),
    "odd.ply": (b"ply\nformat ascii 1.0\nelement vertex -3\n", "has 'element vertex -3' in its header"),
    "kind.ply": (b"ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\n", "'property quad x'"),
    "format.ply": (b"ply\nelement vertex 3\nend_header\n", "does not say its format"),
    "nameless.ply": (ply(name="corners"), "faces without lists of vertex_indices"),
    "fractions.ply": (ply(index="float"), "names vertices by float32, not by whole numbers"),
    "flat.ply": (ply().replace(b"float z", b"float w"), "has vertices without x, y and z"),
    "strips.ply": (
        ply([]).replace(b"element face 0", b"element tristrips 1") + b"\3" + bytes(12), "triangle strips"
    ),
    "nothing": (b"x", "has no suffix that says what it is; .obj, .off, .ply, .stl"),
}  # fmt: skip


@pytest.mark.parametrize("name", BAD)
def test_what_is_no_mesh_is_one_line(tmp_path, name):
    data, words = BAD[name]
    refused(put(tmp_path, name, data), words)


@pytest.mark.parametrize("order", ["<", ">", ""])
@pytest.mark.parametrize("element", [b"vertex 6", b"face 3"])
def test_counts_beyond_the_file_take_no_memory(tmp_path, order, element):
    data = ply(order=order, extra=True)
    many = data.replace(b"element " + element, b"element " + element.split()[0] + b" 999999999999")
    refused(put(tmp_path, "a.ply", many), "ends before the last of 999999999999")


def test_lists_of_no_length(tmp_path):
    data = bytearray(ply(ALIKE, length="char", index="char"))
    data[-4] = 0x80
    refused(put(tmp_path, "a.ply", bytes(data)), "has a list of -128 numbers among its faces")
    data = ply(ALIKE, length="uint", index="char").replace(b"\3\0\0\0\0\1\2", b"\xff\xff\xff\xff\0\1\2")
    refused(put(tmp_path, "b.ply", data), "ends before the last of 3 faces")


PREFIXES = {
    "mixed.off": off(), "alike.off": off(ALIKE), "mixed.ply": ply(), "alike.ply": ply(ALIKE, order=">"),
    "ascii.ply": ply(order=""), "more.ply": ply(extra=True), "a.obj": obj(),
}  # fmt: skip


@pytest.mark.parametrize("name", PREFIXES)
def test_a_truncated_file_is_refused_or_as_long_as_the_whole(tmp_path, name):
    data = PREFIXES[name]
    whole = tw.read_mesh(put(tmp_path, name, data))
    for end in range(len(data)):
        path = put(tmp_path, name, data[:end])
        found = read_or_refusal(path)
        if isinstance(found, str):
            assert found.startswith(str(path))
        else:
            assert name not in ("mixed.ply", "alike.ply", "more.ply"), (
                "a binary file that ends early was read"
            )
            counts = (len(found), len(found.vertices))
            assert name.endswith(".obj") or counts == (len(whole), len(whole.vertices))


def test_noise_is_never_read_nor_a_traceback(tmp_path):
    rng = np.random.default_rng(3)
    for kind, data in (("obj", obj()), ("off", off()), ("ply", ply(extra=True)), ("ply", ply(order=""))):
        for _ in range(60):
            spoiled = np.frombuffer(data, np.uint8).copy()
            at = rng.integers(0, len(data), 3)
            spoiled[at] = rng.integers(0, 256, 3)
            found = read_or_refusal(put(tmp_path, f"a.{kind}", spoiled.tobytes()))
            assert "damaged or not what its name says" not in str(found)


def test_names_that_lead_nowhere(tmp_path):
    refused(tmp_path / "none.obj", "is not a file")
    refused(tmp_path, "is a folder; a mesh file is expected")
    with pytest.raises(TilewrightError, match="path must be a str or a Path, not int"):
        tw.read_mesh(7)


def test_other_kinds_need_trimesh_before_they_are_read(tmp_path, monkeypatch):
    monkeypatch.setitem(__import__("sys").modules, "trimesh", None)
    with pytest.raises(
        MissingExtra, match=r'a .glb mesh needs the package trimesh; .*"tilewright\[meshes\]"'
    ):
        tw.read_mesh(put(tmp_path, "a.glb", b"x"))


def test_stl_through_trimesh(tmp_path):
    pytest.importorskip("trimesh")
    data = stl()
    mesh = tw.read_mesh(put(tmp_path, "a.stl", data))
    assert len(mesh) == 3
    assert len(mesh.vertices) == len(VERTICES), "equal places are one vertex"
    np.testing.assert_array_equal(mesh.vertices[mesh.corners], np.array(VERTICES)[np.concatenate(ALIKE)])
    for end in range(1, len(data), 7):
        refused(put(tmp_path, "b.stl", data[:end]), "")


def test_a_scene_through_trimesh_is_joined_and_told(tmp_path):
    trimesh = pytest.importorskip("trimesh")
    one = trimesh.Trimesh(VERTICES, ALIKE, process=False)
    scene = trimesh.Scene()
    scene.add_geometry(one)
    scene.add_geometry(one, transform=np.diag([-1.0, 1, 1, 1]))
    scene.export(tmp_path / "a.glb")
    with pytest.warns(TilewrightWarning, match="2 geometries"):
        mesh = tw.read_mesh(tmp_path / "a.glb")
    assert len(mesh) == 6
    normals = np.cross(*(np.diff(mesh.vertices[np.stack(mesh.faces)], axis=1).transpose(1, 0, 2)))
    np.testing.assert_allclose(normals[3:] * [-1, 1, 1], normals[:3], atol=1e-6)
    refused(put(tmp_path, "b.glb", (tmp_path / "a.glb").read_bytes()[:200]), "")
    refused(put(tmp_path, "a.docx", b"x"), "is not a mesh that can be read here")


@pytest.mark.skipif(not (SHARED / "data" / "meshes").is_dir(), reason="needs the shared meshes")
def test_shared_meshes_are_read_whole():
    expected = {
        "bunny_quads_1878.obj": (1880, 1878),
        "spot_control_mesh.obj": (188, 180),
        "bunny_tri_17804.off": (8904, 17804),
    }
    for name, counts in expected.items():
        mesh = tw.read_mesh(SHARED / "data" / "meshes" / name)
        assert (len(mesh.vertices), len(mesh)) == counts


def test_large_files_take_no_long_time(tmp_path):
    """71,000 triangles: a second for OBJ and a tenth for binary PLY, with room for slow machines."""
    rng = np.random.default_rng(1)
    vertices, faces = rng.random((35_600, 3)), rng.integers(0, 35_600, (71_200, 3))
    lines = [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in vertices]
    lines += ["vt 0 1"] * 100 + [f"f {a + 1}/{a % 100 + 1}/1 {b + 1}/7/1 {c + 1}/9/1" for a, b, c in faces]
    path = put(tmp_path, "a.obj", "\n".join(lines))
    began = time.process_time()
    assert len(tw.read_mesh(path)) == 71_200
    assert time.process_time() - began < 2
    head = (
        "ply\nformat binary_little_endian 1.0\nelement vertex 35600\nproperty double x\nproperty double y\n"
        "property double z\nelement face 71200\nproperty list uchar int vertex_indices\nend_header\n"
    )
    rows = np.zeros(71_200, [("n", "u1"), ("c", "<i4", 3)])
    rows["n"], rows["c"] = 3, faces
    path = put(tmp_path, "a.ply", head.encode() + vertices.tobytes() + rows.tobytes())
    began = time.process_time()
    assert len(tw.read_mesh(path)) == 71_200
    assert time.process_time() - began < 0.3
