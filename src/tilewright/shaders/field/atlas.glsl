// All tiles packed into one picture, a torus: one fetch, filtered across tile borders within the picture.

layout(set = 0, binding = 3) uniform texture2D tiles;

vec4 sampleField(vec2 p, vec2 dx, vec2 dy) {
  vec2 cell = floor(p);
  vec2 place = vec2(torusPlace(cornerColors(view.origin.xy + ivec2(cell), COLORS)));
  vec2 sides = vec2(SIDE);
#ifdef VARIANTS
  // Packings of all variants lie side by side.
  place.x += float(variantAt(view.origin.zw + ivec2(cell))) * SIDE;
  sides.x *= float(VARIANTS);
#endif
  return textureGrad(sampler2D(tiles, filtering), (p - cell + place) / sides, dx / sides, dy / sides);
}
