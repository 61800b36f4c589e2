"""The streams of the lattice hash: one table of what chance is drawn from where.

Two streams of one hash are independent. A hash with few values, such as a permutation table, makes a large
number of several words: digit k of stream s is a word of stream s + 16 k (`LatticeHash.numbers`), for up to
24 digits, since the smallest table has 2 entries. The streams that such hashes are asked for differ modulo
16, so that no digits of two of them meet. Of the others only the mixer is asked, which takes a single word.

A new stream is a multiple of 512, from 512 on: none of its digits meets another stream, whatever the hash.
"""

from dataclasses import dataclass

DIGIT_STEP = 16
"""Streams from one digit of a number to the next."""

COLORS, SECOND, ANCHORS, DIGITS, MARKS, BITS, VARIANTS, LOTS = range(8)
DENSITY, DRAWS, PATCH_COLUMNS, PATCH_ROWS, BRICK_CLASSES, BRICK_EDGES, DAPPLE_ENDLESS, DAPPLE_START = range(
    8, 16
)
FLOWS, ROTATIONS = 16, 17
TONES = 512

WALL_LAYER = 1000
"""From this z on the streams of brick tilings say what the surface of a wall is like."""


@dataclass(frozen=True)
class Stream:
    """A stream of the lattice hash.

    Attributes
    ----------
    name : str
        Its name in this module.
    number : int
        It never changes: all that is drawn from it would change too.
    purpose : str
    users : tuple of str
        Modules that draw from it, without ``tilewright.`` in front.
    any_hash : bool
        Whether hashes of all kinds are asked for it; otherwise only the mixer is.
    """

    name: str
    number: int
    purpose: str
    users: tuple[str, ...]
    any_hash: bool = False


_ALGORITHMS, _DIRECT = "tilings.algorithms", "tilings.direct_tiling"

STREAMS = (
    Stream(
        "COLORS",
        COLORS,
        "colors of corners, edges and faces; of densities, those of unmarked corners",
        (_ALGORITHMS, "tilings.density", "kernels.lattice", "shaders.hashing", "shaders.lookup"),
        any_hash=True,
    ),
    Stream(
        "SECOND",
        SECOND,
        'the second hash of `wang="two-hashes"`; of densities, colors of marked corners',
        (_ALGORITHMS, "tilings.density"),
        any_hash=True,
    ),
    Stream("ANCHORS", ANCHORS, "anchors of chains", ("tilings.chains",), any_hash=True),
    Stream("DIGITS", DIGITS, "digits of chains", ("tilings.chains",), any_hash=True),
    Stream("MARKS", MARKS, "marks of corner-coded sets", (_ALGORITHMS,), any_hash=True),
    Stream("BITS", BITS, "bits of shifted sets and compact Wang cubes", (_ALGORITHMS,), any_hash=True),
    Stream(
        "VARIANTS",
        VARIANTS,
        "variants of tiles",
        ("tilings.placements", "shaders.lookup", "export.engines.folder", "gpu.field"),
        any_hash=True,
    ),
    Stream("LOTS", LOTS, "lots among points of one rank", ("fields.points.thinning",)),
    Stream("DENSITY", DENSITY, "what densities are compared with", ("tilings.density",), any_hash=True),
    Stream("DRAWS", DRAWS, "tiles of scanline tilings", ("tilings.scanline_tiling",)),
    Stream(
        "PATCH_COLUMNS",
        PATCH_COLUMNS,
        "columns of the patches of hex-tiling and by-example noise",
        ("fields.photos.methods",),
    ),
    Stream("PATCH_ROWS", PATCH_ROWS, "rows of those patches", ("fields.photos.methods",)),
    Stream(
        "BRICK_CLASSES",
        BRICK_CLASSES,
        "classes of endless brick tilings; from layer 1000 on, what single bricks look like",
        ("kernels.flips", "fields.bricks.field"),
    ),
    Stream(
        "BRICK_EDGES",
        BRICK_EDGES,
        "edges of brick tilings; from layer 1000 on, noise of walls",
        ("kernels.bricks", "tilings.bricks.from_dappled", "fields.bricks.field"),
    ),
    Stream(
        "DAPPLE_ENDLESS", DAPPLE_ENDLESS, "starts of endless dappled tilings", ("tilings.dappled.endless",)
    ),
    Stream("DAPPLE_START", DAPPLE_START, "random starts of dappled tilings", ("tilings.dappled.starts",)),
    Stream(
        "FLOWS",
        FLOWS,
        "cells of flows, with keys derived from the seed; with a table it would be a digit of stream 0",
        ("flows.tiles", "flows.crowd"),
    ),
    Stream(
        "ROTATIONS",
        ROTATIONS,
        "starts of aperiodic tilings by rotations; with a table it would be a digit of stream 1",
        ("tilings.aperiodic.rotations",),
    ),
    Stream(
        "TONES",
        TONES,
        "places of the photograph around whose points of a grid tone is taken: row and column, 12 bits each",
        ("fields.tone", "shaders.lookup", "export.engines.folder", "gpu.field"),
        any_hash=True,
    ),
)
"""All streams, by number."""


def digits_of(stream: int, count: int) -> list[int]:
    """The streams that the digits of a number are drawn from, the highest digit first."""
    return [stream + DIGIT_STEP * digit for digit in range(count)]
