"""The files the page is put together from."""

from tilewright.shaders import templates


def part(name: str) -> str:
    """The text of a part beside this file."""
    return templates.read_text(__package__, name).strip()


def shader(name: str) -> str:
    """The text of one of the page's shaders."""
    return templates.read_text("tilewright.shaders", f"viewer/{name}").strip()


def fill(name: str, **values: str) -> str:
    """A part with its placeholders filled."""
    return templates.fill(part(name), **values)
