#version 330
// How to use tilewright.glsl: put it here, or include it as your engine does.
{{include}}
uniform {{texture}} colorMap;  // linear, mipmap linear, anisotropy 8, {{edge}}
// {{#color_toned}}
uniform sampler2D colorTone;  // linear, mipmap linear, clamp to edge
// {{/color_toned}}
in vec2 uv;
out vec4 color;

void main() {
  const float tiles = 8.0;  // across one unit of uv; turn y over where v points up
  TwPlace at = twFind(uv * tiles, ivec2(0));
  color = twSample(colorMap, at);
// {{#color_toned}}
  color.rgb = twLay(color.rgb, twTone(colorTone, uv * tiles, ivec2(0)), vec3({{mean}}));
// {{/color_toned}}
}
