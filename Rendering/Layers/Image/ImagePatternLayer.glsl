// An image-pattern layer: a tileable screen, moved by a 2D similarity. '@' is the layer's number.

uniform sampler2D hachureTile@; // r: screen, g: its change per texel of level 0
uniform mat3 hachureUv@;        // tile coordinates of a position in logical pixels
uniform vec4 hachureOctave@;    // texels of level 0 per framebuffer pixel, weight of the half-size copy, flat share, row of the tone tables

float hachureCoverage@(vec2 position, float tone)
{
  vec2 uv = (hachureUv@ * vec3(position, 1.0)).xy;
  vec2 first = vec2(0.0);
  vec2 second = vec2(0.0);
  // Software OpenGL executes both sides of every branch, but a loop no more often than it must.
  int octave = hachureOctave@.y < 1.0 ? 0 : 1;
  int last = hachureOctave@.y > 0.0 ? 1 : 0;
  for (;;)
  {
    float size = float(octave + 1);
    vec2 texel = textureLod(hachureTile@, size * uv, tileLevel(size * hachureOctave@.x)).rg;
    first = octave == 0 ? texel : first;
    second = octave == 1 ? texel : second;
    ++octave;
    if (octave > last)
    {
      break;
    }
  }
  vec2 field = patternField(first, second, hachureOctave@.y, hachureOctave@.x);
  return patternInk(
    tone, hachureThreshold(tableColumn(tone), hachureOctave@.w / hachureTableRows), field, hachureOctave@.z);
}
