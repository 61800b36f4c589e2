"""Dappled tilings: no long runs of a tile along rows or columns (Kaji et al. 2016)."""

from tilewright.lazy import load_lazily

_HOME = {
    "Closest": "closest",
    "Conditions": "conditions",
    "EndlessDapple": "endless",
    "Impossible": "completing",
    "closest_dapple": "closest",
    "complete_dapple": "completing",
    "count_dappled": "counting",
    "dapple": "dappling",
    "endless_dapple": "endless",
    "find_violations": "conditions",
    "dapple_formula": "completing",
    "random_start": "starts",
    "rectify": "surgery",
    "start_from_image": "starts",
}

__all__ = list(_HOME)
__getattr__, __dir__ = load_lazily(__name__, _HOME)
