// An image-pattern layer: a tileable screen, moved by a 2D similarity. '@' is the layer's number.

//Section Ink
uniform sampler2D hachureTile@; // r: screen, g: its change per texel of level 0
uniform float hachureFade@;     // 1: the octaves cross-fade as inks, 0: they blend as screens

// Ink of the pattern where it lies so; field: where octaves blend as screens, the screen and its
// change across the pixel.
float hachureInkAt@(HachurePlacement at, vec2 position, float tone, out vec2 field)
{
  vec2 uv = vec2(dot(at.right.xyz, vec3(position, 1.0)), dot(at.up.xyz, vec3(position, 1.0)));
  float footprint = at.right.w;
  float blend = at.up.w;
  vec2 texels[2] = vec2[2](vec2(0.0), vec2(0.0));
  float inks[2] = float[2](0.0, 0.0);
  // Software OpenGL executes both sides of every branch, but a loop no more often than it must.
  int last = blend > 0.0 ? 1 : 0;
  for (int octave = blend < 1.0 ? 0 : 1; octave <= last; ++octave)
  {
    float size = float(octave + 1);
    texels[octave] = textureLod(hachureTile@, size * uv, tileLevel(size * footprint)).rg;
    field = patternField(
      texels[0], texels[1], hachureFade@ > 0.0 ? float(octave) : blend, footprint);
    float row = at.octaves[2 + octave] / hachureTableRows;
    inks[octave] = patternInk(
      tone, hachureThreshold(tableColumn(tone), row), field, at.octaves[octave]);
  }
  return hachureFade@ > 0.0 ? mix(inks[0], inks[1], blend) : inks[last];
}

//Section One
uniform vec4 hachureRight@; // where the pattern lies, see HachurePlacement
uniform vec4 hachureUp@;
uniform vec4 hachureOctaves@;

float hachureCoverage@(vec2 position, float tone)
{
  vec2 field = vec2(0.0);
  return hachureInkAt@(
    HachurePlacement(hachureRight@, hachureUp@, hachureOctaves@), position, tone, field);
}

//Section Patches
// Each patch has the tone, and so has the mixture of their inks.
float hachureCoverage@(vec2 position, float tone)
{
  float ink = 0.0;
  vec2 field = vec2(0.0);
  for (int k = 0; k < 4; ++k)
  {
    if (hachurePatchShares[k] <= 0.0)
    {
      break;
    }
    HachurePlacement at = hachurePlacementOf(@, hachurePatchNumbers[k]);
    ink += hachurePatchShares[k] * hachureInkAt@(at, position, tone, field);
  }
  return ink;
}

//Section MixedPatches
// Where octaves blend as screens, those of the patches do as well: each is made uniform by the
// response of its own row of the tables, and their mixture by its distribution. That holds for
// independent screens; screens that lie alike, as at the start, are mixed as inks.
float hachureCoverage@(vec2 position, float tone)
{
  float faded = 0.0;
  float mixed = 0.0;
  float spread = 0.0;
  float flatness = 0.0;
  float turned = 0.0;
  vec4 axes = vec4(0.0);
  int count = 0;
  for (int k = 0; k < 4; ++k)
  {
    float share = hachurePatchShares[k];
    if (share <= 0.0)
    {
      break;
    }
    HachurePlacement at = hachurePlacementOf(@, hachurePatchNumbers[k]);
    vec2 field = vec2(0.0);
    faded += share * hachureInkAt@(at, position, tone, field);
    float row = at.octaves.z / hachureTableRows;
    float width = hachureResponse(field.x + 0.5 * field.y, row) -
      hachureResponse(field.x - 0.5 * field.y, row);
    mixed += share * hachureResponse(field.x, row);
    spread += share * share * width * width;
    flatness += share * at.octaves.x;
    vec4 own = vec4(at.right.xy, at.up.xy) * (at.up.w > 0.5 ? 2.0 : 1.0);
    axes = k == 0 ? own : axes;
    turned = max(turned, length(own - axes) / length(axes));
    ++count;
  }
  // The directions in which the screens change are independent.
  spread = 0.5 * sqrt(spread);
  float ink = faded;
  for (; count > 1; count = 0)
  {
    float value = mixedShare(mixed, hachurePatchShares);
    float width = max(mixedShare(mixed + spread, hachurePatchShares) -
        mixedShare(mixed - spread, hachurePatchShares),
      1.0e-4);
    float independent = mix(inkCoverage(value, exactThreshold(tone, width), width), tone, flatness);
    ink = mix(faded, independent, smoothstep(0.1, 0.3, turned));
  }
  return tone <= 0.0 ? 0.0 : tone >= 1.0 ? 1.0 : ink;
}
