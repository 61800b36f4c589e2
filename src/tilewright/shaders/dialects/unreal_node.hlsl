// Endless plane of corner tiles over {{colors}} colors, seed {{seed}}; made by tilewright {{version}}.
// Code of a Custom node. Inputs Position (in tiles, x east, y south) and Origin (a cell), float2 each;
// output float2: the place in the atlas; additional outputs DX and DY, float2: its gradients.
struct TwFunctions {

{{functions}}
};

TwFunctions tw;
float2 twCell = floor(Position);
// {{#grid}}
int2 twHere = (int2)twCell + (int2)round(Origin);
uint twPicture = tw.TwTile(tw.TwCorners(twHere));
// {{#classed}}
twPicture += tw.TwClass(twHere) * {{tiles}}u;
// {{/classed}}
// {{#several}}
twPicture = twPicture * {{variants}}u + tw.TwVariant(twHere);
// {{/several}}
float2 twSquare = float2(twPicture % {{columns}}u, twPicture / {{columns}}u) * {{square}};
DX = ddx(Position) * {{scale}};
DY = ddy(Position) * {{scale}};
return twSquare + (Position - twCell) * {{scale}} + {{gutter}};
// {{/grid}}
// {{#atlas}}
// {{^several}}
uint2 twPlace = tw.TwPlaceOf(tw.TwCorners((int2)twCell + (int2)round(Origin)));
// {{/several}}
// {{#several}}
int2 twHere = (int2)twCell + (int2)round(Origin);
uint2 twPlace = tw.TwPlaceOf(tw.TwCorners(twHere)) + uint2(tw.TwVariant(twHere) * {{side}}u, 0u);
// {{/several}}
DX = ddx(Position) * {{scale}};
DY = ddy(Position) * {{scale}};
return ((float2)twPlace + (Position - twCell)) * {{scale}};
// {{/atlas}}
