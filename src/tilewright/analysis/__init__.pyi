from .dispatch import (
    analyze as analyze,
)
from .points.border import (
    BorderDensity as BorderDensity,
)
from .points.border import (
    border_density as border_density,
)
from .points.comparison import (
    Comparison as Comparison,
)
from .points.comparison import (
    compare as compare,
)
from .points.contenders import (
    list_contenders as list_contenders,
)
from .points.laid_tiles import (
    analyze_point_tiles as analyze_point_tiles,
)
from .points.laid_tiles import (
    lay_square as lay_square,
)
from .points.plates import (
    ZonePlate as ZonePlate,
)
from .points.plates import (
    zone_plate as zone_plate,
)
from .points.plates import (
    zone_plate_reference as zone_plate_reference,
)
from .points.report import (
    POINT_MEANING as POINT_MEANING,
)
from .points.report import (
    PointReport as PointReport,
)
from .points.report import (
    analyze_points as analyze_points,
)
from .points.report import (
    comparison_sheet as comparison_sheet,
)
from .points.report import (
    save_comparison as save_comparison,
)
from .points.spacing import (
    RadialDistribution as RadialDistribution,
)
from .points.spacing import (
    bond_order as bond_order,
)
from .points.spacing import (
    coverage_radius as coverage_radius,
)
from .points.spacing import (
    discrepancy as discrepancy,
)
from .points.spacing import (
    nearest_mean as nearest_mean,
)
from .points.spacing import (
    radial_distribution as radial_distribution,
)
from .points.spectrum import (
    LatticeSpikes as LatticeSpikes,
)
from .points.spectrum import (
    Spectrum as Spectrum,
)
from .points.spectrum import (
    lattice_spikes as lattice_spikes,
)
from .points.spectrum import (
    periodogram as periodogram,
)
from .points.spectrum import (
    power_spectrum as power_spectrum,
)
from .points.spectrum import (
    spectrum_size as spectrum_size,
)
from .textures.comparison import (
    METHOD_MEANING as METHOD_MEANING,
)
from .textures.comparison import (
    compare_textures as compare_textures,
)
from .textures.report import (
    MEANING as MEANING,
)
from .textures.report import (
    Report as Report,
)
from .textures.report import (
    analyze_texture as analyze_texture,
)
from .textures.sample import (
    Sample as Sample,
)
from .textures.sample import (
    lay_sample as lay_sample,
)
