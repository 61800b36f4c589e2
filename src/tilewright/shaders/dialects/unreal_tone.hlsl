// Tone of an endless plane of corner tiles, seed {{seed}}; made by tilewright {{version}}.
// Code of a Custom node. Inputs Position (in tiles, x east, y south) and Origin (a cell), float2 each, Color,
// float3, and Tone, a Texture Object; output float3: the color with its tone.
struct TwFunctions {

{{functions}}{{tone}}
};

TwFunctions tw;
return tw.TwLay(Color, tw.TwTone(Tone, ToneSampler, Position, (int2)round(Origin)));
