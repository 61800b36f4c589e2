from .analysis import (
    Comparison as Comparison,
    LatticeSpikes as LatticeSpikes,
    PointReport as PointReport,
    RadialDistribution as RadialDistribution,
    Report as Report,
    Spectrum as Spectrum,
    SurfaceReport as SurfaceReport,
    ZonePlate as ZonePlate,
    analyze as analyze,
    analyze_surface as analyze_surface,
    bond_order as bond_order,
    border_density as border_density,
    compare as compare,
    compare_textures as compare_textures,
    coverage_radius as coverage_radius,
    discrepancy as discrepancy,
    draw_surface as draw_surface,
    lattice_spikes as lattice_spikes,
    nearest_mean as nearest_mean,
    periodogram as periodogram,
    plot_points as plot_points,
    power_spectrum as power_spectrum,
    radial_distribution as radial_distribution,
    zone_plate as zone_plate,
)
from .domains import (
    Mesh as Mesh,
    Spots as Spots,
    Surface as Surface,
)
from .errors import (
    Cancelled as Cancelled,
    TilewrightError as TilewrightError,
    TilewrightWarning as TilewrightWarning,
)
from .export import (
    TileGrid as TileGrid,
    make_atlas as make_atlas,
    save_array as save_array,
    save_atlas as save_atlas,
    save_flow as save_flow,
    save_for_engine as save_for_engine,
    save_viewer as save_viewer,
    write_ktx2 as write_ktx2,
)
from .export.drawing import (
    Jigsaw as Jigsaw,
    draw_cells as draw_cells,
    draw_density as draw_density,
    draw_jigsaw as draw_jigsaw,
    draw_jigsaw_sheets as draw_jigsaw_sheets,
    draw_tiles as draw_tiles,
    draw_tiling as draw_tiling,
    draw_trails as draw_trails,
    draw_wall as draw_wall,
    paint_cells as paint_cells,
    paint_tiles as paint_tiles,
    paint_tiling as paint_tiling,
    save_animation as save_animation,
    save_drawing as save_drawing,
    save_svg as save_svg,
)
from .extras import (
    MissingExtra as MissingExtra,
)
from .fields import (
    BondBricks as BondBricks,
    BrickField as BrickField,
    HexField as HexField,
    NoiseField as NoiseField,
    PixelField as PixelField,
    PixelMap as PixelMap,
    PointField as PointField,
    PointWindow as PointWindow,
    RepeatField as RepeatField,
    SideBySide as SideBySide,
    TextureField as TextureField,
    side_by_side as side_by_side,
)
from .fields.surfaces import (
    SurfacePoints as SurfacePoints,
    refine_points as refine_points,
    surface_points as surface_points,
)
from .files import (
    find_maps as find_maps,
    load as load,
    read_image as read_image,
    read_mesh as read_mesh,
    read_points as read_points,
    ready_tiles as ready_tiles,
    save as save,
    write_image as write_image,
    write_points as write_points,
    write_surface_points as write_surface_points,
)
from .flows import (
    FLOW_TILES as FLOW_TILES,
    Flow as Flow,
    FlowTile as FlowTile,
    simulate_flow as simulate_flow,
    strew_tiles as strew_tiles,
)
from .jobs import (
    add_maps as add_maps,
    open_exemplar as open_exemplar,
    texture_tiles as texture_tiles,
)
from .notebook import (
    paint_png as paint_png,
)
from .samplers import (
    Box as Box,
    PointSet as PointSet,
    max_radius as max_radius,
    relative_radius as relative_radius,
    sample_points as sample_points,
)
from .signals.bricks import (
    BrickStyle as BrickStyle,
    brick_texture_tiles as brick_texture_tiles,
)
from .signals.points import (
    Closeness as Closeness,
    PointTiles as PointTiles,
    Spikes as Spikes,
    find_closeness as find_closeness,
    find_spikes as find_spikes,
    make_point_tiles as make_point_tiles,
    poisson_tiles as poisson_tiles,
    recursive_points as recursive_points,
)
from .signals.points.dual import (
    DualPointTiles as DualPointTiles,
    DualRows as DualRows,
    dual_point_tiles as dual_point_tiles,
)
from .signals.textures import (
    Exemplar as Exemplar,
    TextureTiles as TextureTiles,
    find_regularity as find_regularity,
    resynthesize as resynthesize,
    synthesize as synthesize,
)
from .tiles import (
    ListedTileSet as ListedTileSet,
    Shape as Shape,
    TileSet as TileSet,
    Variants as Variants,
    as_wang_tiles as as_wang_tiles,
    canonical_slots as canonical_slots,
    classed_corner_tiles as classed_corner_tiles,
    cohen_tiles as cohen_tiles,
    column_corner_tiles as column_corner_tiles,
    compact_corner_cubes as compact_corner_cubes,
    compact_wang_cubes as compact_wang_cubes,
    compact_wang_tiles as compact_wang_tiles,
    corner_coded_tiles as corner_coded_tiles,
    corner_cubes as corner_cubes,
    corner_tiles as corner_tiles,
    count_dual_tiles as count_dual_tiles,
    crossed_wang_tiles as crossed_wang_tiles,
    decode as decode,
    dominoes as dominoes,
    encode as encode,
    free_tiles as free_tiles,
    list_dual_tiles as list_dual_tiles,
    shifted_wang_tiles as shifted_wang_tiles,
    summed_wang_tiles as summed_wang_tiles,
    tile_set as tile_set,
    wang_cubes as wang_cubes,
    wang_tiles as wang_tiles,
)
from .tiles.aperiodic import (
    APERIODIC_SETS as APERIODIC_SETS,
    aperiodic_tiles as aperiodic_tiles,
)
from .tiles.blocks import (
    drop_idle as drop_idle,
    possible_blocks as possible_blocks,
)
from .tiles.bricks import (
    brick_tiles as brick_tiles,
)
from .tiles.lifting import (
    Lifting as Lifting,
    check_lifting as check_lifting,
)
from .tiles.merging import (
    grouped_subdivision as grouped_subdivision,
    merge_colors as merge_colors,
)
from .tiles.transducers import (
    Transducer as Transducer,
    find_period as find_period,
    strip as strip,
)
from .tiles.translations import (
    as_corner_tiles as as_corner_tiles,
    translation_is_sound as translation_is_sound,
)
from .tilings import (
    ArrayTiling as ArrayTiling,
    Domain as Domain,
    LatticeHash as LatticeHash,
    LongPeriodHash as LongPeriodHash,
    MixerHash as MixerHash,
    Packing as Packing,
    PackingSearch as PackingSearch,
    PermutationHash as PermutationHash,
    Placements as Placements,
    Tiling as Tiling,
    array_tiling as array_tiling,
    classify_packings as classify_packings,
    count_packings as count_packings,
    density_tiling as density_tiling,
    direct as direct,
    extend_packing as extend_packing,
    filled_tiling as filled_tiling,
    packing as packing,
    periodic_tiling as periodic_tiling,
    random_packing as random_packing,
    recursive_packing as recursive_packing,
    scanline as scanline,
    stochastic as stochastic,
)
from .tilings.aperiodic import (
    aperiodic_tiling as aperiodic_tiling,
    translated_tiling as translated_tiling,
)
from .tilings.bricks import (
    BrickRegion as BrickRegion,
    EndlessBrickTiling as EndlessBrickTiling,
    brick_region as brick_region,
    brick_tiling as brick_tiling,
    endless_brick_tiling as endless_brick_tiling,
)
from .tilings.dappled import (
    Closest as Closest,
    Conditions as Conditions,
    EndlessDappledTiling as EndlessDappledTiling,
    Impossible as Impossible,
    closest_dapple as closest_dapple,
    complete_dapple as complete_dapple,
    count_dappled as count_dappled,
    dapple as dapple,
    dapple_formula as dapple_formula,
    endless_dappled_tiling as endless_dappled_tiling,
    find_violations as find_violations,
    random_start as random_start,
    rectify as rectify,
    start_from_image as start_from_image,
)

__version__: str
