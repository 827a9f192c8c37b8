// One layer of the stack. '@' is its number, CURVE its tone, BLEND
// its mixing function, INKCOLOR its linear colour at the position; hachureCoverage@ comes from the
// layer's own text.

uniform vec4 hachureInk@;   // linear colour, opacity
uniform vec4 hachureCurve@; // gamma, 1 = inverted, constant tone, black generation
uniform vec3 hachureRemap@; // see toneCurve

vec3 hachureLayer@(vec3 color, vec2 position, vec4 tones)
{
  float tone = CURVE;
  float coverage = hachureCoverage@(position, tone);
  return BLEND(color, INKCOLOR, hachureInk@.a * coverage);
}
