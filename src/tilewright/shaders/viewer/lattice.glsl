// The lattice hash, bit for bit as in docs/hashes.md.
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

// 24 bits of a point of the row.
uint finish(uvec2 state, uint xLow) {
  uint h = xLow ^ state.x;
  h ^= h >> 16; h = h * 0x21f0aaadu + state.y;
  h ^= h >> 15; h *= 0xd35a2d97u;
  h ^= h >> 15;
  return h >> 8;
}

uvec2 plus(uvec2 a, int d) {
  uint low = a.x + uint(d);
  return uvec2(low, a.y + (d < 0 ? 0xffffffffu : 0u) + (low < a.x ? 1u : 0u));
}

uvec2 twice(uvec2 a) { return uvec2(a.x << 1, (a.y << 1) | (a.x >> 31)); }
