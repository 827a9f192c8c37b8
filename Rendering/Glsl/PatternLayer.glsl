// One layer of the stack. '@' is its number, TONE its tone channel or constant, BLEND its mixing
// function, INKCOLOR its linear colour at the position; hachureCoverage@ comes from the layer's own
// text.

uniform vec4 hachureInk@;   // linear colour, opacity
uniform vec3 hachureCurve@; // gamma, 1 = inverted, constant tone

vec3 hachureLayer@(vec3 color, vec2 position, vec3 tones)
{
  float tone = hachureToneCurve(TONE, hachureCurve@.xy);
  float coverage = hachureCoverage@(position, tone);
  return BLEND(color, INKCOLOR, hachureInk@.a * coverage);
}
