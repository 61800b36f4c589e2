// Tone of an endless plane of corner tiles, seed {{seed}}; made by tilewright {{version}}.
// Code of a Custom node. Inputs Position (in tiles, x east, y south) and Origin (a cell), float2 each; Color and
// Mean, float3 each, where Mean is the map's mean in sRGB, or -1 for numbers such as roughness; and Tone, a Texture
// Object. Output float3: the color, or number, with its tone.
struct TwFunctions {

{{functions}}{{tone}}
};

TwFunctions tw;
float3 tone = tw.TwTone(Tone, ToneSampler, Position, (int2)round(Origin));
return Mean.x < 0.0 ? saturate(Color + tone) : tw.TwLay(Color, tone, Mean);
