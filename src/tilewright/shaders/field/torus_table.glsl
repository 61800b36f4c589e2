// Cell of the corner packing that holds the tile with corners NE, SE, SW, NW, from a table.

uvec2 torusPlace(uvec4 c) {
  uint place = table.entries[PLACES + ((c.x * COLORS + c.y) * COLORS + c.z) * COLORS + c.w];
  return uvec2(place & 0xffffu, place >> 16);
}
