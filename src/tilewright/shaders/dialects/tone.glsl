
// What varies over more than a tile: patches of a small picture of it (half floats, filtered as the maps
// are; clamp) around the corners of a triangle of their grid, blended so that their variance stays.

// Square of the grid that holds a cell, along one axis.
int twSquare(int cell) { return cell < 0 ? -1 - (-1 - cell) / {{span}} : cell / {{span}}; }

// Texel that lies at a corner of a square.
vec2 twMiddle(ivec2 square, ivec2 corner, uvec2 size) {
  uint x = uint(square.x) + uint(corner.x), y = uint(square.y) + uint(corner.y);
  bool west = square.x < -corner.x;
  uvec2 start = square.y < -corner.y ? (west ? uvec2({{ta3}}u, {{tb3}}u) : uvec2({{ta2}}u, {{tb2}}u))
                                     : (west ? uvec2({{ta1}}u, {{tb1}}u) : uvec2({{ta0}}u, {{tb0}}u));
  uint a = twMix(start.x ^ y), h = a ^ x;
  h ^= h >> 16u; h = h * {{m0}}u + twMix((start.y ^ a) + y);
  h ^= h >> 15u; h *= {{m1}}u;
  h = (h ^ (h >> 15u)) >> 8u;
  return vec2(((h & 4095u) * size.x) >> 12u, ((h >> 12u) * size.y) >> 12u);
}

// A patch, mirrored at the borders of the picture.
vec3 twPatch(highp sampler2D tone, vec2 at, vec2 dx, vec2 dy) {
  vec2 folded = at - 2.0 * floor(0.5 * at);
  return textureGrad(tone, min(folded, 2.0 - folded), dx, dy).rgb;
}

// Tone at p, around 0, of colors in sRGB. Call it where all fragments of a quad do.
vec3 twTone(highp sampler2D tone, vec2 p, ivec2 origin) {
  vec2 size = vec2(textureSize(tone, 0)), scale = {{tone_texels}} / size, cell = floor(p);
  vec2 dx = dFdx(p) * scale, dy = dFdy(p) * scale;
  ivec2 here = ivec2(cell) + origin, square = ivec2(twSquare(here.x), twSquare(here.y));
  vec2 at = vec2(here - square * {{span}}) + p - cell, share = at / {{span}}.0;
  int far = share.x + share.y > 1.0 ? 1 : 0;
  vec3 weights = far > 0 ? vec3(share.x + share.y - 1.0, 1.0 - share.yx) : vec3(1.0 - share.x - share.y, share);
  ivec2 corners[3] = ivec2[3](ivec2(far), ivec2(1, 0), ivec2(0, 1));
  vec3 sum = vec3(0.0);
  for (int k = 0; k < 3; k++) {
    vec2 middle = twMiddle(square, corners[k], uvec2(size));
    sum += weights[k] * twPatch(tone, (at - vec2(corners[k] * {{span}})) * scale + middle / size, dx, dy);
  }
  return sum / length(weights);
}

// A map's light with its tone, which is added to light as sRGB encodes it; what is darker than the map's mean takes
// less of it. Numbers, such as roughness, take tone as it is: clamp(number + twTone(...).r, 0.0, 1.0).
vec3 twLay(vec3 light, vec3 tone, vec3 mean) {
  vec3 bent = 1.055 * pow(max(light, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055;
  vec3 bare = mix(12.92 * light, bent, step(vec3(0.0031308), light));
  vec3 share = mix(bare / max(mean, vec3(1e-6)), vec3(1.0), step(mean, bare));
  vec3 shown = max(bare + share * tone, vec3(0.0));
  vec3 straight = pow((max(shown, vec3(0.04045)) + 0.055) / 1.055, vec3(2.4));
  return mix(shown / 12.92, straight, step(vec3(0.04045), shown));
}
