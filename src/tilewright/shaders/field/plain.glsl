// One picture, repeated: what everything else is compared with.

layout(set = 0, binding = 3) uniform texture2D tiles;

vec4 sampleField(vec2 p, vec2 dx, vec2 dy) {
  return textureGrad(sampler2D(tiles, filtering), p / SIDES, dx / SIDES, dy / SIDES);
}
