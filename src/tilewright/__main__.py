"""The program: ``tilewright``, and ``python -m tilewright``."""

import os
import signal


def _end(number: int, frame: object) -> None:
    """End at once and in one line: nothing has begun, and imports cannot all be interrupted."""
    os.write(2, b"tilewright: stopped\n")
    os._exit(130)


def main() -> None:
    """Start the program; until it is loaded a signal ends it."""
    for number in (getattr(signal, name, None) for name in ("SIGINT", "SIGTERM")):
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _end)
    from tilewright.cli.main import main as start

    start()


if __name__ == "__main__":
    main()
