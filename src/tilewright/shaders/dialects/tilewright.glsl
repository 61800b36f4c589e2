// Endless plane of corner tiles over {{colors}} colors, seed {{seed}}; made by tilewright {{version}}.
// GLSL 3.30 or GLSL ES 3.00, highp. Positions p are in tiles, x east, y south.
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

uint twMix(uint h) {
  h ^= h >> 16u; h *= {{m0}}u;
  h ^= h >> 15u; h *= {{m1}}u;
  return h ^ (h >> 15u);
}

// Hash state of a row of lattice points, for the signs of their coordinates and the low word of y.
uvec2 twRow(bool west, bool north, uint y) {
  uvec2 start = north ? (west ? uvec2({{a3}}u, {{b3}}u) : uvec2({{a2}}u, {{b2}}u))
                      : (west ? uvec2({{a1}}u, {{b1}}u) : uvec2({{a0}}u, {{b0}}u));
  uint a = twMix(start.x ^ y);
  return uvec2(a, twMix((start.y ^ a) + y));
}

// Color of the lattice point at the low word x of a row.
uint twColor(uvec2 row, uint x) {
  uint h = row.x ^ x;
  h ^= h >> 16u; h = h * {{m0}}u + row.y;
  h ^= h >> 15u; h *= {{m1}}u;
  h ^= h >> 15u;
  return ((h >> 8u) * {{colors}}u) >> 24u;
}

// Corner colors NE, SE, SW, NW of a cell.
uvec4 twCorners(ivec2 cell) {
  uint x = uint(cell.x), y = uint(cell.y);
  uvec2 north = twRow(cell.x < 0, cell.y < 0, y), south = twRow(cell.x < 0, cell.y < -1, y + 1u);
  uint nw = twColor(north, x), sw = twColor(south, x);
  if (cell.x == -1) {  // its eastern corners are at x = 0
    north = twRow(false, cell.y < 0, y);
    south = twRow(false, cell.y < -1, y + 1u);
  }
  return uvec4(twColor(north, x + 1u), twColor(south, x + 1u), sw, nw);
}

// {{#several}}
// Which variant of its tile lies in a cell.
uint twVariant(ivec2 cell) {
  uint x = uint(cell.x), y = uint(cell.y);
  uvec2 start = cell.y < 0 ? (cell.x < 0 ? uvec2({{va3}}u, {{vb3}}u) : uvec2({{va2}}u, {{vb2}}u))
                           : (cell.x < 0 ? uvec2({{va1}}u, {{vb1}}u) : uvec2({{va0}}u, {{vb0}}u));
  uint a = twMix(start.x ^ y), h = a ^ x;
  h ^= h >> 16u; h = h * {{m0}}u + twMix((start.y ^ a) + y);
  h ^= h >> 15u; h *= {{m1}}u;
  h ^= h >> 15u;
  return ((h >> 8u) * {{variants}}u) >> 24u;
}

// {{/several}}
// {{#classed}}
// Class of the lattice point at a cell's NW corner.
uint twClass(ivec2 cell) {
  uint x = uint(cell.x) % {{classes}}u + (cell.x < 0 ? {{below}}u : 0u);
  uint y = uint(cell.y) % {{classes}}u + (cell.y < 0 ? {{below}}u : 0u);
  return (x + {{step}}u * y) % {{classes}}u;
}

// {{/classed}}
// {{#layers}}
// Number of the tile with these corners.
uint twTile(uvec4 c) { return ((c.x * {{colors}}u + c.y) * {{colors}}u + c.z) * {{colors}}u + c.w; }
// {{/layers}}
// {{#odd}}
// Where a pair of colors occurs in Wei's train.
uint twPair(uint a, uint b) {
  if (b > a) return b * b + 2u * a;
  if (a == b) return a == 0u ? 0u : (a + 1u) * (a + 1u) - 2u;
  return b == 0u ? (a + 1u) * (a + 1u) - 1u : a * a + 2u * b - 1u;
}

// Column and row in the atlas of the tile with these corners.
uvec2 twPlace(uvec4 c) {
  uint here = twPair(c.w, c.z), column = (twPair(c.x, c.y) + {{side}}u - here) % {{side}}u;
  uint shift = column * (column - 1u) / 2u % {{side}}u;
  return uvec2(column, (here + {{side}}u - shift) % {{side}}u);
}
// {{/odd}}
// {{#two}}
// Column and row in the atlas of the tile with these corners.
uvec2 twPlace(uvec4 c) {
  uint code = 2u * (((c.w * 2u + c.x) * 2u + c.z) * 2u + c.y);
  return uvec2({{base_x}}u >> code, {{base_y}}u >> code) & 3u;
}
// {{/two}}
// {{#even}}
// Where a pair of colors occurs, among the rows that are y modulo 4.
uint twPair(uint y, uint a, uint b) {
  uint before = a + 1u < {{half}}u ? b : (b + {{half}}u - 1u) % {{half}}u;
  uint k = y == 1u ? {{half}}u * b + a : y == 3u ? {{half}}u * before + a : {{half}}u * a + b;
  return 4u * k + y;
}

