"""What is said of ratios, and what is kept."""

from ratios import compare_ratios, read_ratios, store_ratios


def test_falls_by_more_than_a_third_and_new_names_are_told():
    stored = {"a": 0.9, "b": 0.9, "not run": 1.0}
    lines = compare_ratios(stored, {"a": 0.59, "b": 0.61, "c": 12.345})
    assert lines == ["a: fell from 0.9 to 0.59", "c: 12.3 is new; `make bench UPDATE=1` stores it"]


def test_ratios_that_did_not_run_stay(tmp_path):
    path = tmp_path / "ratios.json"
    store_ratios({"b": 2.0, "a": 0.12345}, path)
    store_ratios({"b": 3.0}, path)
    assert read_ratios(path) == {"a": 0.123, "b": 3.0}
