"""Shader dialects run on a software GPU: a fragment shader for each, wrapped around the exported include."""

import importlib.util
import os
import shutil
import subprocess

import numpy as np
import pytest

import tilewright as tw
from tilewright.tilings.streams import VARIANTS

GLSLANG, SPIRV_VAL = shutil.which("glslangValidator"), shutil.which("spirv-val")
_WIDTH = 64

_VERTEX = """
@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
  return vec4f(f32(i % 2u) * 4.0 - 1.0, f32(i / 2u) * 4.0 - 1.0, 0.0, 1.0);
}"""

# What lies around an include: cells come from a buffer, numbers go to a picture of 32-bit integers.
_ASK = {
    "wgsl": """
@group(0) @binding(0) var<storage, read> cells: array<vec2i>;
%s
@fragment fn main(@builtin(position) at: vec4f) -> @location(0) u32 {
  let cell = cells[u32(at.y) * 64u + u32(at.x)];
  let c = tw_corners(cell);
  return %s;
}""",
    "glsl": """#version 450
layout(std430, set = 0, binding = 0) readonly buffer Cells { ivec2 cells[]; };
layout(location = 0) out uint answer;
%s
void main() {
  ivec2 cell = cells[uint(gl_FragCoord.y) * 64u + uint(gl_FragCoord.x)];
  uvec4 c = twCorners(cell);
  answer = %s;
}""",
    "hlsl": """
[[vk::binding(0, 0)]] StructuredBuffer<int2> cells;
%s
uint main(float4 at : SV_Position) : SV_Target {
  int2 cell = cells[(uint)at.y * 64u + (uint)at.x];
  uint4 c = TwCorners(cell);
  return %s;
}""",
}
# Godot's dialect is GLSL but for what surrounds it.
_ASK["godot"] = _ASK["glsl"].replace("twCorners", "tw_corners")
_TILE = {"wgsl": "tw_tile(c)", "glsl": "twTile(c)", "hlsl": "TwTile(c)", "godot": "tw_tile(c)"}
_PLACE = {
    "wgsl": "tw_place(c).y * 256u + tw_place(c).x",
    "glsl": "twPlace(c).y * 256u + twPlace(c).x",
    "hlsl": "TwPlaceOf(c).y * 256u + TwPlaceOf(c).x",
    "godot": "tw_place(c).y * 256u + tw_place(c).x",
}
_VARIANT = {
    "wgsl": "tw_variant(cell)",
    "glsl": "twVariant(cell)",
    "hlsl": "TwVariant(cell)",
    "godot": "tw_variant(cell)",
}

