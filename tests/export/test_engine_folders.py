"""Folders for engines: what they hold, what compiles, and what is refused."""

import dataclasses
import json
import re
import runpy
import shutil
import struct
import subprocess
import sys
from pathlib import Path
from unittest.mock import MagicMock

import numpy as np
import pytest

import dialects
import tilewright as tw
from handmade import handmade, handmade_surface, surface_under_clouds, under_clouds
from tilewright.errors import TilewrightError
from tilewright.export.engines import TARGETS, save_for_engine
from tilewright.export.engines.kit import prepare


@pytest.fixture(scope="module")
def material():
    return handmade_surface()


@pytest.fixture(scope="module")
def folders(material, tmp_path_factory):
    """A folder for every target."""
    top = tmp_path_factory.mktemp("engines")
    for target in TARGETS:
        save_for_engine(material, top / target, target, seed=7)
    return top


@pytest.fixture(scope="module")
def clouded():
    """Tiles in classes whose color has tone."""
    made = under_clouds(handmade(tw.classed_corner_tiles(2, 5), 16), 2)
    return dataclasses.replace(made, kinds={"map0": "color"})


@pytest.mark.parametrize("target", TARGETS)
def test_a_folder_holds_what_it_says(target, folders, material):
    folder = folders / target
    readme = (folder / "README.md").read_text().splitlines()
    steps = [line for line in readme if re.match(r"\d+\. ", line)]
    assert 6 <= len(steps) <= 10
    assert "rendered here" in steps[0] or "compiled only" in steps[0] or "read back here" in steps[0]
    facts = json.loads((folder / "tilewright.json").read_text())
    there = {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()}
    assert there == {*facts["files"], "tilewright.json"}
    assert (facts["colors"], facts["tile_size"], facts["seed"]) == (2, 16, 7)
    assert {facts["maps"][m]["file"] for m in material.maps} <= there
    assert facts["slots"]["color"] == "base color"
    assert set(facts["slots"]) == {
        "color",
        "normal",
        "roughness",
        "metallic",
        "occlusion",
        "height",
        "emission",
    }
    for name in there:
        if not name.endswith((".js", ".png", ".ktx2", ".dds", ".twdds", ".tx", ".exr")):
            assert "{{" not in (folder / name).read_text(), name