// Column and row in the atlas of the tile with these corners.
uvec2 twPlace(uvec4 c) {
  uvec4 big = c / {{half}}u, small = c % {{half}}u;
  uint code = 2u * (((big.w * 2u + big.x) * 2u + big.z) * 2u + big.y);
  uint x = ({{base_x}}u >> code) & 3u, y = ({{base_y}}u >> code) & 3u;
  uint here = twPair(y, small.w, small.z), next = twPair(y, small.x, small.y);
  uint k = (next + {{side}}u - here) % {{side}}u / 4u;
  uint shift = 4u * (2u * k * (k - 1u) + x * k) % {{side}}u;
  return uvec2(4u * k + x, (here + {{side}}u - shift) % {{side}}u);
}
// {{/even}}

// {{#array}}
// Where p is sampled: place and layer, and gradients of the place taken before p was split into tiles.
struct TwPlace { vec3 uv; vec2 dx; vec2 dy; };

// p is counted from the cell origin; move it to have another part of the plane.
TwPlace twFind(vec2 p, ivec2 origin) {
  vec2 cell = floor(p);
  vec2 uv = (p - cell) * {{scale}} + {{gutter}};
  ivec2 here = ivec2(cell) + origin;
  uint layer = twTile(twCorners(here));
// {{#classed}}
  layer += twClass(here) * {{tiles}}u;
// {{/classed}}
// {{#several}}
  layer = layer * {{variants}}u + twVariant(here);
// {{/several}}
  return TwPlace(vec3(uv, float(layer)), dFdx(p) * {{scale}}, dFdy(p) * {{scale}});
}

vec4 twSample(highp sampler2DArray map, TwPlace at) { return textureGrad(map, at.uv, at.dx, at.dy); }
// {{/array}}
// {{#atlas}}
// Where p is sampled, and gradients of that taken before p was split into tiles.
struct TwPlace { vec2 uv; vec2 dx; vec2 dy; };

// p is counted from the cell origin; move it to have another part of the plane.
TwPlace twFind(vec2 p, ivec2 origin) {
  vec2 cell = floor(p);
// {{^several}}
  vec2 uv = (vec2(twPlace(twCorners(ivec2(cell) + origin))) + (p - cell)) * {{scale}};
// {{/several}}
// {{#several}}
  ivec2 here = ivec2(cell) + origin;
  uvec2 place = twPlace(twCorners(here)) + uvec2(twVariant(here) * {{side}}u, 0u);
  vec2 uv = (vec2(place) + (p - cell)) * {{scale}};
// {{/several}}
  return TwPlace(uv, dFdx(p) * {{scale}}, dFdy(p) * {{scale}});
}

vec4 twSample(highp sampler2D map, TwPlace at) { return textureGrad(map, at.uv, at.dx, at.dy); }
// {{/atlas}}
// {{#grid}}
// Where p is sampled, and gradients of that taken before p was split into tiles.
struct TwPlace { vec2 uv; vec2 dx; vec2 dy; };

// p is counted from the cell origin; move it to have another part of the plane.
TwPlace twFind(vec2 p, ivec2 origin) {
  vec2 cell = floor(p);
  ivec2 here = ivec2(cell) + origin;
  uint picture = twTile(twCorners(here));
// {{#classed}}
  picture += twClass(here) * {{tiles}}u;
// {{/classed}}
// {{#several}}
  picture = picture * {{variants}}u + twVariant(here);
// {{/several}}
  vec2 square = vec2(picture % {{columns}}u, picture / {{columns}}u) * {{square}};
  return TwPlace(square + (p - cell) * {{scale}} + {{gutter}}, dFdx(p) * {{scale}}, dFdy(p) * {{scale}});
}

vec4 twSample(highp sampler2D map, TwPlace at) { return textureGrad(map, at.uv, at.dx, at.dy); }
// {{/grid}}

// Normal of a normal map, green up (OpenGL): x east, y north, z out of the picture.
vec3 twNormal(vec4 texel) {
  vec2 n = texel.xy * 2.0 - 1.0;
  return vec3(n, sqrt(max(0.0, 1.0 - dot(n, n))));
}
// {{#toned}}
{{tone}}
// {{/toned}}
