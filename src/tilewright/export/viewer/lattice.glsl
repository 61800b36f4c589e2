// The lattice hash and the direct tilings, bit for bit as in docs/architecture.md and tilings/direct.py.
// 64-bit integers are uvec2(low, high).

uint mix32(uint h) {
  h ^= h >> 16; h *= 0x21f0aaadu;
  h ^= h >> 15; h *= 0xd35a2d97u;
  return h ^ (h >> 15);
}

uvec2 absorb(uvec2 state, uint word) {
  uint a = mix32(state.x ^ word);
  return uvec2(a, mix32((state.y ^ a) + word));
}

// State after everything but the low word of x; start has taken in stream, seed and z.
uvec2 startRow(uvec2 start, uint xHigh, uvec2 y) {
  return absorb(absorb(absorb(start, xHigh), y.y), y.x);
}

uint finish(uvec2 state, uint xLow, uint count) {
  uint h = xLow ^ state.x;
  h ^= h >> 16; h = h * 0x21f0aaadu + state.y;
  h ^= h >> 15; h *= 0xd35a2d97u;
  h ^= h >> 15;
  return ((h >> 8) * count) >> 24;
}

uvec2 plus(uvec2 a, int d) {
  uint low = a.x + uint(d);
  return uvec2(low, a.y + (d < 0 ? 0xffffffffu : 0u) + (low < a.x ? 1u : 0u));
}

uvec2 twice(uvec2 a) { return uvec2(a.x << 1, (a.y << 1) | (a.x >> 31)); }

// Colors of two lattice points (x0, y) and (x1, y) of one row.
uvec2 twoColors(uvec2 start, uvec2 x0, uvec2 x1, uvec2 y, uint count) {
  uvec2 state = startRow(start, x0.y, y);
  uint first = finish(state, x0.x, count);
  if (x1.y != x0.y) state = startRow(start, x1.y, y);
  return uvec2(first, finish(state, x1.x, count));
}

uint oneColor(uvec2 start, uvec2 x, uvec2 y, uint count) {
  return finish(startRow(start, x.y, y), x.x, count);
}

// NE, SE, SW, NW of the cell, from the lattice points around it.
uvec4 cornerColors(uvec2 start, uvec2 x, uvec2 y, uint count) {
  uvec2 north = twoColors(start, x, plus(x, 1), y, count);
  uvec2 south = twoColors(start, x, plus(x, 1), plus(y, 1), count);
  return uvec4(north.y, south.y, south.x, north.x);
}

#if defined(ALGORITHM_EDGES) || defined(ALGORITHM_MARKED_EDGES)
// N, E, S, W: one hash on a lattice twice as dense.
uvec4 edgeColors(uvec2 x, uvec2 y) {
  uvec2 x2 = twice(x), y2 = twice(y);
  uvec2 vertical = twoColors(uFirst, x2, plus(x2, 2), plus(y2, 1), uRadices.y);
  return uvec4(
    oneColor(uFirst, plus(x2, 1), y2, uRadices.x), vertical.y,
    oneColor(uFirst, plus(x2, 1), plus(y2, 2), uRadices.x), vertical.x);
}
#elif defined(ALGORITHM_SUMS) || defined(ALGORITHM_MARKED_SUMS)
// N, E, S, W: sums of the colors at their ends.
uvec4 edgeColors(uvec2 x, uvec2 y) {
  uvec4 c = cornerColors(uFirst, x, y, uRadices.x);
  return (c.wxyz + c.xyzw) % uRadices.x;
}
#elif defined(ALGORITHM_BITS)
// N, E, S, W: the bits of the tiles before, on either axis.
uvec4 edgeColors(uvec2 x, uvec2 y) {
  uvec4 edges = uvec4(0u);
  for (int back = 1; (1u << back) <= uRadices.x; back++) {
    uint shift = uint(back - 1);
    edges.x |= oneColor(uFirst, x, plus(y, -back), 2u) << shift;
    edges.y |= oneColor(uFirst, plus(x, 1 - back), y, 2u) << shift;
    edges.z |= oneColor(uFirst, x, plus(y, 1 - back), 2u) << shift;
    edges.w |= oneColor(uFirst, plus(x, -back), y, 2u) << shift;
  }
  return edges;
}
#endif

struct Slots { uvec4 edges; uvec4 corners; };

Slots slotsAt(uvec2 x, uvec2 y) {
  Slots s = Slots(uvec4(0u), uvec4(0u));
#ifdef HAS_EDGES
  s.edges = edgeColors(x, y);
#endif
#ifdef HAS_CORNERS
  s.corners = cornerColors(CORNER_STREAM, x, y, uRadices.w);
#endif
  return s;
}

// Number of the tile at a cell counted from the origin, -1 where there is none.
int tileAt(ivec2 cell) {
  if (uRepeat >= 0) return uRepeat;
  uvec2 x = plus(uOriginX, cell.x), y = plus(uOriginY, cell.y);
#ifdef ALGORITHM_BAKED
  if ((x.y | y.y) != 0u || any(greaterThanEqual(uvec2(x.x, y.x), uvec2(textureSize(uTable, 0))))) return -1;
  return int(texelFetch(uTable, ivec2(x.x, y.x), 0).r);
#else
  Slots s = slotsAt(x, y);
  uint code = 0u;
#ifdef HAS_EDGES
  code = ((s.edges.x * uRadices.y + s.edges.y) * uRadices.x + s.edges.z) * uRadices.y + s.edges.w;
#endif
#ifdef HAS_CORNERS
  for (int i = 0; i < 4; i++) code = code * uRadices.w + s.corners[i];
#endif
#ifdef COMPLETE
  return int(code);
#else
  uint wide = uint(textureSize(uTable, 0).x);
  return int(texelFetch(uTable, ivec2(code % wide, code / wide), 0).r);
#endif
#endif
}
