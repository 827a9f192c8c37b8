// An image-pattern layer that lies on the surface: by texture coordinates, by projection along the
// model's axes, or as a solid texture whose octave follows the distance. '@' is the layer's number.

uniform sampler2D hachureTile@; // r: screen, g: its change per texel of level 0
uniform vec4 hachureTurn@;      // tile coordinates of a model position: along x (xy), along y (zw)
uniform vec4 hachureGrowth@;    // times (point, 1): 1 / scale in the picture
uniform vec4 hachureShape@;     // texels of the tile in x and y, texels per period, tiles per texture coordinate over tiles per model unit (0: no texture coordinates)
uniform vec4 hachureOctave@;    // LOD start and end, first row of the tone tables, their texels per fragment at scale 1
uniform float hachureSolid@;    // 1: octaves follow the distance
const float hachureTextureBlocks@ = 5.0; // octaves of the tables, from 2 fragments per period
const float hachureSolidBlocks@ = 3.0;   // obliquity 1, 2 and 4

float hachureTableAt@(float tone, float block, float scale)
{
  float row = hachureOctave@.z +
    (block + tableRow(scale, hachureOctave@.x, hachureOctave@.y)) * tableSteps;
  return hachureThreshold(tableColumn(tone), row / hachureTableRows);
}

// across: texels of level 0 per fragment across the strokes.
float hachureThresholdAt@(float tone, float scale, float across)
{
  float spread = log2(hachureOctave@.w / across);
  if (hachureSolid@ > 0.0)
  {
    float oblique = clamp(log2(scale) - spread, 0.0, hachureSolidBlocks@ - 1.0);
    float block = min(floor(oblique), hachureSolidBlocks@ - 2.0);
    return mix(hachureTableAt@(tone, block, scale), hachureTableAt@(tone, block + 1.0, scale),
      oblique - block);
  }
  float level = clamp(spread, 0.0, hachureTextureBlocks@ - 1.0e-4);
  return hachureTableAt@(tone, floor(level), exp2(level - floor(level)));
}

// Ink of one projection: its position, the change of it per fragment, the scale in the picture.
float hachureProjection@(vec2 at, vec2 alongX, vec2 alongY, float grown, float tone)
{
  float scale = hachureSolid@ > 0.0 ? wrapScale(grown) : 1.0;
  float octaves = hachureSolid@ > 0.0 ? exp2(floor(log2(grown / scale) + 0.5)) : 1.0;
  float blend = hachureSolid@ > 0.0 ? lodBlend(scale, hachureOctave@.x, hachureOctave@.y) : 0.0;
  mat2 turn = octaves * mat2(hachureTurn@.xz, hachureTurn@.yw);
  vec2 uv = turn * at;
  vec2 dx = turn * alongX * hachureShape@.xy;
  vec2 dy = turn * alongY * hachureShape@.xy;
  vec2 axes = footprintAxes(dx, dy);
  vec2 texels[2] = vec2[2](vec2(0.0), vec2(0.0));
  vec2 across = vec2(axes.x);
  int last = blend > 0.0 ? 1 : 0;
  for (int octave = blend < 1.0 ? 0 : 1; octave <= last; ++octave)
  {
    float size = float(octave + 1);
    float level = tileLevel(size * axes.x);
    vec2 center = size * uv;
    vec2 step = exp2(floor(level)) / hachureShape@.xy;
    vec2 rise = vec2(textureLod(hachureTile@, center + vec2(step.x, 0.0), level).r -
        textureLod(hachureTile@, center - vec2(step.x, 0.0), level).r,
      textureLod(hachureTile@, center + vec2(0.0, step.y), level).r -
        textureLod(hachureTile@, center - vec2(0.0, step.y), level).r);
    texels[octave] = textureLod(hachureTile@, center, level).rg;
    across[octave] = footprintAcross(dx, dy, rise, axes.x);
    texels[octave].y *= across[octave] / axes.x;
  }
  vec2 field = patternField(texels[0], texels[1], blend, axes.x);
  float threshold = hachureThresholdAt@(tone, scale, mix(across.x, across.y, blend));
  return patternInk(
    tone, threshold, field, flatShare(1.0, blend, hachureShape@.z / axes.y));
}

float hachureCoverage@(vec2 position, float tone)
{
  float grown = 1.0 / max(dot(hachureGrowth@, vec4(hachurePoint, 1.0)), 1.0e-20);
  if (hachureShape@.w > 0.0 && hachureTexture.z > 0.5)
  {
    return hachureProjection@(hachureShape@.w * hachureTexture.xy,
      hachureShape@.w * hachureTextureSlopes.xy, hachureShape@.w * hachureTextureSlopes.zw, grown,
      tone);
  }
  // Mixed ink keeps its mean, which mixed fields would not.
  vec3 weights = triplanarWeights(hachureFacet);
  float ink = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    int first = axis == 2 ? 0 : axis + 1;
    int second = axis == 0 ? 2 : axis - 1;
    if (weights[axis] > 0.0)
    {
      ink += weights[axis] *
        hachureProjection@(vec2(hachurePoint[first], hachurePoint[second]),
          vec2(hachurePointDx[first], hachurePointDx[second]),
          vec2(hachurePointDy[first], hachurePointDy[second]), grown, tone);
    }
  }
  return ink;
}
