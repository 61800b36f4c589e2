"""What errors carry, how a face tells them, and that the library raises them so."""

import ast
import copy
import pickle
import re
from pathlib import Path

import numpy as np
import pytest

import tilewright as tw
from tilewright.checks import check_choice, check_int, check_out, check_real, check_type
from tilewright.errors import (
    Cancelled,
    GpuError,
    TilewrightError,
    TilewrightFileError,
    TilewrightTypeError,
    TilewrightValueError,
)
from tilewright.signals.points.kopf import kopf_tiles
from tilewright.tilings.clauses import Undecided

SOURCE = Path(tw.__file__).parent
LIBRARY = [p for p in sorted(SOURCE.rglob("*.py")) if "cli" not in p.relative_to(SOURCE).parts]
KINDS = (TilewrightError, TilewrightValueError, TilewrightTypeError, TilewrightFileError, GpuError, Cancelled)


def flag(name):
    return f"--{name.replace('_', '-')}"


def caught(kind, call, *args, **kwargs):
    with pytest.raises(kind) as caught:
        call(*args, **kwargs)
    return caught.value


def test_message_is_made_of_what_the_error_carries():
    error = TilewrightValueError(
        "is 7; it must be even", argument="tile_size", value=7, allowed="even", advice="take 8"
    )
    assert str(error) == "tile_size is 7; it must be even; take 8"
    assert error.told(flag) == "--tile-size is 7; it must be even; take 8"
    assert (error.argument, error.value, error.allowed, error.advice) == ("tile_size", 7, "even", "take 8")


def test_problem_is_made_from_value_and_allowed():
    error = TilewrightValueError(argument="size", value="x" * 200, allowed="small, large")
    assert str(error) == f"size is '{'x' * 76}...; allowed are small, large"


def test_plain_text_is_told_as_it_is():
    error = TilewrightError("the tiles hold no points")
    assert str(error) == error.told(flag) == "the tiles hold no points"
    assert (error.argument, error.value, error.allowed, error.advice) == ("", None, "", "")
    assert str(Cancelled()) == ""


@pytest.mark.parametrize("kind", [*KINDS, Undecided])
@pytest.mark.parametrize("again", [copy.copy, copy.deepcopy, lambda e: pickle.loads(pickle.dumps(e))])
def test_errors_survive_copies_and_other_processes(kind, again):
    error = kind("is odd", argument="size", value=(7, 9), allowed="even", advice="take 8")
    found = again(error)
    assert type(found) is kind
    assert str(found) == found.told() == "size is odd; take 8"
    assert (found.argument, found.value, found.allowed, found.advice) == ("size", (7, 9), "even", "take 8")


def test_what_cannot_be_pickled_travels_in_words():
    error = caught(TilewrightTypeError, check_int, "size", lambda: 1, 1, 9)
    found = pickle.loads(pickle.dumps(error))
    assert str(found) == str(error)
    assert found.value == " ".join(repr(error.value).split())[:77] + "..." or found.value == repr(error.value)
    assert callable(error.value)


@pytest.mark.parametrize(
    ("error", "message", "value", "allowed", "advice"),
    [
        (
            lambda: check_int("n", 9, 1, 8, "take 8"),
            "is 9; allowed are 1 to 8; take 8",
            9,
            "1 to 8",
            "take 8",
        ),
        (lambda: check_int("n", "9", 1, 8), "must be an integer, not '9'", "9", "an integer", ""),
        (lambda: check_real("n", 2, 0, 1), "is 2.0; allowed are 0 to 1", 2.0, "0 to 1", ""),
        (lambda: check_real("n", 10**999, 0, 1), "is too large; allowed are 0 to 1", 10**999, "0 to 1", ""),
        (lambda: check_choice("n", "c", ("a", "b")), "is 'c'; allowed are a, b", "c", "a, b", ""),
        (
            lambda: check_type("n", 9, str, "a word", "str makes one"),
            "must be a word, not int; str makes one",
            9,
            "a word",
            "str makes one",
        ),
    ],
)
def test_checks_carry_what_they_say(error, message, value, allowed, advice):
    found = caught(TilewrightError, error)
    assert found.told(flag) == f"--n {message}"
    assert (found.argument, found.value, found.allowed, found.advice) == ("n", value, allowed, advice)


