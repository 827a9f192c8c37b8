// An image-pattern layer that lies on the surface: by texture coordinates, by projection along the
// model's axes, or as a solid texture whose octave follows the distance. '@' is the layer's number.

uniform sampler2D hachureTile@; // screen and gradient, see tileTexel
uniform vec4 hachureTurn@;      // tile coordinates of a model position: along x (xy), along y (zw)
uniform vec4 hachureGrowth@;    // times (point, 1): 1 / scale in the picture
uniform vec4 hachureShape@;     // texels of the tile in x and y, texels per period, tiles per texture coordinate over tiles per model unit (0: no texture coordinates)
uniform vec4 hachureOctave@;    // LOD start and end, first row of the tone tables, their texels per fragment at scale 1
uniform vec3 hachureKind@;      // 1: octaves follow the distance; tables of single octaves (0: tables of blended screens); contrast of the octaves
const float hachureBlendedBlocks@ = 3.0; // obliquity 1, 2 and 4

float hachureTableAt@(float tone, float rows)
{
  float row = hachureOctave@.z + rows;
  return hachureThreshold(tableColumn(tone), row / hachureTableRows);
}

// Of one octave. texels: of level 0 of its tile per fragment across the strokes. Every table
// reaches over tableOctaves of them.
float hachureSingleThreshold@(float tone, float texels)
{
  float octaves = clamp(1.0 + log2(max(texels, 1.0e-6) / hachureOctave@.w), 0.0,
    tableOctaves * hachureKind@.y - 1.0e-4);
  float block = floor(octaves / tableOctaves);
  float along = octaveRow(exp2(1.0 + tableOctaves * block - octaves));
  return hachureTableAt@(tone, (block + along) * octaveSteps);
}

// Of blended screens. across: texels of level 0 per fragment across the strokes.
float hachureBlendedThreshold@(float tone, float scale, float across)
{
  float spread = log2(hachureOctave@.w / max(across, 1.0e-6));
  float oblique = clamp(log2(scale) - spread, 0.0, hachureBlendedBlocks@ - 1.0);
  float block = min(floor(oblique), hachureBlendedBlocks@ - 2.0);
  float along = tableRow(scale, hachureOctave@.x, hachureOctave@.y, hachureKind@.z);
  return mix(hachureTableAt@(tone, (block + along) * tableSteps),
    hachureTableAt@(tone, (block + along + 1.0) * tableSteps), oblique - block);
}

// Ink of one projection: its position, the change of it per fragment, the scale in the picture.
float hachureProjection@(vec2 at, vec2 alongX, vec2 alongY, float grown, float tone)
{
  float scale = hachureKind@.x > 0.0 ? wrapScale(grown) : 1.0;
  float octaves = hachureKind@.x > 0.0 ? exp2(floor(log2(grown / scale) + 0.5)) : 1.0;
  float blend = hachureKind@.x > 0.0
    ? lodBlend(scale, hachureOctave@.x, hachureOctave@.y, hachureKind@.z)
    : 0.0;
  mat2 turn = octaves * mat2(hachureTurn@.xz, hachureTurn@.yw);
  vec2 uv = turn * at;
  vec2 dx = turn * alongX * hachureShape@.xy;
  vec2 dy = turn * alongY * hachureShape@.xy;
  vec2 axes = footprintAxes(dx, dy);
  vec2 texels[2] = vec2[2](vec2(0.0), vec2(0.0));
  float inks[2] = float[2](0.0, 0.0);
  vec2 across = vec2(axes.x);
  float period = hachureShape@.z / axes.y;
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
    texels[octave] = tileTexel(textureLod(hachureTile@, center, level).rg);
    across[octave] = footprintAcross(dx, dy, rise, axes.x);
    texels[octave].y *= across[octave] / axes.x;
    if (hachureKind@.y > 0.0)
    {
      vec2 field = patternField(texels[0], texels[1], float(octave), axes.x);
      inks[octave] = patternInk(tone, hachureSingleThreshold@(tone, size * across[octave]), field,
        flatShare(1.0, float(octave), period));
    }
  }
  if (hachureKind@.y > 0.0)
  {
    return mix(inks[0], inks[1], blend);
  }
  vec2 field = patternField(texels[0], texels[1], blend, axes.x);
  float threshold = hachureBlendedThreshold@(tone, scale, mix(across.x, across.y, blend));
  return patternInk(tone, threshold, field, flatShare(1.0, blend, period));
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
