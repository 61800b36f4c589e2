"""Drawings as PDF: a page for each, in true size, their layers as layers of the PDF (ISO 32000-1).

The bytes hold no date and no number drawn by chance. Arcs are Bezier curves of at most 45 degrees, which
are within 5 millionths of their radius.
"""

import zlib
from collections.abc import Iterable, Iterator, Sequence
from io import BytesIO
from itertools import chain
from math import atan2, ceil, cos, hypot, pi, sin, tan

from tilewright.export.drawing.shapes import Clip, Drawing, Item, Path, Print, Step, Steps, Use, Words, box
from tilewright.export.drawing.svg import number
from tilewright.pixels import read_hex

_POINT = 25.4 / 72
"""Millimeters of PDF's unit."""
_LONGEST = 14400
"""Units along a page; a longer page has a larger unit (ISO 32000-1, annex C.2 and table 30)."""
_EVERYWHERE = "-32768 -32768 32767 32767"
"""The bounds of symbols, which are not cut."""
_DIGIT = 0.556
"""Width of a digit of Helvetica, for its size."""


def pdf_of(drawings: Sequence[Drawing]) -> bytes:
    """The bytes of a PDF file with a page for each drawing."""
    return _Writer().write(drawings)


def arc_of(x: float, y: float, step: Step) -> tuple[float, float, float]:
    """The center of the arc from (x, y), and the angle at which it starts from there."""
    away = step.radius * cos(step.turn / 2)
    across, down = step.x - x, step.y - y
    length = hypot(across, down)
    side = 1 if step.turn > 0 else -1
    center_x = (x + step.x) / 2 - side * away * down / length
    center_y = (y + step.y) / 2 + side * away * across / length
    return center_x, center_y, atan2(y - center_y, x - center_x)


class _Writer:
    """Objects of a file, numbered from 1 on in the order in which they are first spoken of."""

    def __init__(self) -> None:
        self._objects: list[bytes] = []
        self._forms: dict[str, int] = {}
        self._images: dict[bytes, int] = {}
        self._groups: dict[str, int] = {}

    def write(self, drawings: Sequence[Drawing]) -> bytes:
        catalog, tree, resources = (self._add(b"") for _ in range(3))
        pages = [self._page(page, drawing, tree, resources) for page, drawing in enumerate(drawings)]
        font = self._add(b"<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>")
        things = {**self._forms, **{f"I{n}": number for n, number in enumerate(self._images.values())}}
        self._put(
            resources,
            f"<< /Font << /F {font} 0 R >> /XObject << {_named(things)} >> "
            f"/Properties << {_named(self._properties())} >> >>",
        )
        kids = " ".join(f"{page} 0 R" for page in pages)
        self._put(tree, f"<< /Type /Pages /Kids [{kids}] /Count {len(pages)} >>")
        layers = " ".join(f"{group} 0 R" for group in self._groups.values())
        content = f"/OCProperties << /OCGs [{layers}] /D << /Order [{layers}] >> >>" if layers else ""
        self._put(catalog, f"<< /Type /Catalog /Pages {tree} 0 R {content} >>")
        return self._joined()

    def _properties(self) -> dict[str, int]:
        return {f"L{n}": group for n, group in enumerate(self._groups.values())}

    def _add(self, content: bytes) -> int:
        self._objects.append(content)
        return len(self._objects)

    def _put(self, place: int, content: str) -> None:
        self._objects[place - 1] = content.encode()

    def _stream(self, entries: str, content: bytes, *, packed: bool = True) -> int:
        body = zlib.compress(content, 9) if packed else content
        filters = "/Filter /FlateDecode " if packed else ""
        head = f"<< {entries} {filters}/Length {len(body)} >>\nstream\n".encode()
        return self._add(head + body + b"\nendstream")

    def _page(self, page: int, drawing: Drawing, tree: int, resources: int) -> int:
        width, height = (side * drawing.unit / _POINT for side in (drawing.width, drawing.height))
        larger = max(1, ceil(max(width, height) / _LONGEST))
        scale = drawing.unit / _POINT / larger
        for name, items in drawing.symbols.items():
            content = "\n".join(self._drawn(items, page)).encode()
            form = f"/Type /XObject /Subtype /Form /BBox [{_EVERYWHERE}] /Resources {resources} 0 R"
            self._forms[_form(page, name)] = self._stream(form, content)
        shown = [f"{scale:.9f} 0 0 {-scale:.9f} 0 {number(height / larger)} cm"]
        for layer in drawing.layers:
            drawn = self._drawn(layer.items, page)
            shown += drawn if not layer.name else [self._begin(layer.name), *drawn, "EMC"]
        stream = self._stream("", "\n".join(shown).encode())
        return self._add(
            f"<< /Type /Page /Parent {tree} 0 R /Resources {resources} 0 R /Contents {stream} 0 R /MediaBox "
            f"[0 0 {number(width / larger)} {number(height / larger)}]"
            f"{f' /UserUnit {larger}' if larger > 1 else ''} >>".encode()
        )

    def _begin(self, layer: str) -> str:
        """Marks what follows as that of a layer."""
        if layer not in self._groups:
            self._groups[layer] = self._add(f"<< /Type /OCG /Name ({layer}) >>".encode())
        return f"/OC /L{list(self._groups).index(layer)} BDC"

    def _drawn(self, items: Iterable[Item], page: int) -> Iterator[str]:
        for item in items:
            match item:
                case Path():
                    yield from _path(item)
                case Words():
                    yield _words(item)
                case Use():
                    at = f"1 0 0 1 {number(item.x)} {number(item.y)} cm"
                    yield f"q {at} /{_form(page, item.name)} Do Q"
                case Clip():
                    yield "q " + " ".join(_lines(item.steps)) + " W n"
                    yield from self._drawn(item.items, page)
                    yield "Q"
                case Print():
                    yield self._print(item)

    def _print(self, item: Print) -> str:
        """A picture whose middle fills a rectangle."""
        place, (width, height) = self._image(item.content)
        scale = max(item.width / width, item.height / height)
        across, down = width * scale, height * scale
        left, top = item.x + (item.width - across) / 2, item.y + (item.height + down) / 2
        matrix = " ".join(number(n) for n in (across, 0, 0, -down, left, top))
        frame = " ".join(_lines(box(item.x, item.y, item.width, item.height)))
        return f"q {frame} W n {matrix} cm /I{place} Do Q"

    def _image(self, content: bytes) -> tuple[int, tuple[int, int]]:
        """Which image of the file a picture is, and its size; a JPEG's bytes are kept."""
        from PIL import Image

        with Image.open(BytesIO(content)) as image:
            size = image.size
            if content not in self._images:
                is_kept = image.format == "JPEG" and image.mode in ("L", "RGB")
                space = "Gray" if is_kept and image.mode == "L" else "RGB"
                entries = f"/Type /XObject /Subtype /Image /Width {size[0]} /Height {size[1]} "
                entries += f"/BitsPerComponent 8 /ColorSpace /Device{space}"
                if is_kept:
                    place = self._stream(f"{entries} /Filter /DCTDecode", content, packed=False)
                else:
                    place = self._stream(entries, _on_paper(image))
                self._images[content] = place
        return list(self._images).index(content), size

    def _joined(self) -> bytes:
        """The file: its objects, and the table of where they begin."""
        out = bytearray(b"%PDF-1.6\n%\xe2\xe3\xcf\xd3\n")
        places = []
        for place, content in enumerate(self._objects, 1):
            places.append(len(out))
            out += f"{place} 0 obj\n".encode() + content + b"\nendobj\n"
        table = len(out)
        out += f"xref\n0 {len(places) + 1}\n0000000000 65535 f \n".encode()
        out += "".join(f"{place:010} 00000 n \n" for place in places).encode()
        size = f"/Size {len(places) + 1} /Root 1 0 R"
        return bytes(out + f"trailer\n<< {size} >>\nstartxref\n{table}\n%%EOF\n".encode())


