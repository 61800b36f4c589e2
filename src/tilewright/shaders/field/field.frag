// A field seen by a camera. The camera is a homography from pixels to the plane, in tiles.

layout(location = 0) out vec4 color;

void main() {
  vec3 pixel = vec3(gl_FragCoord.xy, 1.0);
  float w = dot(view.w.xyz, pixel);
  if (w <= 0.0) {
    color = vec4(0.0);
    return;
  }
  vec2 p = vec2(dot(view.x.xyz, pixel), dot(view.y.xyz, pixel)) / w;
  vec2 dx = (vec2(view.x.x, view.y.x) - p * view.w.x) / w;
  vec2 dy = (vec2(view.x.y, view.y.y) - p * view.w.y) / w;
  // Towards the horizon cells run out of integers; only the mean of the set is seen there.
  p = clamp(p, -2.0e8, 2.0e8);
  color = sampleField(p, dx, dy);
#ifdef SPAN
  color.rgb = withTone(color.rgb, p, dx, dy);
#endif
}
