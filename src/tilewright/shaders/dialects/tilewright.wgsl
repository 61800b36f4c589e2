// Endless plane of corner tiles over {{colors}} colors, seed {{seed}}; made by tilewright {{version}}.
// Positions p are in tiles, x east, y south.
// {{#array}}
// {{^several}}
// Textures are arrays with a layer for each tile. Filter them trilinear or anisotropic; clamp.
// {{/several}}
// {{#several}}
// Textures are arrays with a layer for each of {{variants}} variants of each tile. Filter them trilinear or
// anisotropic; clamp.
// {{/several}}
// {{/array}}
// {{#grid}}
// Textures hold each picture in a square of a grid, with a gutter around it. Filter them trilinear or anisotropic;
// clamp.
// {{/grid}}
// {{#atlas}}
// {{^several}}
// Textures are atlases that hold each tile once. Filter them trilinear or anisotropic; repeat.
// {{/several}}
// {{#several}}
// Textures are atlases that hold each of {{variants}} variants of each tile once. Filter them trilinear or
// anisotropic; repeat.
// {{/several}}
// {{/atlas}}

fn tw_mix(word: u32) -> u32 {
  var h = word;
  h ^= h >> 16u; h *= {{m0}}u;
  h ^= h >> 15u; h *= {{m1}}u;
  return h ^ (h >> 15u);
}

// Hash state of a row of lattice points, for the signs of their coordinates and the low word of y.
fn tw_row(west: bool, north: bool, y: u32) -> vec2u {
  let start = select(select(vec2u({{a0}}u, {{b0}}u), vec2u({{a1}}u, {{b1}}u), west),
                     select(vec2u({{a2}}u, {{b2}}u), vec2u({{a3}}u, {{b3}}u), west), north);
  let a = tw_mix(start.x ^ y);
  return vec2u(a, tw_mix((start.y ^ a) + y));
}

// Color of the lattice point at the low word x of a row.
fn tw_color(row: vec2u, x: u32) -> u32 {
  var h = row.x ^ x;
  h ^= h >> 16u; h = h * {{m0}}u + row.y;
  h ^= h >> 15u; h *= {{m1}}u;
  h ^= h >> 15u;
  return ((h >> 8u) * {{colors}}u) >> 24u;
}

// Corner colors NE, SE, SW, NW of a cell.
fn tw_corners(cell: vec2i) -> vec4u {
  let x = u32(cell.x);
  let y = u32(cell.y);
  var north = tw_row(cell.x < 0, cell.y < 0, y);
  var south = tw_row(cell.x < 0, cell.y < -1, y + 1u);
  let nw = tw_color(north, x);
  let sw = tw_color(south, x);
  if (cell.x == -1) {  // its eastern corners are at x = 0
    north = tw_row(false, cell.y < 0, y);
    south = tw_row(false, cell.y < -1, y + 1u);
  }
  return vec4u(tw_color(north, x + 1u), tw_color(south, x + 1u), sw, nw);
}

// {{#several}}
// Which variant of its tile lies in a cell.
fn tw_variant(cell: vec2i) -> u32 {
  let x = u32(cell.x);
  let y = u32(cell.y);
  let start = select(select(vec2u({{va0}}u, {{vb0}}u), vec2u({{va1}}u, {{vb1}}u), cell.x < 0),
                     select(vec2u({{va2}}u, {{vb2}}u), vec2u({{va3}}u, {{vb3}}u), cell.x < 0), cell.y < 0);
  let a = tw_mix(start.x ^ y);
  var h = a ^ x;
  h ^= h >> 16u; h = h * {{m0}}u + tw_mix((start.y ^ a) + y);
  h ^= h >> 15u; h *= {{m1}}u;
  h ^= h >> 15u;
  return ((h >> 8u) * {{variants}}u) >> 24u;
}

// {{/several}}
// {{#classed}}
// Class of the lattice point at a cell's NW corner.
fn tw_class(cell: vec2i) -> u32 {
  let low = vec2u(cell) % {{classes}}u + select(vec2u(0u), vec2u({{below}}u), cell < vec2i(0));
  return (low.x + {{step}}u * low.y) % {{classes}}u;
}

// {{/classed}}
// {{#layers}}
// Number of the tile with these corners.
fn tw_tile(c: vec4u) -> u32 {
  return ((c.x * {{colors}}u + c.y) * {{colors}}u + c.z) * {{colors}}u + c.w;
}
// {{/layers}}
// {{#odd}}
// Where a pair of colors occurs in Wei's train.
fn tw_pair(a: u32, b: u32) -> u32 {
  if (b > a) { return b * b + 2u * a; }
  if (a == b) { return select((a + 1u) * (a + 1u) - 2u, 0u, a == 0u); }
  return select(a * a + 2u * b - 1u, (a + 1u) * (a + 1u) - 1u, b == 0u);
}

