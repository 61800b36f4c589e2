"""Make docs/images/samplers.png: points of eight methods, about as many each, with their relative radii."""

import io
from pathlib import Path

from matplotlib.figure import Figure
from PIL import Image

import tilewright as tw

TARGET = Path(__file__).parents[1] / "docs" / "images" / "samplers.png"
METHODS = ("uniform", "jittered", "elimination", "dart", "maximal", "lloyd", "scallop-boundary", "penrose")
COUNT = 500
COLUMNS, ROWS = 4, 2
WIDTH, HEIGHT = 1400, 764
DPI = 100


def main() -> None:
    """Make the picture."""
    sheet = Figure(figsize=(WIDTH / DPI, HEIGHT / DPI), dpi=DPI)
    panels = sheet.subplots(ROWS, COLUMNS)
    sheet.subplots_adjust(left=0.005, right=0.995, bottom=0.009, top=0.953, wspace=0.03, hspace=0.115)
    for panel, method in zip(panels.flat, METHODS, strict=True):
        made = tw.sample_points(method, COUNT, seed=1, box=tw.Box(torus=method != "penrose"))
        panel.scatter(*made.points.T, s=17, color="black", linewidths=0)
        panel.set(xlim=(0, 1), ylim=(1, 0), aspect="equal", xticks=[], yticks=[])
        panel.set_title(f"{method}   $\\rho$ = {made.rho:.2f}", fontsize=15, pad=5)
        for side in panel.spines.values():
            side.set_color("0.7")
    drawn = io.BytesIO()
    # Dots snap to pixels, which would move them visibly: draw larger.
    sheet.savefig(drawn, dpi=4 * DPI)
    gray = Image.open(drawn).convert("L").resize((WIDTH, HEIGHT), Image.Resampling.LANCZOS)
    gray.quantize(16).save(TARGET, optimize=True)
    print(TARGET)


if __name__ == "__main__":
    main()
