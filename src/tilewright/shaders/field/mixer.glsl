// The table-free hash of docs/hashes.md: all words but the low ones of x and y are in the start states.

uint mix32(uint h) {
  h ^= h >> 16; h *= MULTIPLIER_1;
  h ^= h >> 15; h *= MULTIPLIER_2;
  return h ^ (h >> 15);
}

// State of a row: y is taken in.
uvec2 rowState(int x, int y) {
  uvec4 start = x < 0 ? view.west : view.east;
  uvec2 s = y < 0 ? start.zw : start.xy;
  uint a = mix32(s.x ^ uint(y));
  return uvec2(a, mix32((s.y ^ a) + uint(y)));
}

// 24 bits of a lattice point of the row.
uint finish24(uvec2 row, int x) {
  uint h = uint(x) ^ row.x;
  h ^= h >> 16; h = h * MULTIPLIER_1 + row.y;
  h ^= h >> 15; h *= MULTIPLIER_2;
  h ^= h >> 15;
  return h >> 8;
}

uint finish(uvec2 row, int x, uint count) { return (finish24(row, x) * count) >> 24; }

#ifdef VARIANTS
// Which variant of its tile lies in a cell.
uint variantAt(ivec2 at) {
  uvec4 start = at.x < 0 ? view.drawWest : view.drawEast;
  uvec2 s = at.y < 0 ? start.zw : start.xy;
  uint a = mix32(s.x ^ uint(at.y));
  return finish(uvec2(a, mix32((s.y ^ a) + uint(at.y))), at.x, VARIANTS);
}
#endif

// Colors at (first, y) and (last, y), first < last: one state serves both but where x changes its sign.
uvec2 rowColors(int first, int last, int y, uint count) {
  uvec2 row = rowState(last, y);
  uint end = finish(row, last, count);
  if ((first ^ last) < 0) row = rowState(first, y);
  return uvec2(finish(row, first, count), end);
}

uvec2 columnColors(int x, int first, int last, uint count) {
  return uvec2(finish(rowState(x, first), x, count), finish(rowState(x, last), x, count));
}

// Corners NE, SE, SW, NW of the cell whose NW lattice point is given.
uvec4 cornerColors(ivec2 at, uint count) {
  uvec2 north = rowColors(at.x, at.x + 1, at.y, count);
  uvec2 south = rowColors(at.x, at.x + 1, at.y + 1, count);
  return uvec4(north.y, south.y, south.x, north.x);
}
