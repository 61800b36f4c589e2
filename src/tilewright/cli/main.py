"""The command line: one module per command, errors as one line and exit code 2."""

import os
import signal
import sys
import warnings
from collections.abc import Callable
from typing import Annotated

import typer

from tilewright import __version__
from tilewright.cli import (
    analyze,
    aperiodic,
    bricks,
    compare,
    dapple,
    export,
    flow,
    info,
    pack,
    points,
    render,
    surface,
    texture,
    view,
    warm,
)
from tilewright.cli.performing import Ending, say
from tilewright.cli.spelling import spell_numbers
from tilewright.errors import TilewrightError, TilewrightWarning

_INTERRUPTED = 130

app = typer.Typer(
    name="tilewright",
    context_settings={"help_option_names": ["--help", "-h"]},
    help="Endless, non-repeating textures and points from Wang tiles and corner tiles.",
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


def _version(asked: bool) -> None:
    if asked:
        print(f"tilewright {__version__}")
        raise typer.Exit


@app.callback(invoke_without_command=True)
def _root(
    context: typer.Context,
    version: Annotated[
        bool, typer.Option("--version", "-V", callback=_version, is_eager=True, help="Print the version.")
    ] = False,
) -> None:
    if context.invoked_subcommand is None:
        print(context.get_help())
        raise typer.Exit(2)


COMMANDS: dict[str, Callable[..., None]] = {}
for module in (
    texture,
    render,
    view,
    points,
    surface,
    analyze,
    compare,
    pack,
    dapple,
    bricks,
    flow,
    aperiodic,
    export,
    info,
    warm,
):
    name = module.__name__.rsplit(".", 1)[-1]
    COMMANDS[name] = app.command(name)(module.command)


def main() -> None:
    """The program: `run`, in a process of its own."""
    # C libraries print complaints of their own; only what this program says reaches the terminal.
    if sys.stderr is not None:  # it is where the program was started without one
        sys.stderr = os.fdopen(os.dup(2), "w", buffering=1)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    for stream in (sys.stdout, sys.stderr):
        if stream is not None:
            stream.reconfigure(errors="backslashreplace")  # type: ignore[union-attr]
    for number in (getattr(signal, name, None) for name in ("SIGINT", "SIGTERM", "SIGHUP")):
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, Ending.ask)
    # A signal may meet a callback of a compiler, which cannot pass it on; `Ending` remembers it.
    shown = sys.unraisablehook
    sys.unraisablehook = lambda lost: None if Ending.asked else shown(lost)
    run()


def run(arguments: list[str] | None = None) -> None:
    """Run a command; never show a traceback for what a user can mend."""
    warnings.showwarning = _show_warning  # type: ignore[assignment]
    given = sys.argv[1:] if arguments is None else arguments
    try:
        code = app(_spelled(given), standalone_mode=False)
        if sys.stdout is not None:
            sys.stdout.flush()
        if code == _INTERRUPTED:
            _say("stopped")
    except TilewrightError as error:
        code = _say(error.told(names_of(given)))
    except MemoryError:
        code = _say("not enough memory; ask for a smaller tile size, fewer colors or a smaller window")
    except (KeyboardInterrupt, typer.Abort):
        code = _say("stopped", _INTERRUPTED)
    except BrokenPipeError:
        code = 1
    except OSError as error:
        code = _say(f"a file could not be read or written: {(error.strerror or str(error)).lower()}")
    except Exception as error:
        if Ending.asked:  # a signal that met a compiler or a library in the middle of something
            sys.exit(_say("stopped", _INTERRUPTED))
        # Usage errors: their class comes from click or from typer's own copy of it.
        message = getattr(error, "format_message", None)
        if message is None:
            raise
        code = _say(message())
    sys.exit(code if isinstance(code, int) else 0)


def _spelled(arguments: list[str]) -> list[str]:
    """The arguments with numbers as the parser takes them."""
    called = next((word for word in arguments if word in COMMANDS), None)
    return arguments if called is None else [*spell_numbers(arguments, COMMANDS[called])]


def names_of(arguments: list[str]) -> Callable[[str], str]:
    """What the options of the command that was called are called on the command line."""
    known = typer.main.get_command(app).commands  # type: ignore[attr-defined]
    command = next((known[word] for word in arguments if word in known), None)
    names = {
        one.name: max(one.opts, key=len) if one.opts[0].startswith("-") else one.name.upper()
        for one in (command.params if command else ())
    }
    return lambda name: str(names.get(name, name))


def _say(message: str, code: int = 2) -> int:
    say(message)
    return code


def _show_warning(message: Warning | str, category: type[Warning], *rest: object) -> None:
    if issubclass(category, TilewrightWarning):
        _say(f"note: {message}")
