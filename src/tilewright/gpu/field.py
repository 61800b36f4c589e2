"""A texture field drawn by a GPU: the tile of each pixel is found in the fragment shader."""

from typing import Any

from numpy.typing import NDArray

from tilewright.errors import TilewrightValueError
from tilewright.fields.agreement import check_agreement
from tilewright.gpu.cameras import Camera, Sight
from tilewright.gpu.device import open_gpu
from tilewright.gpu.painter import Painter
from tilewright.gpu.pixels import PixelFormat
from tilewright.shaders.hashing import ToneView, shader_hash, view_bytes
from tilewright.shaders.layouts import check_set, even_variants, make_layout, with_tone
from tilewright.shaders.mipmaps import Mipmaps, tone_levels
from tilewright.signals.textures import TextureTiles
from tilewright.tilings import Tiling
from tilewright.tilings.algorithms import CLASSED, CORNERS, EDGES
from tilewright.tilings.direct_tiling import DirectTiling
from tilewright.tilings.streams import TONES, VARIANTS


class GpuField:
    """Texture tiles laid by a direct tiling, drawn on a GPU (Lagae & Dutré 2006, section 6).

    Parameters
    ----------
    material : TextureTiles
        Over a complete or classed set of corner tiles, or a complete one of Wang tiles (Wei 2004), with as
        many variants of every tile, drawn alike: layers one after another, or packings side by side.
    tiling : Tiling
        ``direct(material.tiles, seed)``, with the mixer or a permutation table as its hash.
    layout : str, optional
        ``"array"``: a layer for each tile, with gutters; ``"atlas"``: all tiles packed into one picture, for
        Wang tiles with Wei's second picture for what is near corners. By default an array up to 256 pictures.
    map : str, optional
        Which map; the main one by default.

    Attributes
    ----------
    mipmaps : tuple of Mipmaps
        What is in the textures.

    Raises
    ------
    GpuError
        There is no GPU or no wgpu, the shader is refused, or the textures are too large.
    TilewrightValueError
        A set, variants or a tiling that have no shader.

    Notes
    -----
    Where every pixel is one texel the picture is `TextureField.render`, byte for byte. 8-bit maps are kept as
    they are (light as sRGB textures, so that filters average it linearly); 16-bit and float maps are stored
    as 32-bit floats, which a GPU must be able to filter. Tone outside the tiles is laid by three fetches from
    a small picture, within two 255ths of what the CPU lays.
    """

    def __init__(
        self, material: TextureTiles, tiling: Tiling, *, layout: str | None = None, map: str | None = None
    ) -> None:
        check_agreement(material, TextureTiles, tiling)
        check_set(material.tiles)
        tiles, name = material.tiles, material.main if map is None else map
        toned = {} if material.tone is None else material.tone.maps
        counts = (tiles.parameters["colors"],) if tiles.family == "classed" else tiles.colors
        chance = check_tiling(tiling).hash
        hash = shader_hash(chance, counts, even_variants(material), tone=name in toned)
        lookup = make_layout(material, layout, map)
        if name in toned:
            lookup = with_tone(lookup, material, name)
        pixels = PixelFormat.of(material.maps[name], material.kinds[name])
        self.material, self.tiling, self.layout = material, tiling, lookup.name
        self.mipmaps: tuple[Mipmaps, ...] = lookup.textures
        self._hash, self._density = hash, lookup.density
        self._painter = Painter(open_gpu(), lookup, hash, pixels, tone_levels(material, name))

    def render(self, camera: Camera) -> NDArray[Any]:
        """Draw what a camera sees.

        Parameters
        ----------
        camera : OrthographicCamera or PerspectiveCamera
            Where the plane is seen from, and the size of the picture.

        Returns
        -------
        array, shape (height, width, channels)
            Pixels of the map's type, 0 in all channels where the camera sees the sky.

        Raises
        ------
        TilewrightTypeError
            Something else than one of the cameras.
        TilewrightValueError
            The camera sees cells that are too far out.
        """
        return self._painter.paint(camera, self.material.tile_size, self._view)

    def _view(self, sight: Sight) -> bytes:
        states, origin = self._hash.place(*(self._density * cell for cell in sight.cell))
        draws, cell = self._hash.place(*sight.cell, stream=VARIANTS)
        classes, step = (self.material.tiles.parameters.get(n, 1) for n in ("classes", "step"))
        place = (sight.cell[0] + step * sight.cell[1]) % classes
        return view_bytes(sight.rows, states, origin, draws, cell, place, self._tone_view(sight))

    def _tone_view(self, sight: Sight) -> ToneView:
        span = 1 if self.material.tone is None else self.material.tone.span
        (x, left), (y, top) = (divmod(cell, span) for cell in sight.cell)
        states, square = self._hash.place(x, y, stream=TONES)
        return ToneView(states, square, (left, top))


def check_tiling(tiling: Tiling) -> DirectTiling:
    """The tiling, if a shader can evaluate it."""
    if not isinstance(tiling, DirectTiling) or tiling.algorithm not in (CLASSED, CORNERS, EDGES):
        raise TilewrightValueError(
            "the tiling is not one that a GPU evaluates",
            advice="use direct(tiles, seed), with wang='edge-hash'",
        )
    if any(period is not None for period in tiling.domain.periods):
        raise TilewrightValueError(
            f"the tiling repeats after {tiling.domain.periods} cells; on a GPU tilings are endless: "
            "leave out period"
        )
    return tiling
