"""Run by Blender's own Python with a file of jobs: compiles and renders Open Shading Language in Cycles.

Each job has an ``out`` file and draws a square of ``tiles`` x ``tiles``, ``pixels`` across: either an
``output`` of the shader ``osl``, as floats and for each of the cells ``origins``, or the base color that an
exported script ``material`` makes.
"""

import json
import sys
import types
from pathlib import Path

import bpy
import numpy as np

SEMANTICS = types.SimpleNamespace(COLOR=1, POINT=2, VECTOR=3, NORMAL=4, NONE=0)
BASES = {"int": "INT", "float": "FLOAT", "string": "STRING"}


class OSLQuery:
    """What Blender asks a compiled shader for; its wheel lacks the module that answers."""

    def __init__(self, path):
        self.parameters = []
        for line in Path(path).read_text().splitlines():
            word, *rest = line.split("\t")
            if word in ("param", "oparam"):
                kind, name, value = rest[:3]
                self.parameters.append(_parameter(word == "oparam", kind, name, value.split()))


def _parameter(is_output, kind, name, value):
    base = BASES.get(kind, "FLOAT")
    vector = getattr(SEMANTICS, kind.upper(), SEMANTICS.NONE)
    semantics = types.SimpleNamespace(**vars(SEMANTICS))
    semantics.value = vector
    marked = _Semantics(vector)
    values = [v.strip('"') if base == "STRING" else float(v) for v in value]
    return types.SimpleNamespace(
        name=name,
        isoutput=is_output,
        isclosure=False,
        isstruct=False,
        varlenarray=False,
        metadata=[],
        value=values if vector else values[0],
        type=types.SimpleNamespace(
            vecsemantics=marked,
            arraylen=0,
            aggregate=_Enum("SCALAR", "SCALAR" if not vector else "VEC3"),
            basetype=_Enum("INT FLOAT STRING", base),
        ),
    )


class _Enum(str):
    """One of several names, each an attribute of it."""

    __slots__ = ()

    def __new__(cls, _names, value):
        return super().__new__(cls, value)

    def __getattr__(self, name):
        if name.isupper():
            return name
        raise AttributeError(name)


class _Semantics(int):
    """One of the meanings of three floats, each an attribute of it."""

    COLOR, POINT, VECTOR, NORMAL = 1, 2, 3, 4


def stage(pixels):
    """A square of one unit that fills the picture, seen from above; its object."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.shading_system = True
    scene.cycles.samples = 1
    scene.cycles.use_denoising = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.render.filter_size = 0.01
    scene.cycles.filter_width = 0.01
    scene.render.resolution_x = scene.render.resolution_y = pixels
    scene.render.resolution_percentage = 100
    scene.render.dither_intensity = 0
    scene.render.threads_mode = "FIXED"
    scene.render.threads = 2
    scene.view_settings.view_transform = "Standard"
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.type = "ORTHO"
    camera.data.ortho_scale = 1
    camera.location = (0.5, 0.5, 1)
    scene.collection.objects.link(camera)
    scene.camera = camera
    mesh = bpy.data.meshes.new("square")
    mesh.from_pydata([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [], [(0, 1, 2, 3)])
    layer = mesh.uv_layers.new()
    for loop, uv in zip(layer.data, [(0, 0), (1, 0), (1, 1), (0, 1)], strict=True):
        loop.uv = uv
    square = bpy.data.objects.new("square", mesh)
    scene.collection.objects.link(square)
    return square


def shine(material, socket):
    """Show a color socket as it is."""
    nodes, links = material.node_tree.nodes, material.node_tree.links
    light = nodes.new("ShaderNodeEmission")
    output = next(n for n in nodes if n.type == "OUTPUT_MATERIAL")
    links.new(socket, light.inputs["Color"])
    links.new(light.outputs["Emission"], output.inputs["Surface"])


def render(path, exact):
    """Render to floats or to 8 bits; the pixels."""
    settings = bpy.context.scene.render
    settings.image_settings.file_format = "OPEN_EXR" if exact else "PNG"
    settings.image_settings.color_depth = "32" if exact else "8"
    settings.image_settings.color_mode = "RGB"
    settings.filepath = str(path)
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.name = "Non-Color"
    pixels = np.empty(image.size[0] * image.size[1] * image.channels, np.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(image.size[1], image.size[0], image.channels)[::-1, :, :3]


def answer(job):
    """An output of a shader, for each origin."""
    square = stage(job["pixels"])
    material = bpy.data.materials.new("ask")
    if bpy.app.version < (5, 0):
        material.use_nodes = True
    square.data.materials.append(material)
    nodes, links = material.node_tree.nodes, material.node_tree.links
    script = nodes.new("ShaderNodeScript")
    script.mode = "EXTERNAL"
    script.filepath = job["osl"]
    script.update()
    if "map" in job:
        script.inputs["Map"].default_value = job["map"]
    coordinates = nodes.new("ShaderNodeTexCoord")
    # North is up in the square; y points south in the shader.
    mapping = nodes.new("ShaderNodeMapping")
    mapping.inputs["Scale"].default_value = (job["tiles"], -job["tiles"], 1)
    mapping.inputs["Location"].default_value = (0, job["tiles"], 0)
    links.new(coordinates.outputs["UV"], mapping.inputs["Vector"])
    links.new(mapping.outputs["Vector"], script.inputs["Position"])
    shine(material, script.outputs[job["output"]])
    pictures = []
    for x, y in job["origins"]:
        script.inputs["OriginX"].default_value = x
        script.inputs["OriginY"].default_value = y
        pictures.append(render(Path(job["out"]).with_suffix(".exr"), True))
    return np.stack(pictures)


def draw(job):
    """The base color of an exported material over the square, ``pixels`` across."""
    square = stage(job["pixels"])
    space = {"__file__": job["material"], "__name__": "material"}
    code = Path(job["material"]).read_text().replace("TILES_PER_UV = 4.0", f"TILES_PER_UV = {job['tiles']}")
    exec(compile(code, job["material"], "exec"), space)
    material = bpy.data.materials[space["NAME"]]
    square.data.materials.append(material)
    surface = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
    wired = {s.name for s in surface.inputs if s.is_linked}
    shine(material, surface.inputs["Base Color"].links[0].from_socket)
    picture = render(Path(job["out"]).with_suffix(".png"), False)
    Path(job["out"]).with_suffix(".json").write_text(json.dumps(sorted(wired)))
    return picture


def main():
    sys.modules["oslquery"] = types.SimpleNamespace(OSLQuery=OSLQuery)
    for job in json.loads(Path(sys.argv[-1]).read_text()):
        np.save(job["out"], answer(job) if "osl" in job else draw(job))


main()
