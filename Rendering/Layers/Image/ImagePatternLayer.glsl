// An image-pattern layer: a tileable screen, moved by a 2D similarity. '@' is the layer's number.

uniform sampler2D hachureTile@; // r: screen, g: its change per texel of level 0
uniform mat3 hachureUv@;        // tile coordinates of a position in logical pixels
uniform vec4 hachureOctave@;    // texels of level 0 per framebuffer pixel, weight of the half-size copy, flat share, row of the tone tables

float hachureCoverage@(vec2 position, float tone)
{
  vec2 uv = (hachureUv@ * vec3(position, 1.0)).xy;
  vec2 first = vec2(0.0);
  vec2 second = vec2(0.0);
  if (hachureOctave@.y < 1.0)
  {
    first = textureLod(hachureTile@, uv, tileLevel(hachureOctave@.x)).rg;
  }
  if (hachureOctave@.y > 0.0)
  {
    second = textureLod(hachureTile@, 2.0 * uv, tileLevel(2.0 * hachureOctave@.x)).rg;
  }
  vec2 field = patternField(first, second, hachureOctave@.y, hachureOctave@.x);
  return patternInk(
    tone, hachureThreshold(tableColumn(tone), hachureOctave@.w / hachureTableRows), field, hachureOctave@.z);
}
