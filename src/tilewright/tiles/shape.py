"""The kinds of tile: which slots a tile has and which of them must agree across each axis.

A slot is a place that carries a color: an edge, a corner, a face. A joint says which slots of a tile (its
far side: east, south, bottom) must equal which slots of the tile one step on (its near side: west, north,
top). Everything that lays or checks tiles works from the joints alone, so Wang tiles, corner tiles and sets
with both need no separate code.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from tilewright.errors import TilewrightValueError

Joint = tuple[tuple[int, int], ...]
"""Pairs (slot of this tile, slot of the tile one step on) that must carry one color."""


@dataclass(frozen=True)
class Shape:
    """A kind of tile: which slots it has, and which of them meet along each axis.

    Attributes
    ----------
    name : str
        ``"wang"``, ``"corner"``, ``"corner-coded"``, ``"domino"``, ``"wang-cube"``, ``"corner-cube"`` or
        ``"free"``.
    slots : tuple of str
        Slot names in index order, such as ``("N", "E", "S", "W")``.
    joints : tuple of Joint
        What must agree, for each step. A joint is a tuple of pairs: a slot of a tile, and the slot of the
        next tile along the step that must carry the same color.
    steps : tuple of tuple of int
        Cells from a tile to the one that a joint speaks of, x first; by default one joint along each axis, in
        the order x (east), y (south), z (down). Several joints may have one step, and steps may be slanted,
        as between hexagons in rows that are shifted.

    Raises
    ------
    TilewrightValueError
        There are not as many steps as joints, or steps of different lengths.

    Notes
    -----
    The order of the slots is that of Lagae 2007, section 2.7. The thesis lets y grow up; here it grows south,
    so that rows come in the order of a picture.
    """

    name: str
    slots: tuple[str, ...]
    joints: tuple[Joint, ...]
    steps: tuple[tuple[int, ...], ...] = ()

    def __post_init__(self) -> None:
        if not self.steps:
            object.__setattr__(self, "steps", _axes(len(self.joints)))
        if len(self.steps) != len(self.joints) or len({len(step) for step in self.steps}) != 1:
            raise TilewrightValueError(
                f"is {self.steps}; {len(self.joints)} joints need as many steps, all of one length",
                argument="steps",
                value=self.steps,
            )

    @property
    def dimension(self) -> int:
        """1 for dominoes, 2 for square tiles, 3 for cubes."""
        return len(self.steps[0])

    def across(self, axis: int) -> Joint:
        """List all pairs of slots that must agree between a tile and the next along an axis.

        Parameters
        ----------
        axis : int
            0 for x, 1 for y, 2 for z.

        Returns
        -------
        Joint
            Pairs of slots: of the tile, and of the next one.

        Raises
        ------
        TilewrightValueError
            Some tiles meet otherwise than along an axis.
        """
        axes = _axes(self.dimension)
        if not set(self.steps) <= set(axes):
            raise TilewrightValueError(
                f"{self.name} tiles meet across steps {', '.join(map(str, self.steps))}; this is for tiles "
                "that meet along the axes alone"
            )
        joints = zip(self.steps, self.joints, strict=True)
        return tuple(pair for step, joint in joints if step == axes[axis] for pair in joint)

    def slot(self, name: str) -> int:
        """Give the number of a slot.

        Parameters
        ----------
        name : str
            Name of the slot, one of ``slots``.

        Returns
        -------
        int
            Its place in ``slots``, from 0 on.

        Raises
        ------
        ValueError
            The shape has no slot of that name.
        """
        return self.slots.index(name)

    def __reduce__(self) -> tuple[Callable[..., "Shape"], tuple[Any, ...]]:
        # Shapes are told by identity, so one that comes from another process must be the one here.
        return _find_shape, (self.name, self.slots, self.joints, self.steps)


def _find_shape(name: str, *parts: Any) -> Shape:
    given = Shape(name, *parts)
    return next((known for known in _SHAPES if known == given), given)


def _axes(dimension: int) -> tuple[tuple[int, ...], ...]:
    """A step along each axis, x first."""
    return tuple(tuple(int(a == b) for b in range(dimension)) for a in range(dimension))


def _joints(slots: tuple[str, ...], *axes: str) -> tuple[Joint, ...]:
    """Joints written as ``"E-W NE-NW"``, one string per axis."""
    split = [[pair.split("-") for pair in axis.split()] for axis in axes]
    return tuple(tuple((slots.index(far), slots.index(near)) for far, near in axis) for axis in split)


_NESW = ("N", "E", "S", "W")
_CORNERS = ("NE", "SE", "SW", "NW")
_EDGES_AND_CORNERS = _NESW + _CORNERS

WANG = Shape("wang", _NESW, _joints(_NESW, "E-W", "S-N"))
"""Wang tiles: colored edges N, E, S, W."""
CORNER = Shape("corner", _CORNERS, _joints(_CORNERS, "NE-NW SE-SW", "SW-NW SE-NE"))
"""Corner tiles: colored corners NE, SE, SW, NW."""
CORNER_CODED = Shape(
    "corner-coded",
    _EDGES_AND_CORNERS,
    _joints(_EDGES_AND_CORNERS, "E-W NE-NW SE-SW", "S-N SW-NW SE-NE"),
)
"""Wang tiles with colored corners too: N, E, S, W, NE, SE, SW, NW."""

FREE = Shape("free", ("tile",), ((), ()))
"""Tiles that may meet anywhere: their one slot says which they are."""

# Cubes: x east, y south, z down; U is the upper face, at the cell's own z, D the lower one.
_FACES = (*_NESW, "U", "D")
_CUBE_CORNERS = tuple(corner + face for face in "UD" for corner in _CORNERS)

DOMINO = Shape("domino", ("E", "W"), (((0, 1),),))
"""Dominoes: colored ends E and W."""
WANG_CUBE = Shape("wang-cube", _FACES, _joints(_FACES, "E-W", "S-N", "D-U"))
"""Wang cubes: colored faces N, E, S, W, U, D."""
CORNER_CUBE = Shape(
    "corner-cube",
    _CUBE_CORNERS,
    _joints(
        _CUBE_CORNERS,
        "NEU-NWU SEU-SWU NED-NWD SED-SWD",
        "SWU-NWU SEU-NEU SWD-NWD SED-NED",
        "NED-NEU SED-SEU SWD-SWU NWD-NWU",
    ),
)
"""Corner cubes: colored corners NEU, SEU, SWU, NWU, NED, SED, SWD, NWD."""
_SHAPES = (WANG, CORNER, CORNER_CODED, FREE, DOMINO, WANG_CUBE, CORNER_CUBE)