def test_memory_is_that_of_whole_mip_chains(folders):
    facts = json.loads((folders / "ktx2" / "tilewright.json").read_text())
    sides = [20, 10, 5, 2, 1]
    assert facts["maps"]["base color"]["gpu_bytes"] == {
        "RGBA8": 16 * 4 * sum(s * s for s in sides),
        "BC7": 16 * 16 * sum((-(-s // 4)) ** 2 for s in sides),
        "ASTC 4x4": 16 * 16 * sum((-(-s // 4)) ** 2 for s in sides),
        "ASTC 6x6": 16 * 16 * sum((-(-s // 6)) ** 2 for s in sides),
        "RGBA16F": 16 * 8 * sum(s * s for s in sides),
    }
    assert "BC4" in facts["maps"]["roughness"]["gpu_bytes"]
    assert "BC5" in facts["maps"]["normal"]["gpu_bytes"]


def test_green_points_where_the_target_wants_it(material):
    kept, turned = prepare(material, 0), prepare(material, 0, green="dx")
    up, down = kept.levels("normal")[0], turned.levels("normal")[0]
    assert (up[0][:, 2:18, 2:18, :3] == material.maps["normal"]).all()
    for a, b in zip(up, down, strict=True):
        assert (a[..., 1] == 255 - b[..., 1]).all()
        assert (a[..., [0, 2, 3]] == b[..., [0, 2, 3]]).all()
    assert json.loads(json.dumps(turned.green)) == "dx"


def test_signed_normals_and_deep_maps_become_what_a_gpu_filters(material):
    signed = material.maps["normal"].astype(np.float32) / 127.5 - 1
    deep = (material.maps["base color"].astype(np.uint16) << 8) | 7
    maps = {**material.maps, "normal": signed, "base color": deep}
    kit = prepare(dataclasses.replace(material, maps=maps), 0)
    inside = np.s_[:, 2:18, 2:18, :3]
    normals = kit.levels("normal")[0][0]
    assert normals.dtype == np.float16
    np.testing.assert_allclose(normals[inside], (signed + 1) / 2, atol=5e-4)
    light, srgb = kit.levels("base color")
    assert not srgb
    encoded = deep / 65535
    linear = np.where(encoded <= 0.04045, encoded / 12.92, ((encoded + 0.055) / 1.055) ** 2.4)
    np.testing.assert_allclose(light[0][inside], linear, atol=5e-4)


def read_dds(path):
    """Levels of a DDS file, read after Microsoft's description: (layers, rows, columns, channels)."""
    data = path.read_bytes()
    rows, columns = struct.unpack_from("<2I", data, 12)
    count, four = struct.unpack_from("<I", data, 28)[0], data[84:88]
    if four == b"DX10":
        dxgi, _, _, layers, _ = struct.unpack_from("<5I", data, 128)
        kind, channels = {
            61: ("u1", 1),
            28: ("u1", 4),
            29: ("u1", 4),
            54: ("f2", 1),
            10: ("f2", 4),
        }[dxgi]
    else:
        dxgi, layers, kind, channels = 0, 1, "u1", 4
    at, found = 148 if four == b"DX10" else 128, []
    for _ in range(layers):
        chain = []
        for level in range(count):
            shape = (max(1, rows >> level), max(1, columns >> level), channels)
            size = int(np.prod(shape)) * np.dtype(kind).itemsize
            chain.append(np.frombuffer(data[at : at + size], kind).reshape(shape))
            at += size
        found.append(chain)
    assert at == len(data)
    levels = [np.stack([chain[level] for chain in found]) for level in range(count)]
    return (levels if four == b"DX10" else [level[..., [2, 1, 0, 3]] for level in levels]), dxgi


@pytest.mark.parametrize("target", ["hlsl", "unity"])
def test_dds_holds_all_layers_and_levels(target, folders, material):
    kit = prepare(material, 7)
    facts = json.loads((folders / target / "tilewright.json").read_text())
    for name in material.maps:
        levels, dxgi = read_dds(folders / target / facts["maps"][name]["file"])
        expected, srgb = kit.levels(name)
        assert (dxgi == 29) == srgb
        assert len(levels) == len(expected)
        for got, want in zip(levels, expected, strict=True):
            np.testing.assert_array_equal(got, want)


def test_another_library_reads_the_dds_of_unreal(folders, material):
    from PIL import Image

    kit = prepare(material, 7, atlas=True, green="dx")
    for name, file in (("base color", "T_base_color.dds"), ("normal", "T_normal.dds")):
        pixels = np.asarray(Image.open(folders / "unreal" / file))
        np.testing.assert_array_equal(pixels, kit.levels(name)[0][0][0])
        np.testing.assert_array_equal(read_dds(folders / "unreal" / file)[0][3], kit.levels(name)[0][3])


def test_mip_levels_of_tx_are_read_as_such(folders, material):
    import OpenImageIO as oiio

    kit = prepare(material, 7, atlas=True)
    for name, file in (("base color", "base_color.tx"), ("height", "height.tx")):
        levels = kit.levels(name)[0]
        image = oiio.ImageInput.open(str(folders / "osl" / file))
        for number, level in enumerate(levels):
            kind = "uint8" if level.dtype == np.uint8 else "float"
            got = image.read_image(0, number, 0, level.shape[-1], kind)
            np.testing.assert_array_equal(np.reshape(got, level[0].shape), level[0])
        assert not image.seek_subimage(0, len(levels))


def test_the_atlas_and_its_places(folders, material):
    from tilewright.files import read_image

    places = json.loads((folders / "atlas" / "places.json").read_text())["columns_and_rows"]
    for name, file in (("base color", "base_color.png"), ("ao", "ao.png"), ("height", "height.exr")):
        atlas = read_image(folders / "atlas" / file)
        for tile, (x, y) in zip(material.maps[name], places, strict=True):
            np.testing.assert_array_equal(atlas[16 * y : 16 * y + 16, 16 * x : 16 * x + 16], tile)


@pytest.fixture
def import_in_unity(tmp_path):
    """Run the importer of a folder on one of its files, with a stand-in for Unity; the lines it says."""
    if not (shutil.which("mcs") and shutil.which("mono")):
        pytest.skip("Mono's compiler (Debian: mono-mcs) is not installed")
    program, stand_in = tmp_path / "import.exe", Path(__file__).parents[1] / "helpers" / "unity_stand_in.cs"
    compile_ = ["mcs", "-warnaserror+", "-nowarn:0162,0429", "-langversion:7", f"-out:{program}", stand_in]

    def run(folder, file):
        subprocess.run([*compile_, folder / "Editor/TilewrightImporter.cs"], check=True)
        done = subprocess.run(["mono", program, folder / file], check=True, capture_output=True, text=True)
        return done.stdout.splitlines()

    return run


def test_unity_imports_every_texel(folders, material, import_in_unity):
    kit = prepare(material, 7)
    facts = json.loads((folders / "unity" / "tilewright.json").read_text())
    formats = {"base color": "R8G8B8A8_SRGB", "roughness": "R8_UNorm", "emissive": "R16G16B16A16_SFloat"}
    for name, format in formats.items():
        said = import_in_unity(folders / "unity", facts["maps"][name]["file"])
        levels = kit.levels(name)[0]
        assert said[:2] == ["Clamp Trilinear", f"2DArray 20 20 16 {format} 5"]
        expected = [
            f"{layer} {n} {level[layer].nbytes} {_sum(level[layer].tobytes())}"
            for layer in range(16)
            for n, level in enumerate(levels)
        ]
        assert said[2:] == expected


def test_unity_imports_tone_as_a_picture(clouded, import_in_unity, tmp_path):
    folder = tmp_path / "unity"
    save_for_engine(clouded, folder, "unity")
    said = import_in_unity(folder, "map0.twdds")
    assert said[:2] == ["Clamp Trilinear", "2DArray 20 20 80 R8G8B8A8_SRGB 5"]
    said = import_in_unity(folder, "map0_tone.twdds")
    assert said[:2] == ["Clamp Trilinear", "2D 26 20 1 R16G16B16A16_SFloat 5"]


def _sum(data):
    total = 0
    for byte in data:
        total = (total * 31 + byte) % 2**32
    return total


# As much of Unity's shader libraries as the surface shader names.
_URP = """
#define TEXTURE2D_ARRAY(t) Texture2DArray t
#define TEXTURE2D(t) Texture2D t
#define SAMPLER(s) SamplerState s
#define SAMPLE_TEXTURE2D_ARRAY_GRAD(t, s, uv, i, dx, dy) t.SampleGrad(s, float3(uv, i), dx, dy)
#define SAMPLE_TEXTURE2D_GRAD(t, s, uv, dx, dy) t.SampleGrad(s, uv, dx, dy)
#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };
#define half float
#define half3 float3
#define half4 float4
struct UnityTexture2DArray { Texture2DArray tex; SamplerState samplerstate; };
struct UnityTexture2D { Texture2D tex; SamplerState samplerstate; };
struct VertexPositionInputs { float4 positionCS; float3 positionWS; };
struct VertexNormalInputs { float3 normalWS; float3 tangentWS; };
struct SurfaceData {
  float3 albedo, normalTS, emission, specular; float alpha, occlusion, smoothness, metallic;
};
struct InputData {
  float3 positionWS, normalWS, viewDirectionWS, bakedGI; float4 shadowCoord; float fogCoord;
  float2 normalizedScreenSpaceUV;
};
VertexPositionInputs GetVertexPositionInputs(float3 p) { return (VertexPositionInputs)0; }
VertexNormalInputs GetVertexNormalInputs(float3 n, float4 t) { return (VertexNormalInputs)0; }
float GetOddNegativeScale() { return 1; }
float ComputeFogFactor(float z) { return 0; }
float3 GetWorldSpaceNormalizeViewDir(float3 p) { return p; }
float4 TransformWorldToShadowCoord(float3 p) { return 0; }
float3 SampleSH(float3 n) { return n; }
float2 GetNormalizedScreenSpaceUV(float4 p) { return p.xy; }
float4 UniversalFragmentPBR(InputData i, SurfaceData s) {
  return float4(s.albedo + i.normalWS + s.emission, s.smoothness + s.metallic + s.occlusion);
}
float3 MixFog(float3 c, float f) { return c; }
"""


@pytest.mark.parametrize("colors", [2, 5])
def test_the_surface_shader_of_unity_compiles(colors, tmp_path):
    save_for_engine(handmade_surface(colors), tmp_path / "unity", "unity")
    include = (tmp_path / "unity" / "Tilewright.hlsl").read_text()
    shader = (tmp_path / "unity" / "Tilewright.shader").read_text()
    body = re.search(r"HLSLPROGRAM(.*?)ENDHLSL", shader, re.DOTALL)[1]
    body = re.sub(r"#(include|pragma).*", "", body)
    for stage, entry in (("vert", "Vertex"), ("frag", "Fragment")):
        dialects.compile_spirv(_URP + include + body, ".hlsl", tmp_path, stage, entry)
    assert body.count("SAMPLE_TEXTURE2D") == 6


def test_the_surface_shader_of_unity_lays_the_tone(tmp_path):
    save_for_engine(surface_under_clouds(), tmp_path / "unity", "unity")
    include = (tmp_path / "unity" / "Tilewright.hlsl").read_text()
    shader = (tmp_path / "unity" / "Tilewright.shader").read_text()
    body = re.search(r"HLSLPROGRAM(.*?)ENDHLSL", shader, re.DOTALL)[1]
    body = re.sub(r"#(include|pragma).*", "", body)
    dialects.compile_spirv(_URP + include + body, ".hlsl", tmp_path, "frag", "Fragment")
    assert "TwLay(surface.albedo, TwToneUp(_ColorTone" in body
    assert "TwLay(surface.emission, TwToneUp(_EmissionTone" in body
    assert "saturate(surface.smoothness - TwToneUp(_RoughnessTone" in body


def run_in_unreal(folder, monkeypatch):
    """Run an exported script against a stand-in: its Custom nodes, the wires, what the material gets."""
    unreal, nodes = MagicMock(), []

    def create(_material, kind, *_place):
        nodes.append(MagicMock(kind=kind))
        return nodes[-1]

    library = unreal.MaterialEditingLibrary
    library.create_material_expression = create
    monkeypatch.setitem(sys.modules, "unreal", unreal)
    runpy.run_path(str(folder / "make_material.py"))
    custom = [n for n in nodes if n.kind is unreal.MaterialExpressionCustom]
    wires = [call.args for call in library.connect_material_expressions.mock_calls]
    ends = {
        str(call.args[2]).split(".")[2].split("'")[0]: call.args[:2]
        for call in library.connect_material_property.mock_calls
    }
    return custom, wires, ends


def code_of(node):
    return dict(call.args for call in node.set_editor_property.mock_calls)["code"]


def test_the_script_for_unreal_builds_the_material(folders, monkeypatch):
    (custom,), wires, ends = run_in_unreal(folders / "unreal", monkeypatch)
    assert {name: output for name, (_, output) in ends.items()} == {
        "MP_BASE_COLOR": "RGB",
        "MP_NORMAL": "RGB",
        "MP_ROUGHNESS": "R",
        "MP_METALLIC": "R",
        "MP_AMBIENT_OCCLUSION": "R",
        "MP_EMISSIVE_COLOR": "RGB",
    }
    assert code_of(custom) == (folders / "unreal" / "custom_node.hlsl").read_text()
    assert sum(wire[3] == "DDX(UVs)" and wire[0] is custom for wire in wires) == 6


def test_the_script_for_unreal_lays_the_tone(clouded, tmp_path, monkeypatch):
    save_for_engine(clouded, tmp_path / "unreal", "unreal", seed=7)
    (place, tone), wires, ends = run_in_unreal(tmp_path / "unreal", monkeypatch)
    assert code_of(tone) == (tmp_path / "unreal" / "custom_tone.hlsl").read_text()
    assert ends["MP_BASE_COLOR"] == (tone, "")
    into = {pin: source for source, _, node, pin in wires if node is tone}
    assert into.keys() == {"Position", "Origin", "Color", "Mean", "Tone"}
    assert into["Position"] is next(s for s, _, node, pin in wires if node is place and pin == "Position")


def test_the_script_for_unreal_lays_the_tone_of_every_map(tmp_path, monkeypatch):
    save_for_engine(surface_under_clouds(), tmp_path / "unreal", "unreal", seed=7)
    nodes, _, ends = run_in_unreal(tmp_path / "unreal", monkeypatch)
    laid = [ends[end] for end in ("MP_BASE_COLOR", "MP_ROUGHNESS", "MP_EMISSIVE_COLOR")]
    assert all(node in nodes[1:] and output == "" for node, output in laid)
    assert ends["MP_METALLIC"][0] not in nodes
    script = (tmp_path / "unreal" / "make_material.py").read_text()
    assert '"roughness": [-1.0, -1.0, -1.0]' in script
    assert '"color": [0.5, 0.5, 0.5]' in script


@pytest.mark.parametrize("target", TARGETS)
def test_a_folder_with_tone_says_where_it_lies(target, clouded, tmp_path):
    folder = tmp_path / target
    save_for_engine(clouded, folder, target, seed=7)
    readme = (folder / "README.md").read_text().splitlines()
    assert len([line for line in readme if re.match(r"\d+\. ", line)]) <= 10
    facts = json.loads((folder / "tilewright.json").read_text())
    there = {p.relative_to(folder).as_posix() for p in folder.rglob("*") if p.is_file()}
    assert there == {*facts["files"], "tilewright.json"}
    tone = facts["tone"]
    assert set(tone["files"].values()) < there
    assert (tone["span"], tone["texels"], len(tone["start_states"])) == (2, 16, 4)
    assert any(tone["files"]["map0"] in line and "three fetches more" in line for line in readme)
    assert "{{" not in "".join(
        p.read_text() for p in folder.rglob("*.*") if p.suffix in (".osl", ".hlsl", ".py")
    )


@pytest.mark.parametrize("target", ["wgsl", "glsl", "hlsl"])
def test_examples_compile(target, folders, tmp_path):
    folder = folders / target
    if target == "wgsl":
        text = (folder / "tilewright.wgsl").read_text() + (folder / "example.wgsl").read_text()
        dialects.device().create_shader_module(code=text)
    elif target == "hlsl":
        shutil.copy(folder / "tilewright.hlsl", tmp_path)
        dialects.compile_spirv((folder / "example.hlsl").read_text(), ".hlsl", tmp_path)
    else:
        if dialects.GLSLANG is None:
            pytest.skip("glslangValidator is not installed")
        subprocess.run([dialects.GLSLANG, folder / "example.frag"], check=True, capture_output=True)


@pytest.mark.parametrize(
    ("tiles", "to", "message"),
    [
        (tw.corner_tiles(2), "quake", r"to is 'quake'; allowed are threejs, godot, "),
        (tw.wang_tiles(2), "glsl", r"complete corner sets.*corner_tiles\(C\)"),
        (tw.corner_tiles(3, 2), "godot", r"complete corner sets"),
    ],
)
def test_what_cannot_be_exported_is_refused(tiles, to, message, tmp_path):
    with pytest.raises(TilewrightError, match=message) as refused:
        save_for_engine(handmade(tiles, 16), tmp_path / "out", to)
    assert "\n" not in str(refused.value)
    assert not (tmp_path / "out").exists()


def test_wrong_arguments_are_refused(material, tmp_path):
    with pytest.raises(TilewrightError, match="seed is -1"):
        save_for_engine(material, tmp_path / "out", "glsl", seed=-1)
    with pytest.raises(TilewrightError, match="material must be TextureTiles"):
        save_for_engine("moss.jpg", tmp_path / "out", "glsl")


def test_only_exports_are_replaced(material, tmp_path):
    out = tmp_path / "out"
    save_for_engine(material, out, "wgsl", seed=1)
    save_for_engine(material, out, "atlas", seed=2)
    assert not (out / "tilewright.wgsl").exists()
    (out / "notes.txt").write_text("mine")
    with pytest.raises(TilewrightError, match=r"holds notes\.txt, which the export did not write"):
        save_for_engine(material, out, "wgsl")
    assert (out / "places.json").exists()
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "notes.txt").write_text("mine")
    with pytest.raises(TilewrightError, match=r"holds other things and no tilewright\.json"):
        save_for_engine(material, tmp_path / "mine", "wgsl")


def test_names_of_maps_become_names_of_files(material, tmp_path):
    maps = {
        "A b": material.maps["roughness"],
        "a/b": material.maps["metallic"],
        "été": material.maps["metallic"],
    }
    sources = tuple(dict.fromkeys(maps, source["roughness"]) for source in material.sources)
    odd = dataclasses.replace(material, maps=maps, sources=sources, kinds=dict.fromkeys(maps, "data"))
    save_for_engine(odd, tmp_path / "out", "wgsl")
    facts = json.loads((tmp_path / "out" / "tilewright.json").read_text())
    assert [m["file"] for m in facts["maps"].values()] == ["a_b.ktx2", "a_b_.ktx2", "t.ktx2"]


@pytest.fixture(scope="module")
def fence():
    """Tiles whose color has holes."""
    made = handmade(tw.corner_tiles(2), 16, channels=4)
    return dataclasses.replace(made, kinds={"map0": "color"})


HOLES = {
    "godot": ("tilewright.gdshader", "ALPHA_SCISSOR_THRESHOLD = 0.5"),
    "unity": ("Tilewright.shader", "clip(surface.alpha - 0.5)"),
    "unreal": ("make_material.py", "MP_OPACITY_MASK"),
    "blender": ("material.py", 'outputs["Alpha"], surface.inputs["Alpha"]'),
    "threejs": ("tilewright.js", "material.alphaTest ||= 0.5"),
}


@pytest.mark.parametrize("target", TARGETS)
def test_holes_are_shown_or_said_not_to_be(target, fence, tmp_path):
    save_for_engine(fence, tmp_path / "holes", target)
    opaque = fence.maps["map0"].copy()
    opaque[..., 3] = 255
    save_for_engine(dataclasses.replace(fence, maps={"map0": opaque}), tmp_path / "whole", target)
    said, unsaid = ((tmp_path / name / "README.md").read_text() for name in ("holes", "whole"))
    assert "is below 0.5, which " in said
    assert "below 0.5" not in unsaid
    assert ("which the material shows" in said) == (target in HOLES)
    if target in HOLES:
        file, text = HOLES[target]
        assert text in (tmp_path / "holes" / file).read_text()
        assert text not in (tmp_path / "whole" / file).read_text()


def test_the_surface_shader_of_unity_cuts_holes(fence, tmp_path):
    save_for_engine(fence, tmp_path / "unity", "unity")
    include = (tmp_path / "unity" / "Tilewright.hlsl").read_text()
    shader = (tmp_path / "unity" / "Tilewright.shader").read_text()
    body = re.search(r"HLSLPROGRAM(.*?)ENDHLSL", shader, re.DOTALL)[1]
    body = re.sub(r"#(include|pragma).*", "", body)
    dialects.compile_spirv(_URP + include + body, ".hlsl", tmp_path, "frag", "Fragment")
    assert '"Queue" = "AlphaTest"' in shader
    assert "Lit/DepthOnly" not in shader


def test_the_script_for_unreal_masks_holes(fence, tmp_path, monkeypatch):
    save_for_engine(fence, tmp_path / "unreal", "unreal")
    _, _, ends = run_in_unreal(tmp_path / "unreal", monkeypatch)
    assert {name: output for name, (_, output) in ends.items()} == {
        "MP_BASE_COLOR": "RGB",
        "MP_OPACITY_MASK": "A",
    }


def test_a_map_of_opacity_goes_before_alpha(fence):
    both = dataclasses.replace(
        fence,
        maps=fence.maps | {"opacity": fence.maps["map0"][..., :1]},
        sources=tuple(s | {"opacity": s["map0"][..., :1]} for s in fence.sources),
        kinds=fence.kinds | {"opacity": "data"},
    )
    assert prepare(fence, 0).cut_out
    assert not prepare(both, 0).cut_out


def test_packed_maps_that_were_kept_fill_no_slot(fence):
    names = ("metalRoughness", "MaskMap", "orm")
    maps = fence.maps | dict.fromkeys(names, fence.maps["map0"])
    sources = tuple(s | dict.fromkeys(names, s["map0"]) for s in fence.sources)
    packed = dataclasses.replace(fence, maps=maps, sources=sources, kinds={"map0": "color"})
    assert prepare(packed, 0).slots == {"color": "map0"}
