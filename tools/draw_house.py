"""Draw the rooms of the house as docs/images/house.svg, from the import contract in pyproject.toml."""

import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).parents[1]
TARGET = ROOT / "docs" / "images" / "house.svg"
WIDTH, FLOOR, GAP, LEFT = 900, 46, 8, 96

HOLDS = {
    "cli": "options and a print",
    "notebook": "small pictures of things",
    "jobs": "one whole job a module: options in, files and figures out",
    "gpu": "a field on a real GPU",
    "export": "bytes for other programs",
    "analysis": "figures about results",
    "fields": "signal over tiling, evaluated anywhere",
    "files": "folders, photographs, points",
    "shaders": "what any GPU must know",
    "flows": "stored runs",
    "signals": "what a tile holds",
    "tilings": "which tile goes where",
    "samplers": "points without tiles",
    "domains": "meshes and surfaces",
    "tiles": "what may meet",
    "kernels": "compiled loops",
    "pixels": "channels and colors",
    "showing": "one line",
    "tabling": "columns",
    "sameness": "equal content",
    "seeds": "chance",
    "checks": "one clear line",
    "extras": "what is installed",
    "errors": "one family",
}
COLORS = ("#27548f", "#2f6690", "#3a7580", "#45806a", "#5d8050", "#7d7a3c", "#94703a", "#99603a", "#8a5040")


def floors() -> list[list[str]]:
    """The layers of the contract from the roof down; the ground is one floor."""
    contract = tomllib.loads((ROOT / "pyproject.toml").read_text())["tool"]["importlinter"]["contracts"][0]
    layers = [layer.split(" | ") for layer in contract["layers"] if layer != "__main__"]
    below = next(n for n, layer in enumerate(layers) if layer == ["kernels"]) + 1
    return [*layers[:below], [name for layer in layers[below:] for name in layer]]


def draw() -> str:
    """The house as SVG."""
    levels = floors()
    height = len(levels) * (FLOOR + GAP) + 76
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
        'font-family="sans-serif" font-size="13">',
        f'<path d="M{LEFT - 20} 62L{WIDTH / 2} 12L{WIDTH - 76} 62Z" fill="#8a4b3c"/>',
        f'<path d="M48 72V{height - 30}m-6 -10l6 10l6 -10" fill="none" stroke="#555" stroke-width="2"/>',
        f'<text x="30" y="{height / 2}" transform="rotate(-90 30 {height / 2})" text-anchor="middle" '
        'fill="#555">imports point down</text>',
    ]
    for number, rooms in enumerate(levels):
        top = 66 + number * (FLOOR + GAP)
        share = (WIDTH - 2 * LEFT + GAP) / len(rooms)
        for place, room in enumerate(rooms):
            left, wide = LEFT + place * share, share - GAP
            middle = left + wide / 2
            parts += [
                f'<rect x="{left:.0f}" y="{top}" width="{wide:.0f}" height="{FLOOR}" rx="3" '
                f'fill="{COLORS[min(number, len(COLORS) - 1)]}"/>',
                f'<text x="{middle:.0f}" y="{top + 19}" text-anchor="middle" fill="#fff" '
                f'font-weight="bold">{room}</text>',
                f'<text x="{middle:.0f}" y="{top + 36}" text-anchor="middle" fill="#fff" '
                f'font-size="11">{HOLDS[room]}</text>',
            ]
    return "\n".join([*parts, "</svg>", ""])


if __name__ == "__main__":
    if "--check" in sys.argv:
        sys.exit(0 if TARGET.read_text() == draw() else f"{TARGET} is old; run tools/draw_house.py")
    TARGET.write_text(draw())
