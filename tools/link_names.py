"""A hook of MkDocs: a public name in single backticks links to its entry in the reference."""

import re
import xml.etree.ElementTree as etree
from pathlib import Path

from markdown import Extension
from markdown.inlinepatterns import InlineProcessor
from markdown.util import AtomicString
from mkdocs.plugins import event_priority

STUB = Path(__file__).parents[1] / "src/tilewright/__init__.pyi"
PUBLIC = "|".join(re.findall(r" as (\w+),", STUB.read_text()))


class _NameLinks(InlineProcessor, Extension):
    def handleMatch(self, m, data):
        link = etree.Element("autoref", identifier=f"tilewright.{m['name']}", optional="")
        etree.SubElement(link, "code").text = AtomicString(m[1])
        return link, m.start(), m.end()

    def extendMarkdown(self, md):
        md.inlinePatterns.register(self, "public names", 195)  # before the pattern of code, which has 190


@event_priority(100)
def on_config(config):
    """Have single backticks around public names read as links to their entries."""
    # Not within the text of a link, nor within double backticks.
    name = rf"(?<![`\[\\])`((?:tilewright\.|tw\.)?(?P<name>(?:{PUBLIC})(?:\.\w+)?)(?:\(\))?)`(?!`)"
    config.markdown_extensions.append(_NameLinks(name))