def _form(page: int, name: str) -> str:
    return f"P{page}{name}"


def _named(objects: dict[str, int]) -> str:
    return " ".join(f"/{name} {place} 0 R" for name, place in objects.items())


def _on_paper(image: "object") -> bytes:
    """Pixels of a picture, in RGB, on white where it is transparent."""
    from PIL import Image

    assert isinstance(image, Image.Image)
    colors = image.convert("RGBA")
    paper = Image.new("RGBA", colors.size, "#ffffff")
    return Image.alpha_composite(paper, colors).convert("RGB").tobytes()


def _color(name: str) -> str:
    return " ".join(number(part / 255) for part in read_hex(name))


def _path(path: Path) -> Iterator[str]:
    inked = []
    if path.fill:
        inked.append(f"{_color(path.fill)} rg")
    if path.stroke:
        inked.append(f"{_color(path.stroke)} RG {number(path.width)} w {int(path.is_round)} J")
    yield " ".join(chain(inked, _lines(path.steps)))
    yield {(True, True): "B", (True, False): "f"}.get((bool(path.fill), bool(path.stroke)), "S")


def _lines(steps: Steps) -> Iterator[str]:
    x = y = 0.0
    for step in steps:
        if step.kind == "A":
            yield from _curves(x, y, step)
        else:
            letter = {"M": "m", "L": "l"}.get(step.kind)
            yield f"{number(step.x)} {number(step.y)} {letter}" if letter else "h"
        x, y = step.x, step.y


def _curves(x: float, y: float, step: Step) -> Iterator[str]:
    """An arc as Bezier curves, whose handles lie on its tangents (Goldapp 1991)."""
    left, top, start = arc_of(x, y, step)
    count = ceil(abs(step.turn) / (pi / 4) - 1e-9)
    turn = step.turn / count
    handle = 4 / 3 * tan(turn / 4) * step.radius
    for n in range(count):
        a, b = start + n * turn, start + (n + 1) * turn
        ends = [(left + step.radius * cos(t), top + step.radius * sin(t)) for t in (a, b)]
        points = (
            (ends[0][0] - handle * sin(a), ends[0][1] + handle * cos(a)),
            (ends[1][0] + handle * sin(b), ends[1][1] - handle * cos(b)),
            ends[1] if n + 1 < count else (step.x, step.y),
        )
        yield " ".join(number(n) for point in points for n in point) + " c"


def _words(words: Words) -> str:
    """Digits, centered; the page's y points down, so they are turned upright."""
    left = words.x - len(words.text) * _DIGIT * words.size / 2
    place = f"1 0 0 -1 {number(left)} {number(words.y)} Tm"
    return f"{_color(words.fill)} rg BT /F {number(words.size)} Tf {place} ({words.text}) Tj ET"
