
// What varies over more than a tile: patches of a small picture of it (half floats, filtered as the maps
// are; clamp) around the corners of a triangle of their grid, blended so that their variance stays.

// Square of the grid that holds a cell, along one axis.
fn tw_square(cell: i32) -> i32 {
  if (cell < 0) { return -1 - (-1 - cell) / {{span}}; }
  return cell / {{span}};
}

// Texel that lies at a corner of a square.
fn tw_middle(square: vec2i, corner: vec2i, size: vec2u) -> vec2f {
  let x = u32(square.x) + u32(corner.x);
  let y = u32(square.y) + u32(corner.y);
  let west = square.x < -corner.x;
  let start = select(select(vec2u({{ta0}}u, {{tb0}}u), vec2u({{ta1}}u, {{tb1}}u), west),
                     select(vec2u({{ta2}}u, {{tb2}}u), vec2u({{ta3}}u, {{tb3}}u), west), square.y < -corner.y);
  let a = tw_mix(start.x ^ y);
  var h = a ^ x;
  h ^= h >> 16u; h = h * {{m0}}u + tw_mix((start.y ^ a) + y);
  h ^= h >> 15u; h *= {{m1}}u;
  h = (h ^ (h >> 15u)) >> 8u;
  return vec2f(vec2u(((h & 4095u) * size.x) >> 12u, ((h >> 12u) * size.y) >> 12u));
}

// A patch, mirrored at the borders of the picture.
fn tw_patch(tone: texture_2d<f32>, filtering: sampler, at: vec2f, dx: vec2f, dy: vec2f) -> vec3f {
  let folded = at - 2.0 * floor(0.5 * at);
  return textureSampleGrad(tone, filtering, min(folded, 2.0 - folded), dx, dy).rgb;
}

// Tone at p, around 0, of colors in sRGB. Call it where all fragments of a quad do (uniform control flow).
fn tw_tone(tone: texture_2d<f32>, filtering: sampler, p: vec2f, origin: vec2i) -> vec3f {
  let texels = textureDimensions(tone);
  let size = vec2f(texels);
  let scale = {{tone_texels}} / size;
  let cell = floor(p);
  let dx = dpdx(p) * scale;
  let dy = dpdy(p) * scale;
  let here = vec2i(cell) + origin;
  let square = vec2i(tw_square(here.x), tw_square(here.y));
  let at = vec2f(here - square * {{span}}) + p - cell;
  let share = at / {{span}}.0;
  let over = share.x + share.y > 1.0;
  let weights = select(vec3f(1.0 - share.x - share.y, share),
                       vec3f(share.x + share.y - 1.0, 1.0 - share.y, 1.0 - share.x), over);
  var corners = array<vec2i, 3>(vec2i(select(0, 1, over)), vec2i(1, 0), vec2i(0, 1));
  var sum = vec3f(0.0);
  for (var k = 0; k < 3; k++) {
    let middle = tw_middle(square, corners[k], texels);
    let there = (at - vec2f(corners[k] * {{span}})) * scale + middle / size;
    sum += weights[k] * tw_patch(tone, filtering, there, dx, dy);
  }
  return sum / length(weights);
}

// A map's light with its tone, which is added to light as sRGB encodes it; what is darker than the map's mean takes
// less of it. Numbers, such as roughness, take tone as it is: clamp(number + tw_tone(...).r, 0.0, 1.0).
fn tw_lay(light: vec3f, tone: vec3f, mean: vec3f) -> vec3f {
  let bent = 1.055 * pow(max(light, vec3f(0.0031308)), vec3f(1.0 / 2.4)) - 0.055;
  let bare = mix(12.92 * light, bent, step(vec3f(0.0031308), light));
  let share = mix(bare / max(mean, vec3f(1e-6)), vec3f(1.0), step(mean, bare));
  let shown = max(bare + share * tone, vec3f(0.0));
  let straight = pow((max(shown, vec3f(0.04045)) + 0.055) / 1.055, vec3f(2.4));
  return mix(shown / 12.92, straight, step(vec3f(0.04045), shown));
}
