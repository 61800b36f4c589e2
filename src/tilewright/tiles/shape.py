"""The kinds of tile: which slots a tile has and which of them must agree across each axis.

A slot is a place that carries a color: an edge, a corner, a face. A joint says, for one axis, which
slots of a tile (its far side: east, south, bottom) must equal which slots of the next tile (its near
side: west, north, top). Everything that lays or checks tiles works from the joints alone, so Wang
tiles, corner tiles and sets with both need no separate code.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Joint = tuple[tuple[int, int], ...]
"""Pairs (slot of this tile, slot of the next tile along the axis) that must carry one color."""


@dataclass(frozen=True)
class Shape:
    """A kind of tile.

    Attributes
    ----------
    name : str
        ``"wang"``, ``"corner"``, ``"corner-coded"``, ``"domino"``, ``"wang-cube"`` or ``"corner-cube"``.
    slots : tuple of str
        Slot names in index order (Lagae 2007, section 2.7).
    joints : tuple of Joint
        One per axis, in the order x (east), y (south), z (down).
    """

    name: str
    slots: tuple[str, ...]
    joints: tuple[Joint, ...]

    @property
    def dimension(self) -> int:
        """1 for dominoes, 2 for square tiles, 3 for cubes."""
        return len(self.joints)

    def slot(self, name: str) -> int:
        """Number of the slot called ``name``."""
        return self.slots.index(name)

    def __reduce__(self) -> tuple[Callable[..., "Shape"], tuple[Any, ...]]:
        # Shapes are told by identity, so one that comes from another process must be the one here.
        return _find_shape, (self.name, self.slots, self.joints)


def _find_shape(name: str, slots: tuple[str, ...], joints: tuple[Joint, ...]) -> Shape:
    given = Shape(name, slots, joints)
    return next((known for known in _SHAPES if known == given), given)


def _joints(slots: tuple[str, ...], *axes: str) -> tuple[Joint, ...]:
    """Joints written as ``"E-W NE-NW"``, one string per axis."""
    split = [[pair.split("-") for pair in axis.split()] for axis in axes]
    return tuple(tuple((slots.index(far), slots.index(near)) for far, near in axis) for axis in split)


_NESW = ("N", "E", "S", "W")
_CORNERS = ("NE", "SE", "SW", "NW")
_EDGES_AND_CORNERS = _NESW + _CORNERS

WANG = Shape("wang", _NESW, _joints(_NESW, "E-W", "S-N"))
CORNER = Shape("corner", _CORNERS, _joints(_CORNERS, "NE-NW SE-SW", "SW-NW SE-NE"))
CORNER_CODED = Shape(
    "corner-coded",
    _EDGES_AND_CORNERS,
    _joints(_EDGES_AND_CORNERS, "E-W NE-NW SE-SW", "S-N SW-NW SE-NE"),
)

# Cubes: x east, y south, z down; U is the upper face, at the cell's own z, D the lower one.
_FACES = (*_NESW, "U", "D")
_CUBE_CORNERS = tuple(corner + face for face in "UD" for corner in _CORNERS)

DOMINO = Shape("domino", ("E", "W"), (((0, 1),),))
WANG_CUBE = Shape("wang-cube", _FACES, _joints(_FACES, "E-W", "S-N", "D-U"))
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
_SHAPES = (WANG, CORNER, CORNER_CODED, DOMINO, WANG_CUBE, CORNER_CUBE)
