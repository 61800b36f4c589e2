// Wei 2004: a packing of all Wang tiles, and near lattice points a second one that holds every way in which
// four edges can meet. Both are read alike: a tile has four edges around its middle, a lattice point has four
// around itself, and on the lattice of half tiles both are hashed one step north, east, south and west.

layout(set = 0, binding = 3) uniform texture2D tiles;
layout(set = 0, binding = 4) uniform texture2D corners;

vec4 sampleField(vec2 p, vec2 dx, vec2 dy) {
  vec2 cell = floor(p), point = floor(p + 0.5);
  vec2 off = abs(p - point);
  bool near = max(off.x, off.y) < NEAR;
  ivec2 middle = view.origin.xy + (near ? 2 * ivec2(point) : 2 * ivec2(cell) + 1);
  uvec2 counts = near ? COUNTS.yx : COUNTS;
  uvec2 across = rowColors(middle.x - 1, middle.x + 1, middle.y, counts.y);
  uvec2 down = columnColors(middle.x, middle.y - 1, middle.y + 1, counts.x);
  vec2 place = vec2(trainPosition(across.x, across.y), trainPosition(down.x, down.y));
  if (near) {
    // The pair of colors at positions t - 1 and t of the train meets at lattice point t.
    return textureGrad(
      sampler2D(corners, filtering), (p - point + place + 1.0) / SIDES.yx, dx / SIDES.yx, dy / SIDES.yx);
  }
  vec2 sides = SIDES;
#ifdef VARIANTS
  place.x += float(variantAt(view.origin.zw + ivec2(cell))) * SIDES.x;
  sides.x *= float(VARIANTS);
#endif
  return textureGrad(sampler2D(tiles, filtering), (p - cell + place) / sides, dx / sides, dy / sides);
}
