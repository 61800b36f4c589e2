"""The files that the folders of targets are put together from, beside this one."""

from tilewright.shaders import templates


def fill(part: str, **values: str | bool) -> str:
    """A file beside this one with its placeholders filled."""
    return templates.fill(templates.read_text(__package__, part), **values)
