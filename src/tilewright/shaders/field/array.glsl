// A layer for each tile and variant, with gutters: one fetch at the place in the tile, gradients of the whole coordinate.

layout(set = 0, binding = 3) uniform texture2DArray tiles;

vec4 sampleField(vec2 p, vec2 dx, vec2 dy) {
  vec2 cell = floor(p);
  uvec4 c = cornerColors(view.origin.xy + ivec2(cell), COLORS);
  uint tile = ((c.x * COLORS + c.y) * COLORS + c.z) * COLORS + c.w;
#ifdef VARIANTS
  tile = tile * VARIANTS + variantAt(view.origin.zw + ivec2(cell));
#endif
  vec2 at = (p - cell) * INNER + GUTTER;
  return textureGrad(sampler2DArray(tiles, filtering), vec3(at, float(tile)), dx * INNER, dy * INNER);
}
