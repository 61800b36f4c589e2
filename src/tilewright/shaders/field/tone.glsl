// Tone outside the tiles: patches of a small picture around the corners of a triangle of its grid, blended so that
// their variance stays.

layout(set = 0, binding = 5) uniform texture2D tone;
layout(set = 0, binding = 6) uniform sampler mirrored;

// The place that a point of the grid takes from the photograph, 12 bits for its row and for its column.
uint placeAt(ivec2 at) {
  uvec4 start = at.x < 0 ? view.toneWest : view.toneEast;
  uvec2 s = at.y < 0 ? start.zw : start.xy;
  uint a = mix32(s.x ^ uint(at.y));
  return finish24(uvec2(a, mix32((s.y ^ a) + uint(at.y))), at.x);
}

vec3 patchAt(vec2 square, vec2 corner, vec2 at, vec2 size, vec2 dx, vec2 dy) {
  uint place = placeAt(view.square.xy + ivec2(square) + ivec2(corner));
  vec2 middle = vec2(float((place & 4095u) * uint(size.x) >> 12), float((place >> 12) * uint(size.y) >> 12));
  return textureGrad(sampler2D(tone, mirrored), ((at - corner) * SPAN * TONE_TEXELS + middle) / size, dx, dy).rgb;
}

vec3 toneAt(vec2 p, vec2 dx, vec2 dy) {
  vec2 q = (p + view.rest.xy) / SPAN;
  vec2 square = floor(q), at = q - square, size = vec2(textureSize(sampler2D(tone, mirrored), 0));
  float far = at.x + at.y > 1.0 ? 1.0 : 0.0;
  vec3 weights = far > 0.5 ? vec3(at.x + at.y - 1.0, 1.0 - at.y, 1.0 - at.x) : vec3(1.0 - at.x - at.y, at.x, at.y);
  dx *= TONE_TEXELS / size;
  dy *= TONE_TEXELS / size;
  vec3 sum = weights.x * patchAt(square, vec2(far, far), at, size, dx, dy);
  sum += weights.y * patchAt(square, vec2(1.0, 0.0), at, size, dx, dy);
  sum += weights.z * patchAt(square, vec2(0.0, 1.0), at, size, dx, dy);
  return sum / length(weights);
}

#if defined(TONE_OF_COLOR)
// Tone is added to light as sRGB encodes it; what is darker than the mean takes less of it.
vec3 withTone(vec3 light, vec2 p, vec2 dx, vec2 dy) {
  vec3 bent = 1.055 * pow(max(light, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
  vec3 bare = mix(12.92 * light, bent, step(vec3(0.0031308), light));
  vec3 share = mix(bare / max(TONE_MEAN, vec3(1e-6)), vec3(1.0), step(TONE_MEAN, bare));
  vec3 shown = max(bare + share * toneAt(p, dx, dy), vec3(0.0));
  vec3 straight = pow((max(shown, vec3(0.04045)) + 0.055) / 1.055, vec3(2.4));
  return mix(shown / 12.92, straight, step(vec3(0.04045), shown));
}
#elif defined(TONE_OF_ROUGHNESS)
vec3 withTone(vec3 roughness, vec2 p, vec2 dx, vec2 dy) {
  return clamp(roughness + toneAt(p, dx, dy), 0.0, 1.0);
}
#else
vec3 withTone(vec3 numbers, vec2 p, vec2 dx, vec2 dy) {
  return numbers + toneAt(p, dx, dy);
}
#endif
