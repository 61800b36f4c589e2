"""Point sets without tiles: Poisson disks by many methods, what they are compared with, and their radius."""

from typing import TYPE_CHECKING

from tilewright.lazy import load_lazily

if TYPE_CHECKING:
    from tilewright.samplers.box import Box
    from tilewright.samplers.bridson import bridson_darts
    from tilewright.samplers.candidates import best_candidate
    from tilewright.samplers.catalog import METHODS, Method, sample_points
    from tilewright.samplers.darts import dart_throwing
    from tilewright.samplers.elimination import sample_elimination
    from tilewright.samplers.jones import jones_darts
    from tilewright.samplers.lloyd import lloyd_relaxation
    from tilewright.samplers.maximal import maximal_darts
    from tilewright.samplers.penrose import penrose_points
    from tilewright.samplers.point_set import PointSet
    from tilewright.samplers.radius import max_radius, nearest_distances, relative_radius
    from tilewright.samplers.relaxation import relaxation_darts
    from tilewright.samplers.scallops import scallop_boundary, scallop_linear, scallop_log
    from tilewright.samplers.yardsticks import hexagonal, jittered, regular, sobol, uniform

# Points are made with numba; asking for a method's name does not need it.
_HOME = {
    "METHODS": "catalog",
    "Box": "box",
    "Method": "catalog",
    "PointSet": "point_set",
    "best_candidate": "candidates",
    "bridson_darts": "bridson",
    "dart_throwing": "darts",
    "hexagonal": "yardsticks",
    "jittered": "yardsticks",
    "jones_darts": "jones",
    "lloyd_relaxation": "lloyd",
    "max_radius": "radius",
    "maximal_darts": "maximal",
    "nearest_distances": "radius",
    "penrose_points": "penrose",
    "regular": "yardsticks",
    "relative_radius": "radius",
    "relaxation_darts": "relaxation",
    "sample_elimination": "elimination",
    "sample_points": "catalog",
    "scallop_boundary": "scallops",
    "scallop_linear": "scallops",
    "scallop_log": "scallops",
    "sobol": "yardsticks",
    "uniform": "yardsticks",
}

__all__ = [
    "METHODS",
    "Box",
    "Method",
    "PointSet",
    "best_candidate",
    "bridson_darts",
    "dart_throwing",
    "hexagonal",
    "jittered",
    "jones_darts",
    "lloyd_relaxation",
    "max_radius",
    "maximal_darts",
    "nearest_distances",
    "penrose_points",
    "regular",
    "relative_radius",
    "relaxation_darts",
    "sample_elimination",
    "sample_points",
    "scallop_boundary",
    "scallop_linear",
    "scallop_log",
    "sobol",
    "uniform",
]
__getattr__, __dir__ = load_lazily(__name__, _HOME)
