"""``python -m tilewright``: the program."""

from tilewright.cli.main import main

main()
