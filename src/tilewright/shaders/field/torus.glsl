// Cell of the corner packing that holds the tile with corners NE, SE, SW, NW, in closed form: docs/packing.md.

#ifdef ODD_COLORS

uvec2 torusPlace(uvec4 c) {
  const uint length = COLORS * COLORS;
  uint here = trainPosition(c.w, c.z), next = trainPosition(c.x, c.y);
  // Column x is the train moved by 0 + 1 + ... + (x - 1).
  uint x = (next + length - here) % length;
  return uvec2(x, (here + length * length - x * (x - 1u) / 2u) % length);
}

#else

// The packing over two colors: two bits for each of its 16 windows NW, NE, SW, SE.
uvec2 torusPlace(uvec4 c) {
  return (uvec2(PLACES_X, PLACES_Y) >> (16u * c.w + 8u * c.x + 4u * c.z + 2u * c.y)) & 3u;
}

#endif
