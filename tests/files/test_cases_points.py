"""Points as other programs write them: files beside the checkout, where they are, and some made here."""

import re
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.distance import pdist

import tilewright as tw
from tilewright.errors import TilewrightFileError, TilewrightWarning

CASES = Path(__file__).parents[3] / "shared" / "cases" / "points"
POINTS = np.array([[51.5, 57.25], [12.0, 40.5], [33.75, 8.0], [71.0, 22.5]])
BOX = tw.Box((100, 60), torus=False)


@pytest.fixture
def case():
    """A file of the folder beside the checkout, or the test is skipped."""

    def find(name):
        if not (CASES / name).exists():
            pytest.skip(f"{name} is not at hand")
        return CASES / name

    return find


@pytest.mark.parametrize(
    "name", ["xy.csv", "id_X_Y.csv", "id_spaces.csv", "fid_semicolons.csv", "unnamed_index.csv"]
)
def test_columns_go_by_their_names(case, name):
    found = tw.read_points(case(name))
    assert len(found) == 150
    assert pdist(found.points).min() == pytest.approx(3.6556, abs=1e-4)


def test_two_rows_are_turned_with_a_note(case):
    with pytest.warns(TilewrightWarning, match="two rows of 150 numbers"):
        found = tw.read_points(case("two_rows.npy"))
    assert pdist(found.points).min() == pytest.approx(3.6556, abs=1e-4)


def rows(between, *more):
    """The points as text, and further columns before them."""
    return "".join(
        between.join([*(str(k) for _ in more), f"{x!r}", f"{y!r}"]) + "\n"
        for k, (x, y) in enumerate(POINTS.tolist())
    )


GERMAN = rows(";").replace(".", ",")
READ = {
    "header in capitals": "ID,X,Y\n" + rows(",", 1),
    "y before x": "Y,X\n" + "".join(f"{y},{x}\n" for x, y in POINTS.tolist()),
    "quoted": '"id","x","y"\n' + rows(",", 1),
    "longitude": "name,lat,lon\n" + "".join(f"a b,{y},{x}\n" for x, y in POINTS.tolist()),
    "easting": "Easting (m);Northing (m)\n" + rows(";"),
    "arcgis": "OBJECTID,POINT_X,POINT_Y\n" + rows(",", 1),
    "tabs": "id\tx\ty\n" + rows("\t", 1),
    "bars": "x|y\n" + rows("|"),
    "blanks": rows("   "),
    "byte-order mark": b"\xef\xbb\xbfx,y\n" + rows(",").encode(),
    "byte-order mark and no header": b"\xef\xbb\xbf" + rows(",").encode(),
    "utf-16 of a spreadsheet": ("x\ty\n" + rows("\t")).encode("utf-16"),
    "windows lines": ("x,y\n" + rows(",")).replace("\n", "\r\n"),
    "empty lines at the end": "x,y\n" + rows(",") + "\n\n",
    "no last line end": ("x,y\n" + rows(",")).rstrip("\n"),
    "decimal commas": "x;y\n" + GERMAN,
    "decimal commas between tabs": GERMAN.replace(";", "\t"),
    "decimal commas between blanks": GERMAN.replace(";", " "),
    "separator named": "sep=;\nx;y\n" + rows(";"),
    "remarks": "# made by hand\n# in meters\nx,y\n" + rows(","),
    "a remark is the header": "# id x y\n" + rows(" ", 1),
    "percent": "% x y\n" + rows(" "),
    "trailing separators": "x,y,\n" + rows(",").replace("\n", ",\n"),
    "row names of R": '"x","y"\n' + rows(",", 1),
    "texts in other columns": "x,note,y\n" + "".join(f'{x},"a, ä",{y}\n' for x, y in POINTS.tolist()),
}


@pytest.mark.parametrize("name", READ)
def test_texts_of_other_programs_are_read(tmp_path, name):
    text = READ[name]
    (tmp_path / "p.csv").write_bytes(text if isinstance(text, bytes) else text.encode())
    np.testing.assert_array_equal(tw.read_points(tmp_path / "p.csv", BOX).points, POINTS)


