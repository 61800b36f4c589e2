"""Drawings as shapes: what PDF and DXF are written from, read out of the SVG that this package draws.

Coordinates are those of the SVG, x east and y south. Circles and arcs stay what they are.
"""

import base64
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import asin, hypot, pi
from typing import NamedTuple
from xml.etree import ElementTree

Steps = tuple["Step", ...]

_SVG = "{http://www.w3.org/2000/svg}"
_PIXEL = 25.4 / 96
"""Millimeters of a CSS pixel."""
_STEP = re.compile(r"([MLHVAZhlva])([^A-Za-z]*)")
_NUMBER = re.compile(r"-?(?:\d+\.?\d*|\.\d+)")
_START = {"fill": "#000000", "stroke": "none", "stroke-width": "1", "stroke-linecap": "butt"}


class Step(NamedTuple):
    """A step of a path: ``M`` to begin at (x, y), ``L`` for a line, ``A`` for an arc there, ``Z`` to close.

    ``turn`` is how far an arc turns, in radians, from x towards y; its ``radius`` is in units.
    """

    kind: str
    x: float
    y: float
    radius: float = 0
    turn: float = 0


@dataclass(frozen=True)
class Path:
    """Lines and arcs; colors as ``#rrggbb``, or None; the line's width in units."""

    steps: Steps
    fill: str | None
    stroke: str | None
    width: float
    is_round: bool


@dataclass(frozen=True)
class Words:
    """A line of text, its middle at x on the base line y; its size in units."""

    text: str
    x: float
    y: float
    size: float
    fill: str


@dataclass(frozen=True)
class Print:
    """A PNG or JPEG file that covers a rectangle, cropped to it."""

    content: bytes
    x: float
    y: float
    width: float
    height: float


@dataclass(frozen=True)
class Use:
    """The symbol of a name, moved."""

    name: str
    x: float
    y: float


@dataclass(frozen=True)
class Clip:
    """Items of which only what is inside a path is shown."""

    steps: Steps
    items: tuple["Item", ...]


Item = Path | Words | Print | Use | Clip


@dataclass(frozen=True)
class Layer:
    """Items that belong together, such as all cuts; one without a name is the drawing itself."""

    name: str
    items: tuple[Item, ...]


@dataclass(frozen=True)
class Drawing:
    """A sheet of ``width`` by ``height`` units of ``unit`` millimeters each."""

    width: float
    height: float
    unit: float
    layers: tuple[Layer, ...]
    symbols: Mapping[str, tuple[Item, ...]]


def read_drawing(text: str) -> Drawing:
    """The shapes of a drawing that this package made as SVG."""
    root = ElementTree.fromstring(text)
    _, _, width, height = (float(n) for n in root.attrib["viewBox"].split())
    size = root.attrib["width"]
    shown = float(size.removesuffix("mm")) * (1 if size.endswith("mm") else _PIXEL)
    reader = _Reader(root)
    layers = [Layer(child.get("id", ""), tuple(reader.items(child, _START, 0, 0))) for child in root]
    return Drawing(width, height, shown / width, tuple(layers), reader.symbols)


def turn_of(across: float, radius: float, sweep: bool) -> float:
    """How far an arc, of half a circle at most, turns between ends so far apart; positive from x to y."""
    turn = 2 * asin(min(1.0, across / (2 * radius)))
    return turn if sweep else -turn


def box(x: float, y: float, width: float, height: float, radius: float = 0) -> Steps:
    """A rectangle, with round corners of a radius if one is given."""
    r, east, south = min(radius, width / 2, height / 2), x + width, y + height
    if r <= 0:
        corners = ((x, y), (east, y), (east, south), (x, south))
        return (*(Step("L" if n else "M", *at) for n, at in enumerate(corners)), Step("Z", x, y))
    sides = (
        ((x + r, y), (east - r, y), (east, y + r)),
        ((east, y + r), (east, south - r), (east - r, south)),
        ((east - r, south), (x + r, south), (x, south - r)),
        ((x, south - r), (x, y + r), (x + r, y)),
    )
    steps = [Step("M", *sides[0][0])]
    for _, end, corner in sides:
        steps += [Step("L", *end), Step("A", *corner, r, pi / 2)]
    return (*steps, Step("Z", *sides[0][0]))