# A pixel's position in tiles is (texel + pixels * step) / size, counted from the cell that texel is in.
_DRAW = {
    "wgsl": """
@group(0) @binding(0) var map: texture_2d{array}<f32>;
@group(0) @binding(1) var filtering: sampler;
struct View {{ texel: vec2i, size: i32, step: i32 }}
@group(0) @binding(2) var<uniform> view: View;
{include}
@fragment fn main(@builtin(position) at: vec4f) -> @location(0) vec4f {{
  let cell = view.texel / view.size;
  let p = (at.xy * f32(view.step) + vec2f(view.texel - cell * view.size)) / f32(view.size);
  return tw_sample(map, filtering, tw_find(p, cell));
}}""",
    "glsl": """#version 450
layout(set = 0, binding = 0) uniform texture2D{Array} map;
layout(set = 0, binding = 1) uniform sampler filtering;
layout(set = 0, binding = 2) uniform View {{ ivec2 texel; int size; int step_; }};
layout(location = 0) out vec4 color;
{include}
void main() {{
  ivec2 cell = texel / size;
  vec2 p = (gl_FragCoord.xy * float(step_) + vec2(texel - cell * size)) / float(size);
  TwPlace at = twFind(p, cell);
  // Vulkan keeps texture and sampler apart, and makes the pair only where it is used.
  color = textureGrad(sampler2D{Array}(map, filtering), at.uv, at.dx, at.dy);
}}""",
}
_DRAW_HLSL = """
[[vk::binding(0, 0)]] Texture2D{Array} map;
[[vk::binding(1, 0)]] SamplerState filtering;
[[vk::binding(2, 0)]] cbuffer View {{ int2 texel; int size; int step_; }};
{include}
float4 main(float4 at : SV_Position) : SV_Target {{
  int2 cell = texel / size;
  float2 p = (at.xy * (float)step_ + (float2)(texel - cell * size)) / (float)size;
  {sample}
}}"""
_SAMPLE_HLSL = {
    "hlsl": "return TwSample(map, filtering, TwFind(p, cell));",
    # Shader Graph's node, with what Unity's libraries define; y points up.
    "unity": """
  {Unity} wrapped;
  wrapped.tex = map;
  wrapped.samplerstate = filtering;
  float4 color;
  Tilewright_float(wrapped, float2(p.x, -p.y), (float2)cell, color);
  return color;""",
    "unreal": """
  float2 dx, dy, uv = Node(p, (float2)cell, dx, dy);
  return map.SampleGrad(filtering, uv, dx, dy);""",
}
_BEFORE_HLSL = {
    "hlsl": "{include}",
    "unity": """
struct {Unity} {{ Texture2D{Array} tex; SamplerState samplerstate; }};
#define SAMPLE_TEXTURE2D_GRAD(t, s, uv, dx, dy) t.SampleGrad(s, uv, dx, dy)
#define SAMPLE_TEXTURE2D_ARRAY_GRAD(t, s, uv, i, dx, dy) t.SampleGrad(s, float3(uv, i), dx, dy)
{include}""",
    # Unreal puts the code into a function. There its struct is local, which glslang mistakes for recursion.
    "unreal": """
{struct}
float2 Node(float2 Position, float2 Origin, out float2 DX, out float2 DY) {{
{include}
}}""",
}


# The same with tone; texels and picture are sRGB, which the GPU decodes and encodes.
_TONED = {
    "wgsl": (
        "return tw_sample(map, filtering, tw_find(p, cell));",
        """let color = tw_sample(map, filtering, tw_find(p, cell));
  return vec4f(tw_lay(color.rgb, tw_tone(tone, filtering, p, cell), vec3f({mean})), color.a);""",
        "@group(0) @binding(3) var tone: texture_2d<f32>;",
    ),
    "hlsl": (
        "return TwSample(map, filtering, TwFind(p, cell));",
        """float4 color = TwSample(map, filtering, TwFind(p, cell));
  return float4(TwLay(color.rgb, TwTone(tone, filtering, p, cell), float3({mean})), color.a);""",
        "[[vk::binding(3, 0)]] Texture2D tone;",
    ),
    "unity": (
        "return color;",
        """UnityTexture2D more;
  more.tex = tone;
  more.samplerstate = filtering;
  float4 toned;
  TilewrightTone_float(more, color, float3({mean}), float2(p.x, -p.y), (float2)cell, toned);
  return toned;""",
        """[[vk::binding(3, 0)]] Texture2D tone;
struct UnityTexture2D { Texture2D tex; SamplerState samplerstate; };""",
    ),
    "unreal": (
        "return map.SampleGrad(filtering, uv, dx, dy);",
        """float4 color = map.SampleGrad(filtering, uv, dx, dy);
  return float4(Lay(p, (float2)cell, color.rgb, float3({mean}), tone, filtering), color.a);""",
        """[[vk::binding(3, 0)]] Texture2D tone;
{struct}
float3 Lay(
    float2 Position, float2 Origin, float3 Color, float3 Mean, Texture2D Tone, SamplerState ToneSampler) {{
{code}
}}""",
    ),
}


def with_tone(dialect, source, laid, mean):
    """The shader of `drawing` with tone laid, in Unreal by the code ``laid`` of a node of its own."""
    plain, toned, declared = _TONED[dialect]
    if dialect == "unreal":
        struct, end, code = laid.replace("TwFunctions", "TwMore").partition("\n};\n")
        declared = declared.format(struct=struct + end, code=code)
    assert source.count(plain) == 1
    return declared + source.replace(plain, toned.replace("{mean}", mean))


