uint TwMix(uint h) {
  h ^= h >> 16; h *= {{m0}}u;
  h ^= h >> 15; h *= {{m1}}u;
  return h ^ (h >> 15);
}

// Hash state of a row of lattice points, for the signs of their coordinates and the low word of y.
uint2 TwRow(bool west, bool north, uint y) {
  uint2 east = north ? uint2({{a2}}u, {{b2}}u) : uint2({{a0}}u, {{b0}}u);
  uint2 start = west ? (north ? uint2({{a3}}u, {{b3}}u) : uint2({{a1}}u, {{b1}}u)) : east;
  uint a = TwMix(start.x ^ y);
  return uint2(a, TwMix((start.y ^ a) + y));
}

// Color of the lattice point at the low word x of a row.
uint TwColor(uint2 row, uint x) {
  uint h = row.x ^ x;
  h ^= h >> 16; h = h * {{m0}}u + row.y;
  h ^= h >> 15; h *= {{m1}}u;
  h ^= h >> 15;
  return ((h >> 8) * {{colors}}u) >> 24;
}

// Corner colors NE, SE, SW, NW of a cell.
uint4 TwCorners(int2 cell) {
  uint x = (uint)cell.x, y = (uint)cell.y;
  uint2 north = TwRow(cell.x < 0, cell.y < 0, y), south = TwRow(cell.x < 0, cell.y < -1, y + 1u);
  uint nw = TwColor(north, x), sw = TwColor(south, x);
  if (cell.x == -1) {  // its eastern corners are at x = 0
    north = TwRow(false, cell.y < 0, y);
    south = TwRow(false, cell.y < -1, y + 1u);
  }
  return uint4(TwColor(north, x + 1u), TwColor(south, x + 1u), sw, nw);
}

// {{#several}}
// Which variant of its tile lies in a cell.
uint TwVariant(int2 cell) {
  uint x = (uint)cell.x, y = (uint)cell.y;
  uint2 east = cell.y < 0 ? uint2({{va2}}u, {{vb2}}u) : uint2({{va0}}u, {{vb0}}u);
  uint2 west = cell.y < 0 ? uint2({{va3}}u, {{vb3}}u) : uint2({{va1}}u, {{vb1}}u);
  uint2 start = cell.x < 0 ? west : east;
  uint a = TwMix(start.x ^ y), h = a ^ x;
  h ^= h >> 16; h = h * {{m0}}u + TwMix((start.y ^ a) + y);
  h ^= h >> 15; h *= {{m1}}u;
  h ^= h >> 15;
  return ((h >> 8) * {{variants}}u) >> 24;
}

// {{/several}}
// {{#classed}}
// Class of the lattice point at a cell's NW corner.
uint TwClass(int2 cell) {
  uint x = (uint)cell.x % {{classes}}u + (cell.x < 0 ? {{below}}u : 0u);
  uint y = (uint)cell.y % {{classes}}u + (cell.y < 0 ? {{below}}u : 0u);
  return (x + {{step}}u * y) % {{classes}}u;
}

// {{/classed}}
// {{#layers}}
// Number of the tile with these corners.
uint TwTile(uint4 c) { return ((c.x * {{colors}}u + c.y) * {{colors}}u + c.z) * {{colors}}u + c.w; }
// {{/layers}}
// {{#odd}}
// Where a pair of colors occurs in Wei's train.
uint TwPair(uint a, uint b) {
  if (b > a) return b * b + 2u * a;
  if (a == b) return a == 0u ? 0u : (a + 1u) * (a + 1u) - 2u;
  return b == 0u ? (a + 1u) * (a + 1u) - 1u : a * a + 2u * b - 1u;
}

// Column and row in the atlas of the tile with these corners.
uint2 TwPlaceOf(uint4 c) {
  uint here = TwPair(c.w, c.z), column = (TwPair(c.x, c.y) + {{side}}u - here) % {{side}}u;
  uint shift = column * (column - 1u) / 2u % {{side}}u;
  return uint2(column, (here + {{side}}u - shift) % {{side}}u);
}
// {{/odd}}
// {{#two}}
// Column and row in the atlas of the tile with these corners.
uint2 TwPlaceOf(uint4 c) {
  uint code = 2u * (((c.w * 2u + c.x) * 2u + c.z) * 2u + c.y);
  return uint2({{base_x}}u >> code, {{base_y}}u >> code) & 3u;
}
// {{/two}}
// {{#even}}
// Where a pair of colors occurs, among the rows that are y modulo 4.
uint TwPair(uint y, uint a, uint b) {
  uint before = a + 1u < {{half}}u ? b : (b + {{half}}u - 1u) % {{half}}u;
  uint k = y == 1u ? {{half}}u * b + a : y == 3u ? {{half}}u * before + a : {{half}}u * a + b;
  return 4u * k + y;
}

// Column and row in the atlas of the tile with these corners.
uint2 TwPlaceOf(uint4 c) {
  uint4 big = c / {{half}}u, small_ = c % {{half}}u;
  uint code = 2u * (((big.w * 2u + big.x) * 2u + big.z) * 2u + big.y);
  uint x = ({{base_x}}u >> code) & 3u, y = ({{base_y}}u >> code) & 3u;
  uint here = TwPair(y, small_.w, small_.z), next = TwPair(y, small_.x, small_.y);
  uint k = (next + {{side}}u - here) % {{side}}u / 4u;
  uint shift = 4u * (2u * k * (k - 1u) + x * k) % {{side}}u;
  return uint2(4u * k + x, (here + {{side}}u - shift) % {{side}}u);
}
// {{/even}}
