"""The comparison of methods: who takes part, what comes out, what is left out."""

import json
from math import nan

import pytest

import tilewright as tw
from tilewright.analysis import list_contenders
from tilewright.analysis.points import contenders as contenders
from tilewright.analysis.points.comparison import Comparison
from tilewright.cli.main import run
from tilewright.errors import TilewrightFileError, TilewrightValueError


@pytest.fixture
def small(monkeypatch):
    """The same comparison with fewer points."""
    from tilewright.analysis.points import comparison

    monkeypatch.setattr(comparison, "SPECTRUM_POINTS", 1024)
    monkeypatch.setattr(comparison, "PLATE_POINTS", 65536 + 4096)


def test_everyone_makes_about_as_many_points_as_asked():
    heavy = {"scipy", "bridson package", "best-candidate", "relaxation 0.999"}
    for name, contender in list_contenders().items():
        tiled = contender.builds and name not in ("shade", "corner-relaxed 3 32")
        if tiled or name in heavy:
            continue
        made = contender.prepare(1, None)(2000, 1)
        assert len(made) == pytest.approx(2000, rel=0.25), name
        made.box.check_points(made.points)


def test_every_sampler_and_kind_of_tiles_takes_part():
    from tilewright.samplers import METHODS
    from tilewright.signals.points import TILE_METHODS

    names = list_contenders()
    assert all(any(name.startswith(m) for name in names) for m in (*METHODS, *TILE_METHODS))


def test_peers_make_points_that_keep_their_distance():
    for contender in contenders._peers():
        made = contender.prepare(0, None)(300, 0)
        assert len(made) == pytest.approx(300, rel=0.25)
        assert made.rho > 0.65


def test_a_comparison_measures_and_saves(small, tmp_path):
    found = tw.compare(["uniform", "dart 0.70", "dart 0.75", "hiller 32"], sets=2)
    rows = {row["method"]: row for row in found.rows}
    assert rows["uniform"]["rho"] < 0.1 < 0.7 <= rows["dart 0.70"]["rho"]
    assert rows["hiller 32"]["construction_seconds"] > 0
    assert rows["hiller 32"]["anisotropy_max"] > rows["dart 0.70"]["anisotropy_max"] + 10
    found.save(tmp_path / "out")
    assert found.table() == (tmp_path / "out" / "comparison.md").read_text()
    methods = json.loads((tmp_path / "out" / "comparison.json").read_text())["methods"]
    assert [m["method"] for m in methods] == list(rows)
    said = json.loads((tmp_path / "out" / "comparison.json").read_text())["verdict"]
    assert said == found.verdict
    assert said[-1].startswith("For speed: ")
    assert (tmp_path / "out" / "sheet-1.png").stat().st_size > 100_000
    found.save(tmp_path / "out")
    (tmp_path / "out" / "mine.txt").write_text("")
    with pytest.raises(TilewrightFileError, match="holds other things"):
        found.save(tmp_path / "out")


def row(method, rho, milliseconds, spike, **more):
    return {"method": method, "rho": rho, "milliseconds": milliseconds, "largest_bin": spike, **more}


def test_the_best_of_each_column_is_marked_and_named():
    """Noise and lattices take no part, however low their figures are."""
    rows = [
        row("noise", 0.01, 0.1, 3.0, coverage=4.0),
        row("darts", 0.7, 12.0, 4.7, coverage=2.1, effective_nyquist=0.44, zone_plate_near=nan),
        row("even", 0.72, 300.0, 9.0, coverage=1.5, effective_nyquist=0.9),
        row("tiles", 0.75, 0.2, 28.0, coverage=2.0, construction_seconds=2.7, effective_nyquist=0.65),
        row("grid", 0.93, 0.1, 16384.0, coverage=1.3, effective_nyquist=1.0),
        {"method": "slow", "not_run": "it would take long"},
    ]
    found = Comparison(rows)
    table = found.table().splitlines()
    cells = {line.split(" | ")[0].strip("| "): line.split(" | ") for line in table[2:7]}
    assert [name for name, line in cells.items() if "**" in "".join(line)] == ["darts", "even", "tiles"]
    assert cells["tiles"][2] == "**0.2**"
    assert cells["tiles"][4] == "**0.75**"
    assert cells["even"][5] == "**1.5**"
    assert cells["darts"][7] == "**4.7**"
    assert found.verdict == [
        "For the cleanest low frequencies: even (effective Nyquist frequency 0.9 of a grid's).",
        "For the least lattice: darts (no frequency above 4.7 x white noise).",
        "For no holes: even (empty circles up to 1.5 r_max).",
        "For speed: tiles (0.2 ms for a set).",
        "For random access, any cell at once: tiles (tiles, with no frequency above 28 x white noise).",
    ]
    assert all(f"- {sentence}" in table for sentence in found.verdict)
    for head in table[0].strip("| ").split(" | "):
        assert sum(line.startswith(f"- {head}: ") for line in table) == 1
    assert Comparison(rows[:1]).verdict[0].startswith("None of these is blue noise")
    assert "**" not in Comparison(rows[1:2]).table().splitlines()[2]
    assert Comparison(rows[:2]).verdict == ["Only darts is blue noise; there is nothing to compare it to."]


def test_what_takes_too_long_is_listed_as_not_run(small, monkeypatch):
    slow = contenders.Contender("slow", "nobody", 100.0, lambda seed, progress: pytest.fail("was run"))
    monkeypatch.setattr("tilewright.analysis.points.comparison.list_contenders", lambda: {"slow": slow})
    found = tw.compare()
    assert "not run, 10 sets would take about 1000 s" in found.table()
    assert found.reports == []


def test_unknown_methods_and_bad_numbers_are_refused():
    with pytest.raises(TilewrightValueError, match="methods is 'magic'"):
        tw.compare(["magic"])
    with pytest.raises(TilewrightValueError, match="sets is 0"):
        tw.compare(["uniform"], sets=0)


def test_nothing_is_saved_where_nothing_ran(small, tmp_path):
    found = tw.compare(["uniform"], sets=1)
    found.save(tmp_path / "good")
    with pytest.raises(SystemExit) as end:
        run(["compare", "--methods", "uniform", "--seed", "-1", "-o", str(tmp_path / "good")])
    assert end.value.code == 2
    assert (tmp_path / "good" / "sheet-1.png").exists()


def test_a_comparison_can_be_stopped(small):
    def stop(done, total, what):
        if "spectrum" in what:
            raise tw.Cancelled("enough")

    with pytest.raises(tw.Cancelled):
        tw.compare(["uniform"], sets=1, progress=stop)


def test_compare_command(small, capsys):
    with pytest.raises(SystemExit) as end:
        run(["compare", "--methods", "uniform", "--sets", "2", "--json"])
    assert end.value.code == 0
    said = json.loads(capsys.readouterr().out)
    assert said["methods"][0]["method"] == "uniform"
    assert said["verdict"] == ["None of these is blue noise: none has a rho of 0.65 to 0.85."]
    with pytest.raises(SystemExit):
        run(["compare", "--list"])
    assert "corner 4 32" in capsys.readouterr().out
