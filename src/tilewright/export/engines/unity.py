"""Unity: textures, an importer that keeps their mip levels, Shader Graph functions, a URP shader."""

from pathlib import Path

from tilewright.export.engines.dds import write_dds
from tilewright.export.engines.folder import file_names, finish, tone_names
from tilewright.export.engines.kit import Kit
from tilewright.export.engines.parts import fill
from tilewright.files.texts import write_text
from tilewright.shaders.lookup import reals

_READS = {
    "color": "surface.albedo = {}.rgb;",
    "normal": "surface.normalTS = TwNormal({});",
    "roughness": "surface.smoothness = 1 - {}.r;",
    "metallic": "surface.metallic = {}.r;",
    "occlusion": "surface.occlusion = {}.r;",
    "emission": "surface.emission = {}.rgb;",
}
"""What each slot's map gives to URP's SurfaceData."""
_LAYS = {
    "color": "surface.albedo = TwLay(surface.albedo, {0}, {1});",
    "roughness": "surface.smoothness = saturate(surface.smoothness - {0}.r);",
    "emission": "surface.emission = TwLay(surface.emission, {0}, {1});",
}
"""How tone, and the mean of its map, change that."""
_WHOLE_SHADOW = " Shadows are those of the surface without holes."


def write(folder: Path, kit: Kit) -> None:
    """Fill a folder."""
    files = file_names(kit.material, ".twdds")
    for map, file in files.items():
        levels, srgb = kit.levels(map)
        write_dds(folder / file, levels, srgb=srgb)
    tones = tone_names(kit, files)
    for map, file in tones.items():
        write_dds(folder / file, kit.tone(map))
    used = {slot: f"_{slot.capitalize()}Map" for slot in kit.slots if slot in _READS}
    maps = [(used[slot], files[kit.slots[slot]]) for slot in used]
    toned = {slot: tones[map] for slot, map in kit.toned_slots.items() if slot in used}
    maps += [(f"_{slot.capitalize()}Tone", file) for slot, file in toned.items()]
    (folder / "Editor").mkdir()
    array = "true" if kit.form == "array" else "false"
    pairs = ", ".join(f'("{name}", "{file}")' for name, file in maps)
    listed = ", ".join(f'"{file}"' for file in tones.values())
    texts = {"maps": pairs, "array": array, "tones": listed}
    importer = fill("unity/TilewrightImporter.cs", **texts, toned=bool(tones))
    write_text(folder / "Editor" / "TilewrightImporter.cs", importer)
    values = kit.numbers() | kit.example_tone() | {"include": kit.lookup("hlsl")}
    include = fill("unity/Tilewright.hlsl", **values)
    write_text(folder / "Tilewright.hlsl", include)
    write_text(folder / "Tilewright.shader", _shader(kit, used))
    finish(
        kit,
        folder,
        "Unity",
        "compiled only: the include (and run) and the shader as HLSL by glslang, the importer by Mono's "
        "compiler, "
        "with stand-ins for what Unity has",
        [
            "Copy the folder into Assets (Unity 2021.2 or later, Universal Render Pipeline), right-click "
            "it, Create, "
            "Tilewright Material: Tiles is the number of tiles across one unit of UV. "
            "Height and opacity are not wired." + (_WHOLE_SHADOW if kit.cut_out else ""),
            "Shader Graph: a Custom Function node of type File with Tilewright.hlsl; functions "
            f"Tilewright{', TilewrightTone (Mean: tilewright.json)' if tones else ''} and TilewrightNormal. "
            "In the Built-in pipeline include Tilewright.hlsl yourself.",
            "Textures are .twdds, DDS by another name, so that the importer in Editor keeps their mip "
            "levels.",
        ],
        files,
        cuts=True,
    )


def _shader(kit: Kit, used: dict[str, str]) -> str:
    """The URP shader, with a property, a texture and a read for each map."""
    array = kit.form == "array"
    kind = "2DArray" if array else "2D"
    macro = "TEXTURE2D_ARRAY" if array else "TEXTURE2D"
    sample = "SAMPLE_TEXTURE2D_ARRAY_GRAD({0}, sampler{0}, at.uv.xy, at.uv.z, at.dx, at.dy)"
    if not array:
        sample = "SAMPLE_TEXTURE2D_GRAD({0}, sampler{0}, at.uv, at.dx, at.dy)"
    properties = [f'    {name} ("{slot.capitalize()}", {kind}) = "white" {{}}' for slot, name in used.items()]
    textures = [f"      {macro}({name}); SAMPLER(sampler{name});" for name in used.values()]
    reads = [f"        {_READS[slot].format(sample.format(name))}" for slot, name in used.items()]
    if kit.cut_out:
        alpha = sample.format(used["color"])
        reads += [f"        surface.alpha = {alpha}.a;", "        clip(surface.alpha - 0.5);"]
    for slot in (slot for slot in kit.toned_slots if slot in used):
        name = f"_{slot.capitalize()}Tone"
        properties.append(f'    {name} ("{slot.capitalize()} tone", 2D) = "black" {{}}')
        textures.append(f"      TEXTURE2D({name}); SAMPLER(sampler{name});")
        tone = f"TwToneUp({name}, sampler{name}, input.uv, _Origin.xy)"
        mean = f"float3({reals(kit.tone_mean(kit.slots[slot]))})"
        reads.append(f"        {_LAYS[slot].format(tone, mean)}")
    return fill(
        "unity/Tilewright.shader",
        properties="\n".join(properties),
        textures="\n".join(textures),
        reads="\n".join(reads),
        cut_out=kit.cut_out,
    )
