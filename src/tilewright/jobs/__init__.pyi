from .analyze import AnalyzeJob as AnalyzeJob
from .aperiodic import AperiodicJob as AperiodicJob
from .bricks import BricksJob as BricksJob
from .compare import CompareJob as CompareJob
from .dapple import DappleJob as DappleJob
from .export import ExportJob as ExportJob
from .flow import FlowJob as FlowJob
from .info import InfoJob as InfoJob
from .job import (
    Done as Done,
    Job as Job,
)
from .materials import (
    add_maps as add_maps,
    open_exemplar as open_exemplar,
    texture_tiles as texture_tiles,
)
from .pack import PackJob as PackJob
from .points import PointsJob as PointsJob
from .render import RenderJob as RenderJob
from .surface import SurfaceJob as SurfaceJob
from .texture import TextureJob as TextureJob
from .view import ViewJob as ViewJob
from .warm import WarmJob as WarmJob
