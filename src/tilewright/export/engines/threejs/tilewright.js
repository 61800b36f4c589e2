// An endless plane of {{count}} corner tiles for three.js, made by tilewright {{version}}.
// For WebGLRenderer of release 170 or later: materials are changed by onBeforeCompile.
import * as THREE from "three";

/** What lies beside this module: the file of each map, and the map for each slot of a material. */
export const SET = {{set}};

const LOOKUP = /* glsl */ `
{{lookup}}`;

/**
 * Load the maps that lie in a folder (that of this module, where url is not given).
 * Returns { maps, material(parameters), apply(material) }: textures by name, a new MeshStandardMaterial that
 * shows them, and a way to have another material show them (any but points, lines and sprites).
 */
export async function loadTilewright(url = new URL(".", import.meta.url), renderer) {
  const maps = {}, tones = {};
  const load = async (into, name, file) => {
    const response = await fetch(new URL(file, new URL(url, location.href)));
    if (!response.ok) throw new Error(`${response.url} could not be loaded: ${response.status}`);
    into[name] = makeTexture(readKtx2(await response.arrayBuffer(), file), renderer, into === tones);
  };
  await Promise.all([
    ...Object.entries(SET.files).map(([name, file]) => load(maps, name, file)),
    ...Object.entries(SET.tones ?? {}).map(([name, file]) => load(tones, name, file)),
  ]);
  const apply = (material, slots = SET.slots) => showTiles(material, maps, tones, slots);
  const metalness = SET.slots.metallic ? 1 : 0;
  const material = (parameters) => apply(new THREE.MeshStandardMaterial({ metalness, ...parameters }));
  return { maps, apply, material };
}

// By the VkFormat of a file.
const FORMATS = {
  9: { format: THREE.RedFormat, gl: "RED" },
  16: { format: THREE.RGFormat, gl: "RG" },
  37: { format: THREE.RGBAFormat, gl: "RGBA" },
  43: { format: THREE.RGBAFormat, gl: "RGBA", colorSpace: THREE.SRGBColorSpace },
  76: { format: THREE.RedFormat, gl: "RED", half: true },
  83: { format: THREE.RGFormat, gl: "RG", half: true },
  97: { format: THREE.RGBAFormat, gl: "RGBA", half: true },
};

/** The levels of a KTX 2.0 file without supercompression. three's KTX2Loader sees one layer of an array. */
function readKtx2(buffer, file) {
  const head = new DataView(buffer), word = (n) => head.getUint32(12 + 4 * n, true);
  const format = FORMATS[word(0)];
  if (head.getUint32(0) !== 0xab4b5458 || !format || word(8)) {
    throw new Error(`${file} is not a KTX 2.0 file as tilewright writes them`);
  }
  const [width, height, , layers] = [2, 3, 4, 5].map(word);
  const levels = Array.from({ length: word(7) }, (_, k) => {
    const [offset, bytes] = [80, 88].map((at) => Number(head.getBigUint64(at + 24 * k, true)));
    const data = format.half ? new Uint16Array(buffer, offset, bytes / 2) : new Uint8Array(buffer, offset, bytes);
    return { data, width: Math.max(1, width >> k), height: Math.max(1, height >> k) };
  });
  return { width, height, layers, levels, ...format };
}

