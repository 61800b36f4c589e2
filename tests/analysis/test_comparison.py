"""The comparison of methods: who takes part, what comes out, what is left out."""

import json

import pytest

import tilewright as tw
from tilewright.analysis import list_contenders
from tilewright.analysis.points import contenders as contenders
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
        tiled = contender.builds and name not in (
            "shade",
            "hiller 32",
            "template 8 24",
            "corner-relaxed 3 32",
        )
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
    found = tw.compare(["uniform", "dart 0.70", "hiller 32"], sets=2)
    rows = {row["method"]: row for row in found.rows}
    assert rows["uniform"]["rho"] < 0.1 < 0.7 <= rows["dart 0.70"]["rho"]
    assert rows["hiller 32"]["construction_seconds"] > 0
    assert rows["hiller 32"]["anisotropy_max"] > rows["dart 0.70"]["anisotropy_max"] + 10
    found.save(tmp_path / "out")
    assert found.table() == (tmp_path / "out" / "comparison.md").read_text()
    methods = json.loads((tmp_path / "out" / "comparison.json").read_text())["methods"]
    assert [m["method"] for m in methods] == list(rows)
    assert (tmp_path / "out" / "sheet-1.png").stat().st_size > 100_000
    found.save(tmp_path / "out")
    (tmp_path / "out" / "mine.txt").write_text("")
    with pytest.raises(TilewrightFileError, match="holds other things"):
        found.save(tmp_path / "out")


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
    assert json.loads(capsys.readouterr().out)["methods"][0]["method"] == "uniform"
    with pytest.raises(SystemExit):
        run(["compare", "--list"])
    assert "corner 4 32" in capsys.readouterr().out
