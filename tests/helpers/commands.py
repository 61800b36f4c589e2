"""Commands called in this process, with their errors told as the program tells them."""

from tilewright.cli.main import app, names_of
from tilewright.errors import TilewrightError


def call(command, *arguments):
    """Run a command; its errors call options as the command line does."""
    words = [command, *map(str, arguments)]
    try:
        app(words, standalone_mode=False)
    except TilewrightError as error:
        raise TilewrightError(error.told(names_of(words))) from None
