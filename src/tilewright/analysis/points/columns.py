"""The columns of a comparison: heads, units, what is best, and which method is best for what."""

from math import isfinite, nan
from typing import Any, NamedTuple

from tilewright.analysis.points.verdict import GOOD_RHO

Row = dict[str, Any]


class Column(NamedTuple):
    """A column of the table.

    Attributes
    ----------
    key : str
        The figure, as in `PointReport.figures`.
    head : str
    says : str
        Unit and meaning.
    best : int
        1 where most is best, -1 where least is, 0 where neither.
    """

    key: str
    head: str
    says: str
    best: int = 0


COLUMNS = (
    Column("method", "method", "name, as methods takes it"),
    Column("count", "points", "points of a set, mean"),
    Column("milliseconds", "ms", "milliseconds for a set, once what is built is there", -1),
    Column("construction_seconds", "built, s", "seconds for what is built once; - where nothing is"),
    Column(
        "rho",
        "rho",
        "least distance over 2 r_max, the densest packing's; 0.65 to 0.85 is good",
        1,
    ),
    Column("coverage", "coverage", "radius of the largest empty circle in r_max; holes are large", -1),
    Column("radial_peak", "peak", "highest radially averaged power; white noise 1, a lattice 80", -1),
    Column(
        "largest_bin", "largest bin", "highest power of one frequency, white noise 1; a lattice shows", -1
    ),
    Column("anisotropy_max", "anisotropy, max dB", "dB, highest over the rings; directions show", -1),
    Column("anisotropy_median", "median dB", "dB, median over the rings; -10 log10 of the sets is even", -1),
    Column("effective_nyquist", "nu_eff", "frequencies sampled without noise, in sqrt(N) / 2", 1),
    Column("oscillation", "Omega", "swings of the power beyond; high ones show fine detail as rings", -1),
    Column("zone_plate_near", "plate, near", "RMS error, 0 to 1, where pixels are fine enough", -1),
    Column("zone_plate_error", "plate, all", "RMS error of the whole zone plate, 0 to 1", -1),
)
_PURPOSES = (
    ("effective_nyquist", "the cleanest low frequencies", "effective Nyquist frequency {:.3g} of a grid's"),
    ("oscillation", "the least rings", "oscillation {:.3g}"),
    ("largest_bin", "the least lattice", "no frequency above {:.3g} x white noise"),
    ("coverage", "no holes", "empty circles up to {:.3g} r_max"),
    ("milliseconds", "speed", "{:.3g} ms for a set"),
)


def is_blue(row: Row) -> bool:
    """Whether a method ran and keeps points apart without making a lattice: a rho of 0.65 to 0.85."""
    return "not_run" not in row and GOOD_RHO[0] <= row["rho"] <= GOOD_RHO[1]


def find_best(rows: list[Row]) -> dict[str, float]:
    """The best value of each column among blue noise; of none where fewer than two compete."""
    able = [row for row in rows if is_blue(row)]
    best = {}
    for column in filter(lambda column: column.best, COLUMNS):
        values = [row[column.key] for row in able if isfinite(row.get(column.key, nan))]
        if len(values) > 1:
            best[column.key] = max(values) if column.best > 0 else min(values)
    return best


def explain_columns() -> str:
    """A line for each column: what it says and in which unit, and what the marks are."""
    better = {1: "; most is best", -1: "; least is best", 0: ""}
    lines = [f"- {column.head}: {column.says}{better[column.best]}" for column in COLUMNS]
    marks = "**Bold** is the best of a column among blue noise, methods with a rho of {:g} to {:g}."
    return "\n".join([marks.format(*GOOD_RHO), "", *lines])


def judge_methods(rows: list[Row]) -> list[str]:
    """Which method is best for what, in sentences; lattices and noise take no part.

    Where several are equal to the digits that are told, the quickest is named.
    """
    able = [row for row in rows if is_blue(row)]
    if not able:
        low, high = GOOD_RHO
        return [f"None of these is blue noise: none has a rho of {low:g} to {high:g}."]
    if len(able) == 1:
        return [f"Only {able[0]['method']} is blue noise; there is nothing to compare it to."]
    said = [_name_best(able, *purpose) for purpose in _PURPOSES]
    tiles = [row for row in able if "construction_seconds" in row]
    random = "random access, any cell at once"
    words = "tiles, with no frequency above {:.3g} x white noise"
    said.append(_name_best(tiles, "largest_bin", random, words))
    return [sentence for sentence in said if sentence]


def _name_best(rows: list[Row], key: str, purpose: str, words: str) -> str:
    best = next(column.best for column in COLUMNS if column.key == key)
    known = [row for row in rows if isfinite(row.get(key, nan))]
    if not known:
        return ""
    first = min(known, key=lambda row: (float(f"{-best * row[key]:.3g}"), row["milliseconds"]))
    return f"For {purpose}: {first['method']} ({words.format(first[key])})."
