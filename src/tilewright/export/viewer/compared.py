"""What the page holds to compare five methods on one photograph."""

import base64
import html
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright.export.display import screen_bytes
from tilewright.export.viewer.parts import fill, part
from tilewright.export.viewer.patches import describe_patches
from tilewright.export.viewer.pictures import describe_map, describe_tone, encode_png, mean_color
from tilewright.export.viewer.sets import describe_set
from tilewright.fields import TextureField
from tilewright.fields.photos.contenders import Contender, SideBySide
from tilewright.fields.photos.gaussian import gaussianize
from tilewright.fields.photos.methods import NoiseField, patch_range, triangle_grid
from tilewright.pixels import without_alpha
from tilewright.signals.textures import TextureTiles, copy_from_sources

# Figure -> (head of its column, what it says); those of contrast share a column.
_COLUMNS = {
    "fetches": ("Fetches", "Texture fetches for a sample, and fetches from a small table"),
    "repetition": ("Repeat", "How much comes back in step with the method's lattice: 1 all, 0 nothing"),
    "contrast": (
        "Contrast %",
        "Share of the photograph's contrast that is kept: finest details / eight times as large",
    ),
    "strangeness": ("Strange", "How unlike the photograph small pieces are; 1 is the photograph repeated"),
}
_KEYS = (("C", "next method"), ("V", "show two methods"), ("X", "swap them"))


def describe_comparison(compare: SideBySide, seed: int) -> dict[str, Any]:
    """Photograph, tile sets and methods; all show the photograph as the same bytes."""
    name = compare.material.main
    light = compare.material.kinds[name] == "color"
    photo, note, _ = screen_bytes(compare.photo, light)
    if light:
        photo = np.ascontiguousarray(without_alpha(photo))
    planes = []
    for one in compare.contenders.values():
        plane: dict[str, Any] = {"name": one.name, "label": one.label}
        if isinstance(one.field, TextureField):
            tiles = one.field.material
            shown, span = _shown_tiles(tiles, name, photo)
            tone = describe_tone(tiles, name, span)
            plane["tiles"] = describe_set(
                tiles.tiles, tiles.variants, seed, [describe_map(name, shown, light, tone)], tiles.tone
            )
            plane["own"] = tiles is compare.material
            if plane["own"]:  # the patches of the other set are made for the page, none can be rejected
                plane["tiles"]["patches"] = describe_patches(tiles)
        else:
            plane["photo"] = "gauss" if isinstance(one.field, NoiseField) else "color"
            plane["defines"] = f"#define PHOTO_{one.name.upper()}"
        planes.append(plane)
    return {
        "maps": [{"name": name, "note": note}],
        "planes": planes,
        "photo": _describe_photo(photo, light),
    }


def _shown_tiles(tiles: TextureTiles, name: str, photo: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], float]:
    """Tiles in the bytes of the photograph; where tone is laid over them, what they hold. And their span."""
    if tiles.tone is None:
        return copy_from_sources(({name: photo},), tiles.origins)[name], 1.0
    light = tiles.kinds[name] == "color"
    shown, _, span = screen_bytes(tiles.maps[name], light)
    return np.ascontiguousarray(without_alpha(shown)) if light else shown, span


def _describe_photo(photo: NDArray[np.uint8], light: bool) -> dict[str, Any]:
    gauss, size = gaussianize(photo / 255), photo.shape[:2]
    return {
        "width": photo.shape[1],
        "height": photo.shape[0],
        "light": light,
        "mean": mean_color(photo, light),
        "images": {"color": encode_png(photo), "gauss": encode_png(gauss.pixels)},
        "grid": triangle_grid(size),
        "range": [number for pair in patch_range(size) for number in pair],
        "inverse": _describe_table(gauss.table),
        **_describe_axes(gauss.axes, gauss.mean),
    }


def _describe_table(table: NDArray[np.float32]) -> dict[str, Any]:
    """Rows of four floats; a gray photograph has three channels alike."""
    levels, entries, channels = table.shape
    wide = np.zeros((levels, entries, 4), "<f4")
    wide[..., :3] = table if channels == 3 else np.repeat(table, 3, axis=2)
    return {"levels": levels, "entries": entries, "values": base64.b64encode(wide.tobytes()).decode()}


def _describe_axes(axes: NDArray[np.float64], mean: NDArray[np.float64]) -> dict[str, Any]:
    if len(mean) == 1:
        axes, mean = np.eye(3) * axes[0, 0], np.repeat(mean, 3)
    return {"axes": axes.ravel().tolist(), "average": mean.tolist()}


def fill_comparison(compare: SideBySide | None) -> dict[str, str]:
    """Controls and table of a comparison; nothing where there is none."""
    if compare is None:
        return {"divider": "", "comparison": "", "comparison_keys": ""}
    found = compare.contenders.values()
    options = "".join(f'<option value="{one.name}">{html.escape(one.label)}</option>' for one in found)
    columns = {name: texts for name, texts in _COLUMNS.items() if name == "fetches" or compare.figures}
    heads = "".join(f'<th scope="col" title="{says}">{head}</th>' for head, says in columns.values())
    rows = "".join(_row(one, compare.figures.get(one.name)) for one in found)
    return {
        "divider": part("divider.html"),
        "comparison": fill("comparison.html", options=options, heads=heads, rows=rows),
        "comparison_keys": "".join(f"<dt><kbd>{key}</kbd></dt><dd>{does}</dd>" for key, does in _KEYS),
    }


def _row(one: Contender, figures: dict[str, float] | None) -> str:
    cells = [f"{one.fetches} + {one.table_fetches}" if one.table_fetches else str(one.fetches)]
    if figures:
        contrast = (f"{100 * figures[f'{which}_contrast']:.0f}" for which in ("fine", "coarse"))
        cells += [
            f"{max(0.0, figures['repetition']):.2f}",
            " / ".join(contrast),
            f"{figures['strangeness']:.2f}",
        ]
    return (
        f'<tr data-method="{one.name}"><th scope="row">{html.escape(one.label)}</th>'
        + "".join(f"<td>{cell}</td>" for cell in cells)
        + "</tr>"
    )
