"""What a file says of its points besides where they are: their box, how they were made, what is promised."""

import json
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tilewright import __version__
from tilewright.errors import TilewrightValueError
from tilewright.samplers.box import Box
from tilewright.samplers.point_set import PointSet

MARK = "tilewright"
"""What a note begins with in a text, and its key in Parquet."""


@dataclass(frozen=True)
class PointNote:
    """What is known of points besides their places.

    Attributes
    ----------
    box : Box
        The domain, whose first corner is at the origin.
    corner : tuple of float
        Where that corner lies in the coordinates of the file.
    method : str
        Name of the method that made them; empty where it is not known.
    distance : float
        No two points are closer; 0 where nothing is promised.
    figures : dict
        What else is known, such as seeds.
    program : str
        The version that wrote the file.
    """

    box: Box
    corner: tuple[float, ...] = (0.0, 0.0)
    method: str = ""
    distance: float = 0.0
    figures: dict[str, Any] = field(default_factory=dict)
    program: str = f"tilewright {__version__}"

    @classmethod
    def of(cls, points: PointSet) -> "PointNote":
        """What a set knows of itself; a ``corner`` among its figures is where the box begins in the file."""
        figures = dict(points.figures)
        corner = figures.pop("corner", (0.0, 0.0))
        return cls(points.box, tuple(map(float, corner)), points.method, float(points.distance), figures)

    @classmethod
    def parse(cls, text: str | bytes) -> "PointNote":
        """From what `text` wrote, now or in an older version; a ValueError where it is something else."""
        said = json.loads(text)
        try:
            return cls(
                Box(tuple(said["extent"]), bool(said["torus"])),
                tuple(float(c) for c in said.get("corner", (0, 0))),
                str(said.get("method", "")),
                float(said.get("distance", 0)),
                dict(said.get("figures", {})),
                str(said.get("program", "")),
            )
        except (TypeError, KeyError) as error:
            raise TilewrightValueError(f"the note on its points lacks or spoils {error}") from None

    def fields(self) -> dict[str, Any]:
        """Its parts by name, as JSON holds them."""
        return {
            "program": self.program,
            "extent": list(self.box.extent),
            "torus": self.box.torus,
            "corner": list(self.corner),
            "method": self.method,
            "distance": self.distance,
            "figures": self.figures,
        }

    def text(self) -> str:
        """As JSON, in one line."""
        return json.dumps(self.fields(), default=_plain)

    def place(self, points: NDArray[np.float64], box: Box | None, method: str) -> PointSet:
        """The set of a file's points, moved so that the box begins at the origin."""
        given = box or self.box
        if any(self.corner):
            points = np.minimum(points - self.corner, np.nextafter(given.extent, 0))
        figures = {**self.figures, **({"corner": self.corner} if any(self.corner) else {})}
        return PointSet(given.check_points(points), given, self.method or method, self.distance, figures)


def _plain(value: Any) -> Any:
    """What JSON does not know: arrays and their numbers, else in words."""
    return value.tolist() if hasattr(value, "tolist") else str(value)