function makeTexture({ width, height, layers, levels, format, gl: name, half, colorSpace }, renderer, clamp) {
  const gl = renderer.getContext();
  if (Math.max(width, height) > renderer.capabilities.maxTextureSize ||
      layers > gl.getParameter(gl.MAX_ARRAY_TEXTURE_LAYERS)) {
    throw new Error(`This device cannot hold a texture of ${width} x ${height} texels and ${layers} layers.`);
  }
  const wrap = layers || clamp ? THREE.ClampToEdgeWrapping : THREE.RepeatWrapping;
  const texture = Object.assign(
    layers ? new THREE.DataArrayTexture(levels[0].data, width, height, layers)
           : new THREE.DataTexture(levels[0].data, width, height),
    {
      format, type: half ? THREE.HalfFloatType : THREE.UnsignedByteType,
      mipmaps: levels, generateMipmaps: false, unpackAlignment: 1, wrapS: wrap, wrapT: wrap,
      minFilter: THREE.LinearMipmapLinearFilter, magFilter: THREE.LinearFilter,
      anisotropy: renderer.capabilities.getMaxAnisotropy(), needsUpdate: true,
    });
  if (colorSpace) texture.colorSpace = colorSpace;
  // three makes room for all levels of an array but fills the first; it calls this while the texture is bound.
  if (layers) texture.onUpdate = () => levels.forEach(({ data, width, height }, k) => {
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, k, 0, 0, 0, width, height, layers, gl[name],
      half ? gl.HALF_FLOAT : gl.UNSIGNED_BYTE, data);
  });
  return texture;
}

// What each slot does with its texel, after the part of three's shader that has its turn then.
const SLOTS = {
  color: ["map_fragment", "diffuseColor *= texel;"],
  opacity: ["alphamap_fragment", "diffuseColor.a *= texel.r;"],
  roughness: ["roughnessmap_fragment", "roughnessFactor *= texel.r;"],
  metallic: ["metalnessmap_fragment", "metalnessFactor *= texel.r;"],
  normal: ["normal_fragment_maps",
    "normal = twTurn(normal, -vViewPosition, twNormal(texel) * vec3(twRelief, twRelief, 1.0));"],
  height: ["normal_fragment_maps",
    "normal = twTurn(normal, -vViewPosition, twSlope(tw_height, texel.r));"],
  emission: ["emissivemap_fragment", "totalEmissiveRadiance += texel.rgb;"],
  occlusion: ["aomap_fragment",
    "reflectedLight.indirectDiffuse *= texel.r; reflectedLight.indirectSpecular *= texel.r;"],
};

/** Lays tone over a texel: over light by the map's mean, over numbers as it is. */
function layTone(slot, mean) {
  const tone = `twTone(tw_tone_${slot}, twPosition, twOrigin)`;
  if (mean[0] < 0) return `texel.rgb = clamp(texel.rgb + ${tone}, 0.0, 1.0); `;
  return `texel.rgb = twLay(texel.rgb, ${tone}, vec3(${mean.map((value) => value.toFixed(9))})); `;
}

const VERTEX = /* glsl */ `
varying vec2 twPosition;
uniform vec2 twRepeat, twOffset;
`;

const FRAGMENT = /* glsl */ `
${LOOKUP}
varying vec2 twPosition;
uniform ivec2 twOrigin;
uniform float twRelief;

#ifdef TW_LIT
// A normal from tangent space: east and north are where position changes as place does on the screen
// (Schueler 2013, "Normal mapping without precomputed tangents").
vec3 twTurn(vec3 normal, vec3 place, vec3 bump) {
  vec3 right = dFdx(place), up = dFdy(place);
  vec2 pr = dFdx(twPosition), pu = dFdy(twPosition);
  vec3 r = cross(up, normal), u = cross(normal, right);
  vec3 east = r * pr.x + u * pu.x, north = -(r * pr.y + u * pu.y);
  float size = inversesqrt(max(max(dot(east, east), dot(north, north)), 1e-30));
  // A bump is a dent from behind.
  #ifdef FLIP_SIDED
    size = -size;
  #elif defined(DOUBLE_SIDED)
    if (!gl_FrontFacing) size = -size;
  #endif
  return normalize((east * bump.x + north * bump.y) * size + normal * bump.z);
}

// A normal from heights (0 to 1 is twRelief tiles) at this place and a texel or a pixel further on.
vec3 twSlope(highp TW_SAMPLER map, float here) {
  vec2 far = max(max(abs(dFdx(twPosition)), abs(dFdy(twPosition))), {{texel}});
  float east = twSample(map, twFind(twPosition + vec2(far.x, 0.0), twOrigin)).r;
  float south = twSample(map, twFind(twPosition + vec2(0.0, far.y), twOrigin)).r;
  return vec3((here - east) / far.x * twRelief, (south - here) / far.y * twRelief, 1.0);
}
#endif
`;

