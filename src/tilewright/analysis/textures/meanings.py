"""What the figures of textures say: units, limits, objections, and what to change."""

from typing import NamedTuple

ANY = (float("-inf"), float("inf"))


class Meaning(NamedTuple):
    """What a figure says.

    Attributes
    ----------
    unit : str
        Its unit: ``"x"`` of a ratio, ``"share"`` of 0 to 1, ``"corr."`` of a correlation, ``"dE"`` of a
        distance of colors (CIE delta E 1976).
    limits : (float, float)
        Least and most that the eye does not object to.
    says : str
    objection : str
        What it objects to beyond them, with ``{value}`` in it.
    advice : str
        What to change then.
    """

    unit: str
    limits: tuple[float, float]
    says: str
    objection: str = ""
    advice: str = ""


_MORE = "more colors or more variants"
_ROOM = "larger tiles, so that cuts find ways around things"
_REJECT = "reject the patches that show (the sheet and the viewer name them)"
_TONE = "method faithful with tone, which lays outside the tiles what is larger than they are"

MEANING = {
    "cut_line_ratio": Meaning(
        "x",
        (0, 1.1),
        "color step across cuts over that elsewhere",
        "cuts show: steps across them are {value:.2f} times those elsewhere",
        _ROOM,
    ),
    "worst_tile_ratio": Meaning(
        "x", (0, 1.3), "the same for the worst tile", "cuts show in one tile", _REJECT
    ),
    "cut_color_ratio": Meaning(
        "x",
        (0, 1.4),
        "color on two sides of cuts over what the patches have there",
        "things of two colors: sides of cuts differ {value:.2f} times as they do in the photograph",
        _ROOM,
    ),
    "edge_cut_share": Meaning(
        "share",
        (0, 0.03),
        "pixel pairs across tile borders that do not continue",
        "borders of tiles show",
        "see that each picture stands at the colors it was made for",
    ),
    "repetition": Meaning(
        "corr.",
        (-1, 0.17),
        "autocorrelation at tile lags, less the photograph's own",
        "tiles are seen to come again",
        _MORE,
    ),
    "repetition_raw": Meaning("corr.", ANY, "autocorrelation at tile lags"),
    "photograph_own": Meaning("corr.", ANY, "the photograph's autocorrelation at those lags"),
    "same_place_share": Meaning(
        "share",
        (0, 0.17),
        "equal origins at equal places of two cells",
        "cells show the same at the same place",
        _MORE,
    ),
    "lattice_share": Meaning(
        "share",
        (0, 0.15),
        "low-passed variance that is the same in every tile",
        "every tile has its light and dark at the same places",
        _MORE,
    ),
    "tone_step_ratio": Meaning(
        "x",
        (0, 1.3),
        "tone of tile middles against borders, over the photograph's",
        "tiles differ in tone",
        _TONE,
    ),
    "seam_novelty": Meaning(
        "x",
        (0, 1.2),
        "distance of patches on cuts to the photograph, over its own",
        "cuts break what they cross",
        _ROOM,
    ),
    "seam_novelty_p95": Meaning(
        "x", (0, 2.0), "its 95th percentile", "some cuts break what they cross", _REJECT
    ),
    "used_share": Meaning(
        "share",
        (0.1, float("inf")),
        "the photograph's pixels that the set shows",
        "only {value:.1%} of the photograph is shown",
        "larger tiles, more colors or more variants, or a smaller cut of the photograph",
    ),
    "mean_difference": Meaning(
        "dE",
        (0, 2),
        "distance of the mean colors; 2 is just seen",
        "the plane has another color, by {value:.1f} delta E",
        _MORE,
    ),
    "low_contrast": Meaning(
        "x",
        (0.68, 1.3),
        "contrast of blots of tone over the photograph's",
        "blots of tone have {value:.2f} of the photograph's contrast",
        _TONE,
    ),
    "fine_contrast": Meaning(
        "x",
        (0.85, 1.15),
        "contrast of fine detail over the photograph's",
        "fine detail has {value:.2f} of the photograph's contrast",
        _MORE,
    ),
    "recurrence": Meaning(
        "x",
        (0, 2.2),
        "copies of windows on the photograph's area, over its own",
        "a piece of the plane is seen {value:.1f} times on the photograph's area",
        _MORE,
    ),
    "salient_copies": Meaning(
        "x",
        (0, 4.5),
        "the same of what pops out most",
        "one thing pops out {value:.1f} times on the photograph's area",
        _REJECT,
    ),
    "equal_neighbors": Meaning(
        "share",
        (0, 0.004),
        "neighboring cells that look alike, less the photograph's own",
        "equal tiles lie side by side",
        _MORE,
    ),
    "lattice_spikes": Meaning(
        "share",
        (0, 0.006),
        "variance from afar in spikes, less the photograph's own",
        "a lattice shows from afar",
        _MORE,
    ),
}
_STEPS = ("cut_line_ratio", "worst_tile_ratio")
WITHOUT_LIMIT = {"things": _STEPS, "courses": (*_STEPS, "lattice_spikes")}
"""Figures without limits, by treatment. Where cuts follow outlines, as they should, steps are large; and
courses are waves of their own, which are not those of a lattice of tiles."""
