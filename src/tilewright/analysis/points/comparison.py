"""The comparison of methods of Lagae 2007, chapter 6, for anyone to run again."""

import json
import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from math import isfinite
from pathlib import Path
from typing import Any

from tilewright import __version__
from tilewright.analysis.points.columns import COLUMNS, explain_columns, find_best, judge_methods
from tilewright.analysis.points.contenders import Contender, Make, list_contenders
from tilewright.analysis.points.laid_tiles import PLATE_POINTS, SPECTRUM_POINTS
from tilewright.analysis.points.report import PointReport, analyze_points, save_comparison
from tilewright.analysis.sheets import need_plots
from tilewright.checks import check_choice, check_int, type_error
from tilewright.errors import Cancelled, Progress, TilewrightError
from tilewright.files.atomic import AnyPath, as_path, check_folder, whole_folder
from tilewright.files.texts import write_text
from tilewright.samplers.point_set import PointSet
from tilewright.showing import describe_record

_SETS = 10
_SHARE = 12.0
"""Seconds that the sets of a method may take by default, and those of its zone plate."""
_ROWS = 6
"""Methods on one picture."""
_RESULT = "comparison.json"


@dataclass(frozen=True, eq=False)
class Comparison:
    """What was measured of many methods.

    Attributes
    ----------
    rows : list of dict
        For each method, its name, source and figures as in ``PointReport.figures``, ``milliseconds`` for a
        set of about 16,384 points and ``construction_seconds`` for what is done once; or ``not_run``, why it
        was left out.
    reports : list of PointReport
        The reports of those that ran, in the same order.
    """

    rows: list[dict[str, Any]]
    reports: list[PointReport] = field(default_factory=list)

    __repr__ = describe_record

    def table(self) -> str:
        """Write a Markdown table of all that ran, and a line for each that did not; then what they say.

        The best of each column among blue noise is bold. Below stand the verdict and the meaning of the
        columns.

        Returns
        -------
        str
            The text, with a line for each method.
        """
        best = find_best(self.rows)
        lines = ["| " + " | ".join(c.head for c in COLUMNS) + " |", "|---" * len(COLUMNS) + "|"]
        lines += [
            "| " + " | ".join(_cell(row.get(c.key), best.get(c.key)) for c in COLUMNS) + " |"
            for row in self.rows
            if "not_run" not in row
        ]
        left_out = [f"- {row['method']}: not run, {row['not_run']}" for row in self.rows if "not_run" in row]
        said = [f"- {sentence}" for sentence in self.verdict]
        parts = (lines, left_out, said, [explain_columns()])
        return "\n\n".join("\n".join(part) for part in parts if part) + "\n"

    @property
    def verdict(self) -> list[str]:
        """Which method is best for what: a sentence for each purpose."""
        return judge_methods(self.rows)

    def plain_rows(self) -> list[dict[str, Any]]:
        """Give `rows` in plain JSON values.

        Returns
        -------
        list of dict
            The rows, with None where a figure has no value.
        """
        return [
            {k: None if isinstance(v, float) and not isfinite(v) else v for k, v in row.items()}
            for row in self.rows
        ]

    def save(self, folder: AnyPath) -> None:
        """Write ``comparison.md``, ``comparison.json`` and pictures of six methods each to a folder.

        A folder that holds a comparison is replaced; any other one that is not empty is refused.

        Parameters
        ----------
        folder : str or path-like
            Where the files go; the folder above must be there.

        Raises
        ------
        TilewrightFileError
            The folder holds other things, or cannot be written.
        """
        with whole_folder(folder, _objection) as unfinished:
            write_text(unfinished / "comparison.md", self.table())
            result = {
                "program": f"tilewright {__version__}",
                "verdict": self.verdict,
                "methods": self.plain_rows(),
            }
            write_text(unfinished / _RESULT, json.dumps(result, indent=1))
            for page, first in enumerate(range(0, len(self.reports), _ROWS), 1):
                save_comparison(self.reports[first : first + _ROWS], unfinished / f"sheet-{page}.png")


