#version 300 es
// One mip level of every tile of a layer from the level before: the area-weighted mean, tile by tile, so
// that no tile takes anything from its neighbors in the layer.
precision highp float;
precision highp int;
precision highp sampler2DArray;

uniform sampler2DArray uTiles;
uniform int uLayer, uAcross;
uniform ivec2 uSize;  // texels of a tile in the level read, the base level

out vec4 color;

void main() {
  ivec2 n = uSize, m = max(uSize >> 1, 1);
  ivec2 at = ivec2(gl_FragCoord.xy), tile = at / m, inside = at - tile * m;
  if (any(greaterThanEqual(tile, ivec2(uAcross)))) discard;
  vec2 ratio = vec2(n) / vec2(m);
  vec2 low = vec2(inside) * ratio, high = low + ratio;
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int y = int(low.y + 1e-4); float(y) < high.y - 1e-4; y++)
    for (int x = int(low.x + 1e-4); float(x) < high.x - 1e-4; x++) {
      vec2 part = min(vec2(x, y) + 1.0, high) - max(vec2(x, y), low);
      vec4 t = texelFetch(uTiles, ivec3(tile * n + ivec2(x, y), uLayer), 0);
      float weight = part.x * part.y;
      sum += weight * vec4(t.rgb * t.a, t.a);
      total += weight;
    }
  color = vec4(sum.rgb / max(sum.a, 1e-6), sum.a / total);
}
