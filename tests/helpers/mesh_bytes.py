"""Small meshes as files of all kinds, written plainly."""

import struct

import numpy as np

VERTICES = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 2, 0.25), (2, 0.5, -1)]
MIXED = [(0, 1, 2, 3), (3, 2, 4), (1, 5, 2)]
ALIKE = [(0, 1, 2), (3, 2, 4), (1, 5, 2)]
CODES = {
    "char": "b",
    "uchar": "B",
    "short": "h",
    "ushort": "H",
    "int": "i",
    "uint": "I",
    "float": "f",
    "double": "d",
}


def obj(faces=MIXED, vertices=VERTICES):
    rows = [f"v {' '.join(map(str, v))}" for v in vertices]
    rows += [f"f {' '.join(str(c + 1) for c in face)}" for face in faces]
    return ("\n".join(rows) + "\n").encode()


def off(faces=MIXED, vertices=VERTICES, head="OFF\n{} {} 0"):
    rows = [head.format(len(vertices), len(faces))]
    rows += [" ".join(map(str, v)) for v in vertices]
    rows += [" ".join(map(str, (len(face), *face))) for face in faces]
    return ("\n".join(rows) + "\n").encode()


def ply(
    faces=MIXED, vertices=VERTICES, order="<", length="uchar", index="int", name="vertex_indices", extra=False
):
    """A PLY file; ``extra`` adds properties before and behind those that count, and an element between."""
    kind = {"<": "binary_little_endian", ">": "binary_big_endian", "": "ascii"}[order]
    lines = ["ply", f"format {kind} 1.0", "comment made by hand", f"element vertex {len(vertices)}"]
    lines += ["property uchar red"] * extra + [f"property float {axis}" for axis in "xyz"]
    lines += ["property double quality"] * extra
    lines += ["element noise 2", "property list uchar short few", "property char one"] * extra
    lines += [f"element face {len(faces)}"]
    lines += ["property float weight"] * extra + [f"property list {length} {index} {name}"]
    lines += ["property list uint double bag"] * extra
    body = []
    for v in vertices:
        body.append([*([("B", 7)] * extra), *(("f", c) for c in v), *([("d", 0.5)] * extra)])
    if extra:
        body += [[("B", 2), ("h", 5), ("h", -5), ("b", 1)], [("B", 0), ("b", 3)]]
    for k, face in enumerate(faces):
        row = [(CODES[length], len(face)), *((CODES[index], c) for c in face)]
        body.append([*([("f", 1.5)] * extra), *row, *([("I", k), *[("d", 0.25)] * k] * extra)])
    head = ("\n".join([*lines, "end_header"]) + "\n").encode()
    if not order:
        return head + "".join(" ".join(str(v) for _, v in row) + "\n" for row in body).encode()
    return head + b"".join(struct.pack(order + code, value) for row in body for code, value in row)


def stl(triangles=ALIKE, vertices=VERTICES):
    body = b"".join(
        struct.pack("<3f", 0, 0, 0) + np.asarray([vertices[c] for c in face], "<f4").tobytes() + b"\0\0"
        for face in triangles
    )
    return b"made by hand".ljust(80) + struct.pack("<I", len(triangles)) + body
