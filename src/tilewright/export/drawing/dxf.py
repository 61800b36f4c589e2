"""Drawings as DXF R12, in millimeters: the version that laser cutters, plotters and all CAD programs read.

Outlines are polylines whose arcs are arcs, by their bulge; nothing is filled. A layer is that of the drawing,
or where it has none, that of the color in AutoCAD's index. Reference: Autodesk, DXF Reference.
"""

import colorsys
from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cache
from itertools import pairwise
from math import tan

from tilewright.export.drawing.outlines import clipped, without_seams
from tilewright.export.drawing.shapes import Clip, Drawing, Item, Layer, Path, Steps, Use, Words
from tilewright.export.drawing.svg import number
from tilewright.pixels import read_hex

Pair = tuple[int, str | int | float]

_PAPER = "#ffffff"
_DIGIT = 0.71
"""Height of a digit, for the size of its font."""
_NAMED = (0b100, 0b110, 0b010, 0b011, 0b001, 0b101)
"""Red, yellow, green, cyan, blue, magenta."""
_VALUES = (1.0, 0.65, 0.5, 0.3, 0.15)
_GRAYS = {7: 0, 8: 128, 9: 192, 255: 255}


def dxf_of(drawing: Drawing) -> str:
    """The text of a DXF file."""
    writer = _Writer(drawing)
    entities = [pair for layer in drawing.layers for pair in writer.entities(layer)]
    width, height = drawing.width * drawing.unit, drawing.height * drawing.unit
    pairs: list[Pair] = [
        (0, "SECTION"), (2, "HEADER"),
        (9, "$ACADVER"), (1, "AC1009"),
        (9, "$INSUNITS"), (70, 4), (9, "$MEASUREMENT"), (70, 1),  # millimeters
        (9, "$EXTMIN"), (10, 0.0), (20, 0.0), (30, 0.0),
        (9, "$EXTMAX"), (10, width), (20, height), (30, 0.0),
        (0, "ENDSEC"),
        (0, "SECTION"), (2, "TABLES"),
        (0, "TABLE"), (2, "LTYPE"), (70, 1),
        (0, "LTYPE"), (2, "CONTINUOUS"), (70, 0), (3, "Solid line"), (72, 65), (73, 0), (40, 0.0),
        (0, "ENDTAB"),
        (0, "TABLE"), (2, "LAYER"), (70, len(writer.layers)),
        *(pair for name, color in writer.layers.items() for pair in _layer(name, color)),
        (0, "ENDTAB"), (0, "ENDSEC"),
        (0, "SECTION"), (2, "ENTITIES"), *entities, (0, "ENDSEC"), (0, "EOF"),
    ]  # fmt: skip
    return "".join(f"{code}\n{_text(value)}\n" for code, value in pairs)


@cache
def nearest_index(color: str) -> int:
    """The color of AutoCAD's index that is nearest to ``#rrggbb``."""
    wanted = read_hex(color)
    return min(
        _indexed(), key=lambda n: sum((a - b) ** 2 for a, b in zip(_indexed()[n], wanted, strict=True))
    )


@cache
def _indexed() -> dict[int, tuple[int, ...]]:
    """Colors 1 to 6, then 24 hues of five values, each full and pale; grays, of which 7 is black on paper."""
    found = {n: tuple(255 * (bits >> k & 1) for k in (2, 1, 0)) for n, bits in enumerate(_NAMED, 1)}
    for hue in range(24):
        for place, value in enumerate(_VALUES):
            for pale in (0, 1):
                color = colorsys.hsv_to_rgb(hue / 24, 1 - pale / 2, value)
                found[10 + 10 * hue + 2 * place + pale] = tuple(int(255 * part) for part in color)
    return found | {n: (gray,) * 3 for n, gray in _GRAYS.items()}


def _layer(name: str, color: int) -> tuple[Pair, ...]:
    return ((0, "LAYER"), (2, name), (70, 0), (62, color), (6, "CONTINUOUS"))


def _text(value: str | int | float) -> str:
    return number(value) if isinstance(value, float) else str(value)


class _Writer:
    """Entities, with y north from the sheet's south-west corner; and the layers that they are on."""

    def __init__(self, drawing: Drawing) -> None:
        self._drawing = drawing
        self.layers: dict[str, int] = {"0": 7}

    def entities(self, layer: Layer) -> Iterator[Pair]:
        for item in _flat(layer.items, self._drawing):
            color = (item.stroke or item.fill or _PAPER) if isinstance(item, Path) else item.fill
            if color == _PAPER:
                continue  # paper, not a part of what is made
            index = nearest_index(color)
            look = self._look(layer.name or f"color-{index}", index)
            if isinstance(item, Words):
                yield from self._words(item, look)
            else:
                for line in _split(without_seams(item)):
                    yield from self._polyline(line, look)

    def _look(self, layer: str, color: int) -> tuple[Pair, Pair]:
        self.layers.setdefault(layer, color)
        return (8, layer), (62, color)

    def _place(self, x: float, y: float, first: int = 10) -> tuple[Pair, ...]:
        unit, height = self._drawing.unit, self._drawing.height
        return (first, float(x * unit)), (first + 10, float((height - y) * unit))

    def _words(self, words: Words, look: tuple[Pair, Pair]) -> Iterator[Pair]:
        yield from ((0, "TEXT"), *look, *self._place(words.x, words.y))
        yield from ((40, float(words.size * _DIGIT * self._drawing.unit)), (1, words.text), (72, 1))
        yield from self._place(words.x, words.y, 11)

    def _polyline(self, steps: Steps, look: tuple[Pair, Pair]) -> Iterator[Pair]:
        """A line whose vertices tell how far the arc to the next one turns; no arc is a turn of 0."""
        is_closed = steps[-1].kind == "Z"
        points = list(steps[:-1] if is_closed else steps)
        turns = [step.turn for step in points[1:]] + [0.0]
        if is_closed and (points[0].x, points[0].y) == (points[-1].x, points[-1].y):
            points.pop()
            turns.pop()
        yield from ((0, "POLYLINE"), *look, (66, 1), (10, 0.0), (20, 0.0), (30, 0.0), (70, int(is_closed)))
        for point, turn in zip(points, turns, strict=True):
            yield from ((0, "VERTEX"), look[0], *self._place(point.x, point.y))
            if turn:
                yield (42, f"{-tan(turn / 4):.9f}")  # y points north here
        yield from ((0, "SEQEND"), look[0])


def _flat(items: Iterable[Item], drawing: Drawing, x: float = 0, y: float = 0) -> Iterator[Path | Words]:
    """Paths and words, symbols taken apart, lines cut where they are clipped; pictures left out."""
    for item in items:
        match item:
            case Path():
                yield replace(item, steps=tuple(s._replace(x=s.x + x, y=s.y + y) for s in item.steps))
            case Words():
                yield replace(item, x=item.x + x, y=item.y + y)
            case Use():
                yield from _flat(drawing.symbols[item.name], drawing, x + item.x, y + item.y)
            case Clip():
                for shape in _flat(item.items, drawing, x, y):
                    if isinstance(shape, Path):
                        yield replace(shape, steps=clipped(shape, item.steps))


def _split(steps: Steps) -> Iterator[Steps]:
    """The parts of a path, each from where it begins."""
    starts = [n for n, step in enumerate(steps) if step.kind == "M"]
    for start, end in pairwise([*starts, len(steps)]):
        yield steps[start:end]