def drawing(dialect, include, atlas):
    """The fragment shader that draws a window with an include."""
    words = {"array": "" if atlas else "_array", "Array": "" if atlas else "Array"}
    if dialect in _DRAW:
        return _DRAW[dialect].format(include=include, **words)
    words["Unity"] = "UnityTexture2D" + words["Array"]
    if dialect == "unreal":
        struct, end, include = include.partition("\n};\n")
        words["struct"] = struct + end
    before = _BEFORE_HLSL[dialect].format(include=include, **words)
    return _DRAW_HLSL.format(include=before, sample=_SAMPLE_HLSL[dialect].format(**words), **words)


def device():
    """A device of wgpu, or the test is skipped."""
    if importlib.util.find_spec("wgpu") is None:
        pytest.skip("wgpu is not installed")
    os.environ.setdefault("XDG_RUNTIME_DIR", "/tmp")
    import wgpu

    try:
        adapter = wgpu.gpu.request_adapter_sync()
    except RuntimeError as error:
        pytest.skip(f"no graphics adapter: {error}")
    return adapter.request_device_sync(required_features=["float32-filterable"])


def compile_spirv(source, suffix, tmp_path, stage="frag", entry="main"):
    """SPIR-V of a GLSL (``.frag``) or HLSL shader, passed by the strictest validators at hand."""
    if GLSLANG is None:
        pytest.skip("glslangValidator is not installed")
    path, binary = tmp_path / f"shader{suffix}", tmp_path / "shader.spv"
    path.write_text(source)
    language = ["-D", "-S", stage, "-e", entry, "--aml", "--amb"] if suffix == ".hlsl" else []
    done = subprocess.run(
        [GLSLANG, "-V", *language, "-o", binary, path], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stdout
    if SPIRV_VAL:
        subprocess.run([SPIRV_VAL, "--target-env", "vulkan1.0", binary], check=True)
    return binary.read_bytes()


def compiled(dialect, source, tmp_path):
    """What wgpu takes: WGSL as it is, the others as SPIR-V."""
    if dialect == "wgsl":
        return source
    return compile_spirv(source, ".frag" if dialect in ("glsl", "godot") else ".hlsl", tmp_path)


def ask(device, dialect, include, cells, what, tmp_path):
    """What an include says of cells (N, 2): tile, variant, or row * 256 + column in the atlas."""
    import wgpu

    words = {"tile": _TILE, "place": _PLACE, "variant": _VARIANT}[what][dialect]
    source = compiled(dialect, _ASK[dialect] % (include, words), tmp_path)
    rows = -(-len(cells) // _WIDTH)
    padded = np.zeros((rows * _WIDTH, 2), np.int32)
    padded[: len(cells)] = cells
    buffer = device.create_buffer_with_data(data=padded, usage=wgpu.BufferUsage.STORAGE)
    layout = [
        {"binding": 0, "visibility": wgpu.ShaderStage.FRAGMENT, "buffer": {"type": "read-only-storage"}}
    ]
    entries = [{"binding": 0, "resource": {"buffer": buffer, "offset": 0, "size": buffer.size}}]
    answer = _run(device, source, layout, entries, (_WIDTH, rows), "r32uint", np.uint32, 1)
    return answer.ravel()[: len(cells)]


def draw(
    device,
    dialect,
    include,
    levels,
    size,
    texel,
    window,
    tmp_path,
    *,
    atlas,
    step=1,
    tone=None,
    laid="",
    mean="",
):
    """A window of the plane, ``step`` texels for each pixel; ``texel`` is the one in its corner."""
    import wgpu

    filters = dict.fromkeys(("mag_filter", "min_filter", "mipmap_filter"), "linear")
    edge = dict.fromkeys(
        ("address_mode_u", "address_mode_v"), "repeat" if atlas and tone is None else "clamp-to-edge"
    )
    sampler = device.create_sampler(**filters, **edge)
    view = np.array([*texel, size, step], np.int32)
    buffer = device.create_buffer_with_data(data=view, usage=wgpu.BufferUsage.UNIFORM)
    dimension = "2d" if atlas else "2d-array"
    format = "rgba8unorm" if tone is None else "rgba8unorm-srgb"
    texture = upload(device, levels, format).create_view(dimension=dimension)
    stage = wgpu.ShaderStage.FRAGMENT
    shape = {"view_dimension": dimension, "sample_type": "float"}
    layout = [
        {"binding": 0, "visibility": stage, "texture": shape},
        {"binding": 1, "visibility": stage, "sampler": {"type": "filtering"}},
        {"binding": 2, "visibility": stage, "buffer": {"type": "uniform"}},
    ]
    entries = [
        {"binding": 0, "resource": texture},
        {"binding": 1, "resource": sampler},
        {"binding": 2, "resource": {"buffer": buffer, "offset": 0, "size": 16}},
    ]
    source = drawing(dialect, include, atlas)
    if tone is not None:
        source = with_tone(dialect, source, laid, mean)
        picture = upload(device, tone, "rgba16float").create_view()
        layout.append({"binding": 3, "visibility": stage, "texture": {"sample_type": "float"}})
        entries.append({"binding": 3, "resource": picture})
    source = compiled(dialect, source, tmp_path)
    return _run(device, source, layout, entries, window, format, np.uint8, 4)


def upload(device, levels, format):
    """A texture with all its levels, shape (layers, rows, columns, 4), uint8 or float16."""
    import wgpu

    layers, rows, columns, _ = levels[0].shape
    texture = device.create_texture(
        size=(columns, rows, layers),
        format=format,
        mip_level_count=len(levels),
        usage=wgpu.TextureUsage.TEXTURE_BINDING | wgpu.TextureUsage.COPY_DST,
    )
    for number, level in enumerate(levels):
        layers, rows, columns, channels = level.shape
        device.queue.write_texture(
            {"texture": texture, "mip_level": number},
            np.ascontiguousarray(level),
            {"bytes_per_row": columns * channels * level.itemsize, "rows_per_image": rows},
            (columns, rows, layers),
        )
    return texture


def _run(device, source, layout, entries, window, format, kind, channels):
    """The picture a fragment shader draws."""
    import wgpu

    width, height = window
    target = device.create_texture(
        size=(width, height, 1),
        format=format,
        usage=wgpu.TextureUsage.RENDER_ATTACHMENT | wgpu.TextureUsage.COPY_SRC,
    )
    group_layout = device.create_bind_group_layout(entries=layout)
    pipeline = device.create_render_pipeline(
        layout=device.create_pipeline_layout(bind_group_layouts=[group_layout]),
        vertex={"module": device.create_shader_module(code=_VERTEX), "entry_point": "main"},
        primitive={"topology": "triangle-list"},
        fragment={
            "module": device.create_shader_module(code=source),
            "entry_point": "main",
            "targets": [{"format": format}],
        },
    )
    encoder = device.create_command_encoder()
    attachment = {"view": target.create_view(), "load_op": "clear", "store_op": "store"}
    attachment["clear_value"] = (0, 0, 0, 0)
    drawing = encoder.begin_render_pass(color_attachments=[attachment])
    drawing.set_pipeline(pipeline)
    drawing.set_bind_group(0, device.create_bind_group(layout=group_layout, entries=entries))
    drawing.draw(3)
    drawing.end()
    device.queue.submit([encoder.finish()])
    row = width * channels * np.dtype(kind).itemsize
    data = device.queue.read_texture(
        {"texture": target}, {"bytes_per_row": row, "rows_per_image": height}, (width, height, 1)
    )
    return np.frombuffer(data, kind).reshape(height, width, channels)


def tile_table(colors, seed, x, y):
    """The tile of each cell (x, y), as `direct` lays them: what every dialect must answer."""
    tiling = tw.direct(tw.corner_tiles(colors), seed)
    return np.array([tiling.indices(int(i), int(j), 1, 1)[0, 0] for i, j in zip(x, y, strict=True)], np.int32)


def variant_table(variants, seed, x, y):
    """Which of so many variants of its tile lies in each cell (x, y), beside `tile_table`."""
    return tw.MixerHash(seed).numbers(VARIANTS, x, y) * variants >> 24
