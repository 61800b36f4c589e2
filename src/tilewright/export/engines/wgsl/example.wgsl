// How to use tilewright.wgsl: put both texts into one shader module.
@group(0) @binding(0) var color_map: {{texture}}<f32>;
@group(0) @binding(1) var filtering: sampler;  // linear, mipmap linear, anisotropy 8, {{edge}}
// {{#color_toned}}
@group(0) @binding(2) var color_tone: texture_2d<f32>;
// {{/color_toned}}

@fragment fn fragment_main(@location(0) uv: vec2f) -> @location(0) vec4f {
  let tiles = 8.0;  // across one unit of uv; turn y over where v points up
  let at = tw_find(uv * tiles, vec2i(0, 0));
// {{^color_toned}}
  return tw_sample(color_map, filtering, at);
// {{/color_toned}}
// {{#color_toned}}
  let color = tw_sample(color_map, filtering, at);
  let tone = tw_tone(color_tone, filtering, uv * tiles, vec2i(0, 0));
  return vec4f(tw_lay(color.rgb, tone, vec3f({{mean}})), color.a);
// {{/color_toned}}
}