def compare(
    methods: Sequence[str] | None = None,
    *,
    full: bool = False,
    sets: int = _SETS,
    seed: int = 0,
    progress: Progress | None = None,
) -> Comparison:
    """Measure methods for blue-noise points side by side (Lagae 2007, chapter 6).

    Every method makes ``sets`` sets of about 16,384 points, for radius and spectrum, and one of about 262,144
    for the zone plate; the tile counts are those of figures 6.13 to 6.30.

    Parameters
    ----------
    methods : list of str, optional
        Names of methods, as the table of the page Comparison of methods lists them; by default a choice that
        ends within ten minutes.
    full : bool, optional
        Run all methods, however long they take; default False.
    sets : int, optional
        How many periodograms are averaged, K, 1 to 1,000; default 10.
    seed : int, optional
        Seed of all sets, 0 to 2^63; default 0.
    progress : callable, optional
        Called as ``progress(done, total, what)``; raise `Cancelled` in it to stop.

    Returns
    -------
    Comparison
        Figures of every method, and the reports that they come from.

    Raises
    ------
    TilewrightTypeError
        Something else than a list of names and integers.
    TilewrightValueError
        An unknown method, or a number out of range.

    Examples
    --------
    >>> import tilewright as tw
    >>> found = tw.compare(["jittered"], sets=1)
    >>> found.rows[0]["method"], round(found.rows[0]["radial_peak"])
    ('jittered', 1)
    """
    everyone = list_contenders()
    if methods is None:
        chosen = [c for c in everyone.values() if full or c.standard]
    else:
        if not isinstance(methods, (list, tuple)) or not methods:
            raise type_error("methods", methods, "a list of names")
        chosen = [everyone[check_choice("methods", name, tuple(everyone))] for name in methods]
    many = check_int("sets", sets, 1, 1000)
    check_int("seed", seed, 0, 2**63)
    failed: list[TilewrightError] = []
    rows: list[dict[str, Any]] = []
    reports = []
    for done, contender in enumerate(chosen):

        def step(
            _: int = 0, __: int = 0, what: str = "", done: int = done, name: str = contender.name
        ) -> None:
            if progress is not None:
                progress(done, len(chosen), f"{name}: {what}" if what else name)

        step()
        row: dict[str, Any] = {"method": contender.name, "source": contender.source}
        rows.append(row)
        limit = float("inf") if full or methods is not None else _SHARE
        if many * contender.seconds > limit:
            row["not_run"] = (
                f"{many} sets would take about {many * contender.seconds:.0f} s; full=True runs it"
            )
            continue
        try:
            reports.append(_measure(contender, many, seed, limit, row, step))
        except Cancelled:
            raise
        except TilewrightError as error:
            row["not_run"] = str(error)
            failed.append(error)
    if failed and not reports:
        raise failed[0]
    if progress is not None:
        progress(len(chosen), len(chosen), "done")
    return Comparison(rows, reports)


def check_comparison_folder(folder: AnyPath) -> None:
    """Raise what `Comparison.save` would, before the work is done."""
    need_plots()
    check_folder(as_path(folder), _objection)


def _measure(
    contender: Contender, sets: int, seed: int, limit: float, row: dict[str, Any], progress: Progress
) -> PointReport:
    started = time.perf_counter()
    make = contender.prepare(seed, progress)
    if contender.builds:
        row["construction_seconds"] = time.perf_counter() - started
    make(256, seed)  # compiles
    made = []
    started = time.perf_counter()
    for k in range(sets if contender.repeats else 1):
        made.append(make(SPECTRUM_POINTS, seed + k))
    row["milliseconds"] = 1000 * (time.perf_counter() - started) / len(made)
    plate = _make_plate(contender, make, seed, limit, row["milliseconds"] / 1000)
    report = analyze_points(made, plate=plate, name=contender.name, progress=progress)
    row.update(report.figures)
    return report


def _make_plate(contender: Contender, make: Make, seed: int, limit: float, seconds: float) -> PointSet | None:
    expected = seconds * PLATE_POINTS / SPECTRUM_POINTS
    return make(PLATE_POINTS, seed) if expected <= limit else None


def _objection(folder: Path) -> str:
    names = {path.name for path in folder.iterdir()}
    ours = {"comparison.md", _RESULT, *(n for n in names if n.startswith("sheet-") and n.endswith(".png"))}
    return "" if _RESULT in names and names <= ours else "holds other things than a comparison"


def _cell(value: Any, best: float | None = None) -> str:
    if value is None or (isinstance(value, float) and not isfinite(value)):
        return "-"
    if isinstance(value, str):
        return value
    shown = f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.3g}"
    return f"**{shown}**" if value == best else shown
