"""The table of hash streams: unique, used where it says, told in the docs, and none meets another."""

import re
from importlib import import_module, resources
from pathlib import Path

import pytest

import tilewright as tw
from tilewright.kernels import bricks, flips
from tilewright.tilings import streams
from tilewright.tilings.streams import DIGIT_STEP, STREAMS, digits_of

PAGE = Path(__file__).parents[2] / "docs" / "hashes.md"
MOST_DIGITS = 24
"""Digits of numbers below 2^24 in base 2."""


def table():
    """The streams as the page has them."""
    lines = ["| stream | name | what it decides | hashes |", "|---|---|---|---|"]
    kinds = {True: "any", False: "mixer"}
    lines += [f"| {s.number} | `{s.name}` | {s.purpose} | {kinds[s.any_hash]} |" for s in STREAMS]
    return "\n".join(lines)


def test_the_page_has_the_table():
    assert table() in PAGE.read_text(), table()


def test_names_and_numbers_are_unique_and_pinned():
    assert [getattr(streams, s.name) for s in STREAMS] == [s.number for s in STREAMS]
    # All that was ever drawn from a stream would change with its number.
    assert [s.number for s in STREAMS if s.number < 512] == list(range(18))
    assert len({s.name for s in STREAMS}) == len({s.number for s in STREAMS}) == len(STREAMS)
    assert all(s.number % 512 == 0 for s in STREAMS if s.number >= 18)


@pytest.mark.parametrize("stream", STREAMS, ids=lambda s: s.name)
def test_every_module_named_draws_from_the_stream(stream):
    for user in stream.users:
        module = import_module(f"tilewright.{user}")
        text = Path(module.__file__).read_text()
        assert user.startswith(("kernels.", "shaders.")) or re.search(rf"\b{stream.name}\b", text), user


def test_no_other_module_draws_from_a_stream():
    source = Path(tw.__file__).parent
    for path in source.rglob("*.py"):
        name = ".".join(path.relative_to(source).with_suffix("").parts)
        found = re.search(r"streams import (\(.*?\)|[^\n]*)", path.read_text(), re.DOTALL)
        for imported in re.findall(r"[A-Z_]{2,}", found[1]) if found else ():
            users = [s.users for s in STREAMS if s.name == imported]
            assert not users or name in users[0] or name == "tilings.hashes", (name, imported)


def test_kernels_and_scripts_repeat_the_numbers():
    assert (flips._CLASSES, bricks._EDGES) == (streams.BRICK_CLASSES, streams.BRICK_EDGES)
    viewer = resources.files("tilewright.export.viewer")
    patches = f"PATCH_STREAMS = [{streams.PATCH_COLUMNS}, {streams.PATCH_ROWS}];"
    assert patches in viewer.joinpath("photo.js").read_text()
    second = f'{{ bits: {streams.BITS}, "marked-edges": {streams.MARKS}, "marked-sums": {streams.MARKS} }};'
    assert second in viewer.joinpath("lattice.js").read_text()
    others = f"VARIANT_STREAM = {streams.VARIANTS}, TONE_STREAM = {streams.TONES};"
    assert others in viewer.joinpath("lattice.js").read_text()


def digits(hash):
    """How many digits a hash takes for a number."""
    asked = []
    words = hash.words
    hash.words = lambda stream, *point: asked.append(stream) or words(stream, *point)
    hash.numbers(0, 1, 2, 3)
    return [a // DIGIT_STEP for a in asked]


@pytest.mark.parametrize(
    "hash",
    [tw.MixerHash(1), tw.LongPeriodHash(1), tw.LongPeriodHash.for_noise(1)]
    + [tw.PermutationHash(1, n) for n in (2, 3, 16, 256, 65536)],
    ids=lambda h: f"{h.name} {h.range}",
)
def test_no_digits_of_two_streams_meet(hash):
    taken = {}
    places = digits(hash)
    assert len(places) <= MOST_DIGITS
    for stream in STREAMS:
        if not (stream.any_hash or isinstance(hash, tw.MixerHash)):
            continue
        for digit in digits_of(stream.number, len(places)):
            assert digit not in taken, f"{stream.name} and {taken[digit]} share stream {digit}"
            taken[digit] = stream.name


def test_new_streams_meet_none():
    old = {d for s in STREAMS for d in digits_of(s.number, MOST_DIGITS) if s.number < 512}
    new = [d for number in range(512, 4096, 512) for d in digits_of(number, MOST_DIGITS)]
    assert len(set(new)) == len(new)
    assert not old & set(new)


def test_the_pairs_that_would_meet_in_a_table_are_stated():
    """Streams that only the mixer is asked for, yet that are a digit of another stream."""
    stated = {"FLOWS": 0, "ROTATIONS": 1}
    found = {
        s.name: other.number
        for s in STREAMS
        for other in STREAMS
        if s.number in digits_of(other.number, MOST_DIGITS)[1:]
    }
    assert found == stated
    for s in STREAMS:
        assert (s.name in stated) == ("would be a digit of stream" in s.purpose)
        assert not (s.name in stated and s.any_hash)