def test_arrays_to_write_to_are_checked():
    def fits(out):
        return out.dtype == np.uint8

    whole = np.zeros((4, 4), np.uint8)
    assert check_out(whole, fits, "uint8") is whole
    for out in (whole.astype(int), whole[:, ::2], np.broadcast_to(whole[0], (4, 4))):
        error = caught(TilewrightValueError, check_out, out, fits, "uint8")
        assert (error.argument, error.allowed) == ("out", "uint8, C-contiguous and writable")
    assert caught(TilewrightTypeError, check_out, [1], fits, "uint8").told(flag).startswith("--out must be")


def test_errors_of_the_library_carry_their_parts(tmp_path):
    error = caught(TilewrightValueError, kopf_tiles, 1000)
    assert error.argument == "points"
    assert error.value == 1000
    assert error.told(flag).startswith("--points is 1000; it must be a multiple of ")
    error = caught(TilewrightTypeError, tw.draw_tiles, "tiles")
    assert (error.argument, error.value, error.allowed) == (
        "tiles",
        "tiles",
        "a TileSet, such as corner_tiles(2)",
    )
    error = caught(TilewrightFileError, tw.load, tmp_path / "none")
    assert (error.argument, error.value) == ("", tmp_path / "none")
    error = caught(TilewrightTypeError, tw.read_points, tmp_path / "a.npy", box=1)
    assert (error.argument, error.advice) == ("box", "Box((width, height)) makes one")


def beginning(message):
    """The argument's name that a message begins with, or the variable that holds it."""
    text = ast.unparse(message).lstrip("f").strip("'\"")
    found = re.match(r"([a-z_]\w*|\{(?:name|what)\}) (?!and )", text)
    return found[1].strip("{}") if found else ""


def unnamed(tree):
    """Errors whose text begins with a parameter of their function and which do not say which."""
    for function in ast.walk(tree):
        if not isinstance(function, ast.FunctionDef):
            continue
        given = function.args
        parameters = {a.arg for a in (*given.posonlyargs, *given.args, *given.kwonlyargs)}
        for node in ast.walk(function):
            if not (isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) and node.exc.args):
                continue
            kind = ast.unparse(node.exc.func)
            keywords = {k.arg for k in node.exc.keywords}
            word = beginning(node.exc.args[0])
            checked = kind in ("TilewrightValueError", "TilewrightTypeError")
            if checked and word in parameters and "argument" not in keywords:
                yield node.lineno, word


def test_unnamed_arguments_are_found():
    bad = "def f(size):\n    raise TilewrightValueError(f'size is {size}')"
    also_bad = "def f(name):\n    raise TilewrightTypeError(f'{name} is odd')"
    good = "def f(size):\n    raise TilewrightValueError(f'is {size}', argument='size')"
    assert [len(list(unnamed(ast.parse(text)))) for text in (bad, also_bad, good)] == [1, 1, 0]


def test_errors_that_begin_with_an_argument_carry_it():
    found = [
        f"{path.relative_to(SOURCE)}:{line} {word}"
        for path in LIBRARY
        for line, word in unnamed(ast.parse(path.read_text()))
    ]
    assert not found


def test_library_does_not_speak_of_flags():
    found = [
        f"{path.relative_to(SOURCE)}:{node.lineno}"
        for path in LIBRARY
        for node in ast.walk(ast.parse(path.read_text()))
        if isinstance(node, ast.Constant)
        and isinstance(node.value, str)
        and re.search(r"(^|[\s'\"`(])--[a-z]", node.value)
    ]
    assert not found
