from .dispatch import (
    analyze as analyze,
)
from .points.border import (
    BorderDensity as BorderDensity,
    border_density as border_density,
)
from .points.comparison import (
    Comparison as Comparison,
    compare as compare,
)
from .points.contenders import (
    list_contenders as list_contenders,
)
from .points.laid_tiles import (
    analyze_point_tiles as analyze_point_tiles,
    lay_square as lay_square,
)
from .points.meanings import (
    POINT_MEANING as POINT_MEANING,
    POINT_UNITS as POINT_UNITS,
)
from .points.plates import (
    ZonePlate as ZonePlate,
    zone_plate as zone_plate,
    zone_plate_reference as zone_plate_reference,
)
from .points.plots import (
    plot_points as plot_points,
)
from .points.report import (
    PointReport as PointReport,
    analyze_points as analyze_points,
    comparison_sheet as comparison_sheet,
    save_comparison as save_comparison,
)
from .points.spacing import (
    RadialDistribution as RadialDistribution,
    bond_order as bond_order,
    coverage_radius as coverage_radius,
    discrepancy as discrepancy,
    nearest_mean as nearest_mean,
    radial_distribution as radial_distribution,
)
from .points.spectrum import (
    LatticeSpikes as LatticeSpikes,
    Spectrum as Spectrum,
    lattice_spikes as lattice_spikes,
    periodogram as periodogram,
    power_spectrum as power_spectrum,
    spectrum_size as spectrum_size,
)
from .surfaces.pictures import (
    draw_surface as draw_surface,
)
from .surfaces.report import (
    SurfaceReport as SurfaceReport,
    analyze_surface as analyze_surface,
)
from .textures.comparison import (
    METHOD_MEANING as METHOD_MEANING,
    compare_textures as compare_textures,
)
from .textures.meanings import (
    MEANING as MEANING,
)
from .textures.report import (
    Report as Report,
    analyze_texture as analyze_texture,
)
from .textures.sample import (
    Sample as Sample,
    lay_sample as lay_sample,
)
