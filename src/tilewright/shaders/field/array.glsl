// A layer for each tile and variant, with gutters: one fetch at the place in the tile, gradients of the whole coordinate.

layout(set = 0, binding = 3) uniform texture2DArray tiles;

#ifdef CLASSES
// Class of the lattice point at a cell's NW corner; the view knows that of the cell it counts from.
uint classAt(ivec2 cell) {
  int sum = int(view.x.w) + cell.x % CLASSES + STEP * (cell.y % CLASSES);
  return uint((sum % CLASSES + CLASSES) % CLASSES);
}
#endif

vec4 sampleField(vec2 p, vec2 dx, vec2 dy) {
  vec2 cell = floor(p);
  uvec4 c = cornerColors(view.origin.xy + ivec2(cell), COLORS);
  uint tile = ((c.x * COLORS + c.y) * COLORS + c.z) * COLORS + c.w;
#ifdef CLASSES
  tile += classAt(ivec2(cell)) * (COLORS * COLORS * COLORS * COLORS);
#endif
#ifdef VARIANTS
  tile = tile * VARIANTS + variantAt(view.origin.zw + ivec2(cell));
#endif
  vec2 at = (p - cell) * INNER + GUTTER;
  return textureGrad(sampler2DArray(tiles, filtering), vec3(at, float(tile)), dx * INNER, dy * INNER);
}
