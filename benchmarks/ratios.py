"""Ratios to a peer in the same run, kept in a file: more is better; falls by more than a third are told."""

import json
from pathlib import Path

STORED = Path(__file__).with_name("ratios.json")
KEPT = 2 / 3
"""The share of a stored ratio below which it fell. Two runs on one machine differ by up to a fifth."""


def compare_ratios(stored, found):
    """One line for each ratio that fell, or that nothing is stored of."""
    lines = []
    for name, now in sorted(found.items()):
        before = stored.get(name)
        if before is None:
            lines.append(f"{name}: {now:.3g} is new; `make bench UPDATE=1` stores it")
        elif now < KEPT * before:
            lines.append(f"{name}: fell from {before:.3g} to {now:.3g}")
    return lines


def read_ratios(path=STORED):
    """Ratios by name; none where there is no file yet."""
    return json.loads(path.read_text()) if path.exists() else {}


def store_ratios(found, path=STORED):
    """Put what was found in place of what is stored; ratios of benchmarks that did not run stay."""
    rounded = {name: float(f"{value:.3g}") for name, value in found.items()}
    path.write_text(json.dumps(dict(sorted((read_ratios(path) | rounded).items())), indent=2) + "\n")
