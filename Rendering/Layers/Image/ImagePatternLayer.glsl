// An image-pattern layer: a tileable screen, moved by a 2D similarity. '@' is the layer's number.

uniform sampler2D hachureTile@; // r: screen, g: its change per texel of level 0
// Where the pattern lies, as in PatternPlacement.h; tile coordinates of a position in logical pixels.
uniform vec4 hachureRight@;     // tile coordinate along x (xyz); texels of level 0 per framebuffer pixel
uniform vec4 hachureUp@;        // tile coordinate along y (xyz); weight of the half-size copy
uniform vec4 hachureOctaves@;   // flat share of both octaves, rows of the tone tables of both
uniform float hachureFade@;     // 1: the octaves cross-fade as inks, 0: they blend as screens

float hachureCoverage@(vec2 position, float tone)
{
  vec2 uv = vec2(dot(hachureRight@.xyz, vec3(position, 1.0)), dot(hachureUp@.xyz, vec3(position, 1.0)));
  float footprint = hachureRight@.w;
  float blend = hachureUp@.w;
  vec2 texels[2] = vec2[2](vec2(0.0), vec2(0.0));
  float inks[2] = float[2](0.0, 0.0);
  // Software OpenGL executes both sides of every branch, but a loop no more often than it must.
  int last = blend > 0.0 ? 1 : 0;
  for (int octave = blend < 1.0 ? 0 : 1; octave <= last; ++octave)
  {
    float size = float(octave + 1);
    texels[octave] = textureLod(hachureTile@, size * uv, tileLevel(size * footprint)).rg;
    vec2 field = patternField(
      texels[0], texels[1], hachureFade@ > 0.0 ? float(octave) : blend, footprint);
    float row = hachureOctaves@[2 + octave] / hachureTableRows;
    inks[octave] = patternInk(
      tone, hachureThreshold(tableColumn(tone), row), field, hachureOctaves@[octave]);
  }
  return hachureFade@ > 0.0 ? mix(inks[0], inks[1], blend) : inks[last];
}