class _Reader:
    """Walks down the elements of a drawing."""

    def __init__(self, root: ElementTree.Element) -> None:
        self._clips = {clip.get("id", ""): clip[0] for clip in root.iter(f"{_SVG}clipPath")}
        self.symbols = {
            symbol.get("id", ""): tuple(self.items(symbol, _START, 0, 0))
            for definitions in root.iter(f"{_SVG}defs")
            for symbol in definitions
            if symbol.tag != f"{_SVG}clipPath"
        }

    def items(
        self, node: ElementTree.Element, above: Mapping[str, str], x: float, y: float
    ) -> Iterator[Item]:
        """The shapes of an element, moved by (x, y), with the attributes of those above it."""
        style = {**above, **{name: node.attrib[name] for name in _START if name in node.attrib}}
        tag = node.tag.removeprefix(_SVG)
        if tag in ("defs", "clipPath"):
            return
        if tag == "g":
            yield from self._group(node, style, x, y)
        elif tag == "use":
            yield Use(node.attrib["href"][1:], x + _at(node, "x"), y + _at(node, "y"))
        elif tag == "text":
            size = float(node.attrib["font-size"])
            yield Words(node.text or "", x + _at(node, "x"), y + _at(node, "y"), size, style["fill"])
        elif tag == "image":
            content = base64.b64decode(node.attrib["href"].partition(",")[2])
            extent = (_at(node, "width"), _at(node, "height"))
            yield Print(content, x + _at(node, "x"), y + _at(node, "y"), *extent)
        else:
            fill, stroke = (None if style[name] == "none" else style[name] for name in ("fill", "stroke"))
            width, is_round = float(style["stroke-width"]), style["stroke-linecap"] == "round"
            yield Path(_steps(node, x, y), fill, stroke, width, is_round)

    def _group(
        self, node: ElementTree.Element, style: Mapping[str, str], x: float, y: float
    ) -> Iterator[Item]:
        if "transform" in node.attrib:
            across, down = (float(n) for n in _NUMBER.findall(node.attrib["transform"]))
            x, y = x + across, y + down
        inside = (item for child in node for item in self.items(child, style, x, y))
        if "clip-path" in node.attrib:
            name = node.attrib["clip-path"].removeprefix("url(#").removesuffix(")")
            yield Clip(_steps(self._clips[name], x, y), tuple(inside))
        else:
            yield from inside


def _at(node: ElementTree.Element, name: str) -> float:
    return float(node.get(name, 0))


def _steps(node: ElementTree.Element, x: float, y: float) -> Steps:
    """The path of a ``rect``, ``circle`` or ``path``, moved by (x, y)."""
    tag = node.tag.removeprefix(_SVG)
    if tag == "rect":
        extent = (_at(node, "width"), _at(node, "height"), _at(node, "rx"))
        return box(x + _at(node, "x"), y + _at(node, "y"), *extent)
    if tag == "circle":
        r = _at(node, "r")
        west, level = x + _at(node, "cx") - r, y + _at(node, "cy")
        halves = (Step("A", west + 2 * r, level, r, pi), Step("A", west, level, r, pi))
        return (Step("M", west, level), *halves, Step("Z", west, level))
    return tuple(_parsed(node.attrib["d"], x, y))


def _parsed(path: str, left: float, top: float) -> Iterator[Step]:
    """The steps of a path's ``d``; commands that go on without a letter are not written here."""
    x = y = first_x = first_y = 0.0
    for kind, given in _STEP.findall(path):
        numbers = [float(n) for n in _NUMBER.findall(given)]
        start_x, start_y = x, y
        if kind.islower():
            numbers[-1] += start_x if kind == "h" else start_y
            if kind in "la":
                numbers[-2] += start_x
        match kind.upper():
            case "H":
                x = numbers[0]
            case "V":
                y = numbers[0]
            case "Z":
                x, y = first_x, first_y
                yield Step("Z", x + left, y + top)
                continue
            case _:
                x, y = numbers[-2:]
        if kind == "M":
            first_x, first_y = x, y
        if kind in "Aa":
            turn = turn_of(hypot(x - start_x, y - start_y), numbers[0], numbers[4] > 0)
            yield Step("A", x + left, y + top, numbers[0], turn)
        else:
            yield Step("M" if kind == "M" else "L", x + left, y + top)
