from .analysis import (
    Comparison as Comparison,
)
from .analysis import (
    LatticeSpikes as LatticeSpikes,
)
from .analysis import (
    PointReport as PointReport,
)
from .analysis import (
    RadialDistribution as RadialDistribution,
)
from .analysis import (
    Report as Report,
)
from .analysis import (
    Spectrum as Spectrum,
)
from .analysis import (
    ZonePlate as ZonePlate,
)
from .analysis import (
    analyze as analyze,
)
from .analysis import (
    bond_order as bond_order,
)
from .analysis import (
    border_density as border_density,
)
from .analysis import (
    compare as compare,
)
from .analysis import (
    compare_textures as compare_textures,
)
from .analysis import (
    coverage_radius as coverage_radius,
)
from .analysis import (
    discrepancy as discrepancy,
)
from .analysis import (
    lattice_spikes as lattice_spikes,
)
from .analysis import (
    nearest_mean as nearest_mean,
)
from .analysis import (
    periodogram as periodogram,
)
from .analysis import (
    power_spectrum as power_spectrum,
)
from .analysis import (
    radial_distribution as radial_distribution,
)
from .analysis import (
    zone_plate as zone_plate,
)
from .errors import (
    Cancelled as Cancelled,
)
from .errors import (
    TilewrightError as TilewrightError,
)
from .errors import (
    TilewrightWarning as TilewrightWarning,
)
from .export import (
    make_atlas as make_atlas,
)
from .export import (
    save_array as save_array,
)
from .export import (
    save_atlas as save_atlas,
)
from .export import (
    save_flow as save_flow,
)
from .export import (
    save_for_engine as save_for_engine,
)
from .export import (
    save_viewer as save_viewer,
)
from .export import (
    write_ktx2 as write_ktx2,
)
from .export.drawing import (
    Jigsaw as Jigsaw,
)
from .export.drawing import (
    draw_cells as draw_cells,
)
from .export.drawing import (
    draw_density as draw_density,
)
from .export.drawing import (
    draw_jigsaw as draw_jigsaw,
)
from .export.drawing import (
    draw_tiles as draw_tiles,
)
from .export.drawing import (
    draw_tiling as draw_tiling,
)
from .export.drawing import (
    draw_trails as draw_trails,
)
from .export.drawing import (
    draw_wall as draw_wall,
)
from .export.drawing import (
    paint_cells as paint_cells,
)
from .export.drawing import (
    paint_tiles as paint_tiles,
)
from .export.drawing import (
    paint_tiling as paint_tiling,
)
from .export.drawing import (
    save_animation as save_animation,
)
from .export.drawing import (
    save_svg as save_svg,
)
from .fields import (
    BondBricks as BondBricks,
)
from .fields import (
    BrickField as BrickField,
)
from .fields import (
    HexField as HexField,
)
from .fields import (
    NoiseField as NoiseField,
)
from .fields import (
    PixelField as PixelField,
)
from .fields import (
    PixelMap as PixelMap,
)
from .fields import (
    PointField as PointField,
)
from .fields import (
    PointWindow as PointWindow,
)
from .fields import (
    RepeatField as RepeatField,
)
from .fields import (
    SideBySide as SideBySide,
)
from .fields import (
    TextureField as TextureField,
)
from .fields import (
    side_by_side as side_by_side,
)
from .files import (
    find_maps as find_maps,
)
from .files import (
    load as load,
)
from .files import (
    read_image as read_image,
)
from .files import (
    read_points as read_points,
)
from .files import (
    ready_tiles as ready_tiles,
)
from .files import (
    save as save,
)
from .files import (
    write_image as write_image,
)
from .files import (
    write_points as write_points,
)
from .flows import (
    FLOW_TILES as FLOW_TILES,
)
from .flows import (
    Flow as Flow,
)
from .flows import (
    FlowTile as FlowTile,
)
from .flows import (
    simulate_flow as simulate_flow,
)
from .flows import (
    strew_tiles as strew_tiles,
)
from .jobs import (
    add_maps as add_maps,
)
from .jobs import (
    open_exemplar as open_exemplar,
)
from .jobs import (
    texture_tiles as texture_tiles,
)
from .notebook import (
    paint_png as paint_png,
)
from .samplers import (
    Box as Box,
)
from .samplers import (
    PointSet as PointSet,
)
from .samplers import (
    max_radius as max_radius,
)
from .samplers import (
    relative_radius as relative_radius,
)
from .samplers import (
    sample_points as sample_points,
)
from .signals.bricks import (
    BrickStyle as BrickStyle,
)
from .signals.bricks import (
    brick_texture_tiles as brick_texture_tiles,
)
from .signals.points import (
    Closeness as Closeness,
)
from .signals.points import (
    PointTiles as PointTiles,
)
from .signals.points import (
    Spikes as Spikes,
)
from .signals.points import (
    find_closeness as find_closeness,
)
from .signals.points import (
    find_spikes as find_spikes,
)
from .signals.points import (
    make_point_tiles as make_point_tiles,
)
from .signals.points import (
    poisson_tiles as poisson_tiles,
)
from .signals.points import (
    recursive_points as recursive_points,
)
from .signals.textures import (
    Exemplar as Exemplar,
)
from .signals.textures import (
    TextureTiles as TextureTiles,
)
from .signals.textures import (
    find_regularity as find_regularity,
)
from .signals.textures import (
    resynthesize as resynthesize,
)
from .signals.textures import (
    synthesize as synthesize,
)
from .tiles import (
    ListedTileSet as ListedTileSet,
)
from .tiles import (
    Shape as Shape,
)
from .tiles import (
    TileSet as TileSet,
)
from .tiles import (
    Variants as Variants,
)
from .tiles import (
    as_wang_tiles as as_wang_tiles,
)
from .tiles import (
    cohen_tiles as cohen_tiles,
)
from .tiles import (
    column_corner_tiles as column_corner_tiles,
)
from .tiles import (
    compact_corner_cubes as compact_corner_cubes,
)
from .tiles import (
    compact_wang_cubes as compact_wang_cubes,
)
from .tiles import (
    compact_wang_tiles as compact_wang_tiles,
)
from .tiles import (
    corner_coded_tiles as corner_coded_tiles,
)
from .tiles import (
    corner_cubes as corner_cubes,
)
from .tiles import (
    corner_tiles as corner_tiles,
)
from .tiles import (
    crossed_wang_tiles as crossed_wang_tiles,
)
from .tiles import (
    decode as decode,
)
from .tiles import (
    dominoes as dominoes,
)
from .tiles import (
    encode as encode,
)
from .tiles import (
    free_tiles as free_tiles,
)
from .tiles import (
    shifted_wang_tiles as shifted_wang_tiles,
)
from .tiles import (
    summed_wang_tiles as summed_wang_tiles,
)
from .tiles import (
    tile_set as tile_set,
)
from .tiles import (
    wang_cubes as wang_cubes,
)
from .tiles import (
    wang_tiles as wang_tiles,
)
from .tiles.aperiodic import (
    APERIODIC_SETS as APERIODIC_SETS,
)
from .tiles.aperiodic import (
    aperiodic_tiles as aperiodic_tiles,
)
from .tiles.blocks import (
    drop_idle as drop_idle,
)
from .tiles.blocks import (
    possible_blocks as possible_blocks,
)
from .tiles.bricks import (
    brick_tiles as brick_tiles,
)
from .tiles.lifting import (
    Lifting as Lifting,
)
from .tiles.lifting import (
    check_lifting as check_lifting,
)
from .tiles.merging import (
    grouped_subdivision as grouped_subdivision,
)
from .tiles.merging import (
    merge_colors as merge_colors,
)
from .tiles.transducers import (
    Transducer as Transducer,
)
from .tiles.transducers import (
    find_period as find_period,
)
from .tiles.transducers import (
    strip as strip,
)
from .tiles.translations import (
    as_corner_tiles as as_corner_tiles,
)
from .tiles.translations import (
    translation_is_sound as translation_is_sound,
)
from .tilings import (
    ArrayTiling as ArrayTiling,
)
from .tilings import (
    Domain as Domain,
)
from .tilings import (
    LatticeHash as LatticeHash,
)
from .tilings import (
    LongPeriodHash as LongPeriodHash,
)
from .tilings import (
    MixerHash as MixerHash,
)
from .tilings import (
    Packing as Packing,
)
from .tilings import (
    PackingSearch as PackingSearch,
)
from .tilings import (
    PermutationHash as PermutationHash,
)
from .tilings import (
    Placements as Placements,
)
from .tilings import (
    Tiling as Tiling,
)
from .tilings import (
    array_tiling as array_tiling,
)
from .tilings import (
    classify_packings as classify_packings,
)
from .tilings import (
    count_packings as count_packings,
)
from .tilings import (
    density_tiling as density_tiling,
)
from .tilings import (
    direct as direct,
)
from .tilings import (
    extend_packing as extend_packing,
)
from .tilings import (
    filled_tiling as filled_tiling,
)
from .tilings import (
    packing as packing,
)
from .tilings import (
    periodic_tiling as periodic_tiling,
)
from .tilings import (
    random_packing as random_packing,
)
from .tilings import (
    recursive_packing as recursive_packing,
)
from .tilings import (
    scanline as scanline,
)
from .tilings import (
    stochastic as stochastic,
)
from .tilings.aperiodic import (
    aperiodic_tiling as aperiodic_tiling,
)
from .tilings.aperiodic import (
    translated_tiling as translated_tiling,
)
from .tilings.bricks import (
    BrickRegion as BrickRegion,
)
from .tilings.bricks import (
    EndlessBrickTiling as EndlessBrickTiling,
)
from .tilings.bricks import (
    brick_region as brick_region,
)
from .tilings.bricks import (
    brick_tiling as brick_tiling,
)
from .tilings.bricks import (
    endless_brick_tiling as endless_brick_tiling,
)
from .tilings.dappled import (
    Closest as Closest,
)
from .tilings.dappled import (
    Conditions as Conditions,
)
from .tilings.dappled import (
    EndlessDappledTiling as EndlessDappledTiling,
)
from .tilings.dappled import (
    Impossible as Impossible,
)
from .tilings.dappled import (
    closest_dapple as closest_dapple,
)
from .tilings.dappled import (
    complete_dapple as complete_dapple,
)
from .tilings.dappled import (
    count_dappled as count_dappled,
)
from .tilings.dappled import (
    dapple as dapple,
)
from .tilings.dappled import (
    dapple_formula as dapple_formula,
)
from .tilings.dappled import (
    endless_dappled_tiling as endless_dappled_tiling,
)
from .tilings.dappled import (
    find_violations as find_violations,
)
from .tilings.dappled import (
    random_start as random_start,
)
from .tilings.dappled import (
    rectify as rectify,
)
from .tilings.dappled import (
    start_from_image as start_from_image,
)

__version__: str
