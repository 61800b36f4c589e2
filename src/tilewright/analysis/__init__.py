"""Figures about results: seams, repetition, structure; spacing and spectra of points."""

from typing import TYPE_CHECKING

from tilewright.lazy import load_lazily

if TYPE_CHECKING:
    from tilewright.analysis.anything import analyze
    from tilewright.analysis.border import BorderDensity, border_density
    from tilewright.analysis.comparison import Comparison, compare
    from tilewright.analysis.contestants import list_contestants
    from tilewright.analysis.laid_points import analyze_point_tiles, lay_square
    from tilewright.analysis.plates import ZonePlate, zone_plate, zone_plate_reference
    from tilewright.analysis.point_report import (
        POINT_MEANING,
        PointReport,
        analyze_points,
        comparison_sheet,
        save_comparison,
    )
    from tilewright.analysis.report import MEANING, Report, analyze_texture
    from tilewright.analysis.sample import Sample, lay_sample
    from tilewright.analysis.spacing import (
        RadialDistribution,
        bond_order,
        coverage_radius,
        discrepancy,
        nearest_mean,
        radial_distribution,
    )
    from tilewright.analysis.spectrum import (
        LatticeSpikes,
        Spectrum,
        lattice_spikes,
        periodogram,
        power_spectrum,
        spectrum_size,
    )
    from tilewright.analysis.texture_comparison import METHOD_MEANING, compare_textures

_HOME = {
    "MEANING": "report",
    "POINT_MEANING": "point_report",
    "BorderDensity": "border",
    "Comparison": "comparison",
    "LatticeSpikes": "spectrum",
    "PointReport": "point_report",
    "METHOD_MEANING": "texture_comparison",
    "RadialDistribution": "spacing",
    "Report": "report",
    "Sample": "sample",
    "Spectrum": "spectrum",
    "ZonePlate": "plates",
    "analyze": "anything",
    "analyze_point_tiles": "laid_points",
    "analyze_points": "point_report",
    "analyze_texture": "report",
    "bond_order": "spacing",
    "border_density": "border",
    "compare": "comparison",
    "compare_textures": "texture_comparison",
    "comparison_sheet": "point_report",
    "coverage_radius": "spacing",
    "discrepancy": "spacing",
    "lattice_spikes": "spectrum",
    "lay_sample": "sample",
    "lay_square": "laid_points",
    "list_contestants": "contestants",
    "nearest_mean": "spacing",
    "periodogram": "spectrum",
    "power_spectrum": "spectrum",
    "radial_distribution": "spacing",
    "save_comparison": "point_report",
    "spectrum_size": "spectrum",
    "zone_plate": "plates",
    "zone_plate_reference": "plates",
}

__all__ = [
    "MEANING",
    "METHOD_MEANING",
    "POINT_MEANING",
    "BorderDensity",
    "Comparison",
    "LatticeSpikes",
    "PointReport",
    "RadialDistribution",
    "Report",
    "Sample",
    "Spectrum",
    "ZonePlate",
    "analyze",
    "analyze_point_tiles",
    "analyze_points",
    "analyze_texture",
    "bond_order",
    "border_density",
    "compare",
    "compare_textures",
    "comparison_sheet",
    "coverage_radius",
    "discrepancy",
    "lattice_spikes",
    "lay_sample",
    "lay_square",
    "list_contestants",
    "nearest_mean",
    "periodogram",
    "power_spectrum",
    "radial_distribution",
    "save_comparison",
    "spectrum_size",
    "zone_plate",
    "zone_plate_reference",
]
__getattr__, __dir__ = load_lazily(__name__, _HOME)
