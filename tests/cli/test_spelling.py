"""Numbers as people write them."""

from typing import Annotated

import numpy as np
import pytest
import typer

import tilewright as tw
from tilewright.cli.main import COMMANDS, run
from tilewright.cli.spelling import spell_numbers


def command(
    count: Annotated[int | None, typer.Option(help="Number of points.")] = None,
    width: Annotated[float, typer.Option("-w", "--width", help="Width in tiles.")] = 1.0,
    side: Annotated[int, typer.Option(help="Side in pixels.")] = 1,
    size: Annotated[tuple[int, int], typer.Option(help="Size of a cell in pixels.")] = (1, 1),
    sheet: Annotated[tuple[int, int] | None, typer.Option(help="Size of a sheet.")] = None,
    name: Annotated[str, typer.Option(help="Number of a name.")] = "",
    share: Annotated[list[float] | None, typer.Option(help="Shares.")] = None,
) -> None:
    pass


@pytest.mark.parametrize(
    ("given", "spelled"),
    [
        ("--count 1e6", "--count 1000000"),
        ("--count 1,000", "--count 1000"),
        ("--count 12_500_000", "--count 12500000"),
        ("--count=4k", "--count=4000"),
        ("--count 2.5M", "--count 2500000"),
        ("--count -1e3", "--count -1000"),
        ("-w 1,000.5", "-w 1000.5"),
        ("--width 1e-3", "--width 0.001"),
        ("--side 4k", "--side 4096"),
        ("--size 144x48", "--size 144 48"),
        ("--size 144,48", "--size 144 48"),
        ("--size 144 48", "--size 144 48"),
        ("--sheet 300x200", "--sheet 300 200"),
        ("--name 1e6 photo,1", "--name 1e6 photo,1"),
        ("--share 1e6", "--share 1e6"),
        ("--count", "--count"),
    ],
)
def test_numbers_are_spelled_out(given, spelled):
    assert [*spell_numbers(given.split(), command)] == spelled.split()


@pytest.mark.parametrize("text", ["many", "1.5", "1,00", "1e999", "k", "", "0x10", "1 000"])
def test_what_is_no_number_is_refused_by_name(text):
    with pytest.raises(
        tw.TilewrightError, match=r"--count is .*; expected a whole number, as 4000, 1e6 or 4k"
    ):
        [*spell_numbers(["--count", text], command)]
    assert [*spell_numbers(["-w", "inf", "--count", "--name"], command)] == ["-w", "inf", "--count", "--name"]


def call(*arguments):
    with pytest.raises(SystemExit) as ended:
        run([str(a) for a in arguments])
    return ended.value.code


def test_commands_take_them(tmp_path, capsys):
    assert call("points", "--count", "1e3", "-o", tmp_path / "p.npy") == 0
    assert len(np.load(tmp_path / "p.npy")) == 1000
    wall = ("bricks", "--width", 2, "--height", 2, "--size", "36x12", "-o", tmp_path / "w.png")
    assert call(*wall) == 0
    assert tw.read_image(tmp_path / "w.png").shape[:2] == (24, 72)
    capsys.readouterr()
    assert call("points", "--count", "many", "-o", tmp_path / "q.npy") == 2
    assert "--count is 'many'; expected a whole number" in capsys.readouterr().err
    assert call("-V") == 0
    assert call("render", "-h") == 0


def test_every_command_is_known():
    assert {"texture", "render", "points", "warm"} <= set(COMMANDS)