/**
 * Have a material show the maps. Its userData.tilewright then holds, to change at any time,
 * repeat: tiles across one unit of uv; offset: the place of uv (0, 1), the upper left, in tiles;
 * origin: the cell that offset counts from, whole numbers (move it instead of offset to go far);
 * relief: strength of the normal map or, where there is none, tiles from the lowest to the highest point.
 */
function showTiles(material, maps, tones, slots) {
  const used = Object.keys(slots).filter((slot) => slot in SLOTS && !(slot === "height" && slots.normal));
  const look = material.userData.tilewright = {
    repeat: new THREE.Vector2(1, 1), offset: new THREE.Vector2(), origin: new THREE.Vector2(),
    relief: slots.normal ? 1 : 0.05,
  };
  // {{#cut_out}}
  // Alpha of the map of color tells holes; a transparent material blends them.
  if (slots.color === SET.slots.color && !material.transparent) material.alphaTest ||= 0.5;
  // {{/cut_out}}
  // Heights are there for their slopes, and those of tone are too gentle to be seen.
  const toneOf = (slot) => slot === "height" ? undefined : tones[slots[slot]];
  const before = material.onBeforeCompile, key = material.customProgramCacheKey();
  const means = used.map((slot) => toneOf(slot) ? SET.means[slots[slot]] : null);
  material.customProgramCacheKey = () => `${key} ${LOOKUP} ${used} ${JSON.stringify(means)}`;
  material.onBeforeCompile = (shader, renderer) => {
    before.call(material, shader, renderer);
    const has = (chunk) => shader.fragmentShader.includes(`#include <${chunk}>`);
    const after = (stage, chunk, text) => {
      const include = `#include <${chunk}>`;
      if (!shader[stage].includes(include)) {
        throw new Error(`tilewright: ${material.type} of three.js ${THREE.REVISION} has no <${chunk}>`);
      }
      shader[stage] = shader[stage].replace(include, () => `${include}\n${text}`);
    };
    // Unlit materials have no use for most slots.
    const shown = used.filter((slot) => slot === "color" || has(SLOTS[slot][0]));
    for (const slot of shown) {
      const [chunk, text] = SLOTS[slot];
      const tone = toneOf(slot);
      const lay = tone ? layTone(slot, SET.means[slots[slot]]) : "";
      after("fragmentShader", chunk, `{ vec4 texel = twSample(tw_${slot}, twAt); ${lay}${text} }`);
      shader.uniforms[`tw_${slot}`] = { value: maps[slots[slot]] };
      if (tone) shader.uniforms[`tw_tone_${slot}`] = { value: tone };
    }
    after("fragmentShader", "clipping_planes_fragment", "TwPlace twAt = twFind(twPosition, twOrigin);");
    after("fragmentShader", "common", [
      `#define TW_SAMPLER ${SET.form === "array" ? "sampler2DArray" : "sampler2D"}`,
      has("normal_fragment_maps") ? "#define TW_LIT" : "",
      FRAGMENT,
      ...shown.map((slot) => `uniform highp TW_SAMPLER tw_${slot};`),
      ...shown.filter(toneOf).map((slot) => `uniform highp sampler2D tw_tone_${slot};`),
    ].join("\n"));
    after("vertexShader", "common", VERTEX);
    after("vertexShader", "uv_vertex", "twPosition = vec2(uv.x, 1.0 - uv.y) * twRepeat + twOffset;");
    for (const name of Object.keys(look)) {
      shader.uniforms[`tw${name[0].toUpperCase()}${name.slice(1)}`] = { get value() { return look[name]; } };
    }
  };
  material.needsUpdate = true;
  return material;
}