// Column and row in the atlas of the tile with these corners.
fn tw_place(c: vec4u) -> vec2u {
  let here = tw_pair(c.w, c.z);
  let column = (tw_pair(c.x, c.y) + {{side}}u - here) % {{side}}u;
  let shift = column * (column - 1u) / 2u % {{side}}u;
  return vec2u(column, (here + {{side}}u - shift) % {{side}}u);
}
// {{/odd}}
// {{#two}}
// Column and row in the atlas of the tile with these corners.
fn tw_place(c: vec4u) -> vec2u {
  let code = 2u * (((c.w * 2u + c.x) * 2u + c.z) * 2u + c.y);
  return vec2u(({{base_x}}u >> code) & 3u, ({{base_y}}u >> code) & 3u);
}
// {{/two}}
// {{#even}}
// Where a pair of colors occurs, among the rows that are y modulo 4.
fn tw_pair(y: u32, a: u32, b: u32) -> u32 {
  let before = select((b + {{half}}u - 1u) % {{half}}u, b, a + 1u < {{half}}u);
  let k = select(select({{half}}u * a + b, {{half}}u * before + a, y == 3u), {{half}}u * b + a, y == 1u);
  return 4u * k + y;
}

// Column and row in the atlas of the tile with these corners.
fn tw_place(c: vec4u) -> vec2u {
  let big = c / {{half}}u;
  let small = c % {{half}}u;
  let code = 2u * (((big.w * 2u + big.x) * 2u + big.z) * 2u + big.y);
  let x = ({{base_x}}u >> code) & 3u;
  let y = ({{base_y}}u >> code) & 3u;
  let here = tw_pair(y, small.w, small.z);
  let k = (tw_pair(y, small.x, small.y) + {{side}}u - here) % {{side}}u / 4u;
  let shift = 4u * (2u * k * (k - 1u) + x * k) % {{side}}u;
  return vec2u(4u * k + x, (here + {{side}}u - shift) % {{side}}u);
}
// {{/even}}

// {{#array}}
// Where p is sampled: place and layer, and gradients of the place taken before p was split into tiles.
struct TwPlace { uv: vec2f, layer: u32, dx: vec2f, dy: vec2f }

// p is counted from the cell origin; move it to have another part of the plane. Call it where all
// fragments of a quad do (uniform control flow).
fn tw_find(p: vec2f, origin: vec2i) -> TwPlace {
  let cell = floor(p);
  let uv = (p - cell) * {{scale}} + {{gutter}};
  let here = vec2i(cell) + origin;
  var layer = tw_tile(tw_corners(here));
// {{#classed}}
  layer += tw_class(here) * {{tiles}}u;
// {{/classed}}
// {{#several}}
  layer = layer * {{variants}}u + tw_variant(here);
// {{/several}}
  return TwPlace(uv, layer, dpdx(p) * {{scale}}, dpdy(p) * {{scale}});
}

fn tw_sample(map: texture_2d_array<f32>, filtering: sampler, at: TwPlace) -> vec4f {
  return textureSampleGrad(map, filtering, at.uv, at.layer, at.dx, at.dy);
}
// {{/array}}
// {{#atlas}}
// Where p is sampled, and gradients of that taken before p was split into tiles.
struct TwPlace { uv: vec2f, dx: vec2f, dy: vec2f }

// p is counted from the cell origin; move it to have another part of the plane. Call it where all
// fragments of a quad do (uniform control flow).
fn tw_find(p: vec2f, origin: vec2i) -> TwPlace {
  let cell = floor(p);
// {{^several}}
  let uv = (vec2f(tw_place(tw_corners(vec2i(cell) + origin))) + (p - cell)) * {{scale}};
// {{/several}}
// {{#several}}
  let here = vec2i(cell) + origin;
  let place = tw_place(tw_corners(here)) + vec2u(tw_variant(here) * {{side}}u, 0u);
  let uv = (vec2f(place) + (p - cell)) * {{scale}};
// {{/several}}
  return TwPlace(uv, dpdx(p) * {{scale}}, dpdy(p) * {{scale}});
}

fn tw_sample(map: texture_2d<f32>, filtering: sampler, at: TwPlace) -> vec4f {
  return textureSampleGrad(map, filtering, at.uv, at.dx, at.dy);
}
// {{/atlas}}
// {{#grid}}
// Where p is sampled, and gradients of that taken before p was split into tiles.
struct TwPlace { uv: vec2f, dx: vec2f, dy: vec2f }

// p is counted from the cell origin; move it to have another part of the plane. Call it where all
// fragments of a quad do (uniform control flow).
fn tw_find(p: vec2f, origin: vec2i) -> TwPlace {
  let cell = floor(p);
  let here = vec2i(cell) + origin;
  var picture = tw_tile(tw_corners(here));
// {{#classed}}
  picture += tw_class(here) * {{tiles}}u;
// {{/classed}}
// {{#several}}
  picture = picture * {{variants}}u + tw_variant(here);
// {{/several}}
  let square = vec2f(vec2u(picture % {{columns}}u, picture / {{columns}}u)) * {{square}};
  return TwPlace(square + (p - cell) * {{scale}} + {{gutter}}, dpdx(p) * {{scale}}, dpdy(p) * {{scale}});
}

fn tw_sample(map: texture_2d<f32>, filtering: sampler, at: TwPlace) -> vec4f {
  return textureSampleGrad(map, filtering, at.uv, at.dx, at.dy);
}
// {{/grid}}

// Normal of a normal map, green up (OpenGL): x east, y north, z out of the picture.
fn tw_normal(texel: vec4f) -> vec3f {
  let n = texel.xy * 2.0 - 1.0;
  return vec3f(n, sqrt(max(0.0, 1.0 - dot(n, n))));
}
// {{#toned}}
{{tone}}
// {{/toned}}