NOTED = {
    "unknown names": ("id,u,v\n" + rows(",", 1), "u and v were taken"),
    "rows are counted": (rows(",", 1), "counts the rows"),
}


@pytest.mark.parametrize("name", NOTED)
def test_what_is_guessed_is_said(tmp_path, name):
    text, message = NOTED[name]
    (tmp_path / "p.csv").write_text(text)
    with pytest.warns(TilewrightWarning, match=message):
        found = tw.read_points(tmp_path / "p.csv", BOX)
    np.testing.assert_array_equal(found.points, POINTS)


REFUSED = {
    "an empty cell": ("x,y\n0.5,0.25\n,0.75\n", "column x holds '' in row 2, not numbers"),
    "a word": ("id,x,y\n1,0.5,0.25\n2,0.5,NA\n", "column y holds 'NA' in row 2, not numbers"),
    "not a number": ("x,y\n0.5,0.25\n0.5,nan\n", r"point 1 is \(0.5, nan\)"),
    "an id alone": ("id,x\n", "no points"),
    "x alone": ("id,x,name\n1,0.5,a\n", "the columns id, x, name; points need x and y"),
    "remarks alone": ("# nothing\n", "holds no rows"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_read_is_one_line(tmp_path, name):
    text, message = REFUSED[name]
    (tmp_path / "p.csv").write_text(text)
    with pytest.raises(TilewrightFileError, match=message) as refusal:
        tw.read_points(tmp_path / "p.csv")
    assert "\n" not in str(refusal.value)


def test_three_numbers_of_two_points_are_not_turned(tmp_path):
    np.save(tmp_path / "p.npy", [[0.25, 0.5, 0], [0.75, 0.5, 0]])
    assert len(tw.read_points(tmp_path / "p.npy", tw.Box())) == 2


def test_arrays_with_named_fields(tmp_path):
    table = np.zeros(4, [("id", "i4"), ("X", "f4"), ("Y", "f4")])
    table["X"], table["Y"] = POINTS.T
    np.save(tmp_path / "p.npy", table)
    np.testing.assert_array_equal(tw.read_points(tmp_path / "p.npy", BOX).points, POINTS)
    np.savez(tmp_path / "p.npz", x=POINTS[:, 0], y=POINTS[:, 1], other=1)
    np.testing.assert_array_equal(tw.read_points(tmp_path / "p.npz", BOX).points, POINTS)


PLY = (
    "ply\nformat {} 1.0\ncomment by hand\nelement vertex 4\nproperty float {}\nproperty float {}\n"
    "{}end_header\n"
)
FACES = "element face 1\nproperty list uchar int vertex_indices\n"


def test_ply_of_other_programs(tmp_path):
    text = PLY.format("ascii", "x", "y", FACES) + rows(" ") + "3 0 1 2\n"
    (tmp_path / "a.ply").write_text(text)
    (tmp_path / "b.ply").write_bytes(
        PLY.format("binary_big_endian", "x", "y", FACES).encode() + POINTS.astype(">f4").tobytes() + b"\x03"
    )
    (tmp_path / "c.ply").write_bytes(
        PLY.format("binary_little_endian", "y", "x", "").replace("\n", "\r\n").encode()
        + POINTS[:, ::-1].astype("<f4").tobytes()
    )
    for name in "abc":
        np.testing.assert_array_equal(tw.read_points(tmp_path / f"{name}.ply", BOX).points, POINTS)


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "does not begin"),
        (PLY.format("ascii", "x", "y", "").encode() + b"1 2\n", "ends before"),
        (PLY.format("binary_little_endian", "x", "y", "").encode() + b"12", "ends before"),
        (
            PLY.format("ascii", "a", "b", "").replace("element vertex", "element face").encode(),
            "first element",
        ),
    ],
)
def test_damaged_ply_is_one_line(tmp_path, data, message):
    (tmp_path / "p.ply").write_bytes(data)
    with pytest.raises(TilewrightFileError, match=re.escape(message)):
        tw.read_points(tmp_path / "p.ply")
