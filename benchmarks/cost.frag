// What is counted: one sample at a position that the rasterizer interpolates, in tiles.

layout(location = 0) in vec2 p;
layout(location = 0) out vec4 color;

void main() {
  color = sampleField(p, dFdx(p), dFdy(p));
#ifdef SPAN
  color.rgb = withTone(color.rgb, p, dFdx(p), dFdy(p));
#endif
}
