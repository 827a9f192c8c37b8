// An image-pattern layer: a tileable screen, moved by a 2D similarity. '@' is the layer's number,
// LEVEL the mip level of its tile, ASPECT the tile's width over its height, PERIOD the texels of level 0
// in a period, POWER that of the patches' weights. These change seldom, and are constants, as software
// OpenGL is slow with what might differ from pixel to pixel.

//Section Ink
uniform sampler2D hachureTile@; // screen and gradient, see tileTexel
uniform vec2 hachureFade@;      // x: 1 where octaves cross-fade as inks, 0 where they blend as screens

// Change of the tile coordinates along x (x) and y (y) of the picture; those of u are at.axis.xy.
vec2 hachureUp@(HachurePlacement at)
{
  return ASPECT * vec2(-at.axis.y, at.axis.x);
}

// Share of flat tone with `copied` of the half-size copy.
float hachureFlatness@(HachurePlacement at, float copied)
{
  return flatShare(1.0, copied, PERIOD / at.octaves.x);
}

//Hachure::Paper::Dec
//Hachure::Paint::Dec

// Ink of the pattern where it lies so; field: where octaves blend as screens, the screen and its
// change across the pixel; share: weight of this ink in what is drawn.
//
// Software OpenGL executes both sides of every branch, and all of a loop before it finds at its end
// that no fragment is left in it: hence loops that are left at their end. It takes arrays and vectors
// apart wherever they have an index.
float hachureInkAt@(HachurePlacement at, vec2 position, float tone, float share, out vec2 field)
{
  vec2 uv = at.axis.zw + vec2(dot(at.axis.xy, position), dot(hachureUp@(at), position));
  float footprint = at.octaves.x;
  float blend = at.octaves.y;
  float column = tableColumn(tone);
  bool fades = hachureFade@.x > 0.0;
  vec2 first = vec2(0.0);
  float firstInk = 0.0;
  float ink = 0.0;
  float octave = step(1.0, blend) - 1.0;
  do
  {
    octave += 1.0;
    float size = 1.0 + octave;
    vec2 texel = tileTexel(textureLod(hachureTile@, size * uv, LEVEL).rg);
    first = octave > 0.0 ? first : texel;
    float copied = fades ? octave : blend;
    field = patternField(first, texel, copied, footprint);
    float flatness = hachureFlatness@(at, copied);
    float row = mix(at.octaves.z, at.octaves.w, octave);
    firstInk = ink;
    ink = patternInk(tone, hachureThreshold(column, row), field, flatness);
    //Hachure::Paper::Impl
    //Hachure::Paint::Impl
  } while (octave < blend);
  return fades ? mix(firstInk, ink, blend > 0.0 ? blend : 1.0) : ink;
}

//Section PaperDec
uniform sampler2D hachurePaper@; // height of the paper and its gradient, see tileTexel
uniform vec3 hachureGrain@;      // contrast, tiles of paper per tile, texels of paper per texel

// Ink of a screen on rough paper: both decide together where ink goes first.
float hachureInkOnPaper@(vec2 uv, vec2 field, float row, float tone, float footprint)
{
  float texels = footprint * hachureGrain@.z;
  vec2 paper =
    tileTexel(textureLod(hachurePaper@, hachureGrain@.y * uv, tileLevel(texels)).rg);
  // A dry pencil catches on the heights first.
  vec2 mixed = mixScreens(hachureUniformScreen(field, row),
    vec2(1.0 - paper.x, paper.y * edgeSharpness * texels), hachureGrain@.x);
  float width = clamp(mixed.y, 1.0e-4, 1.0);
  return inkCoverage(mixed.x, exactThreshold(tone, width), width);
}
//Section PaperImpl
    ink = tone <= 0.0 || tone >= 1.0
      ? ink
      : mix(hachureInkOnPaper@(size * uv, field, row, tone, size * footprint), tone, flatness);
//Section PaintDec
uniform sampler2D hachureDabs@;      // of the dab on top: offset to its middle (rg), opacity, height
uniform sampler2D hachureDabsBelow@; // of the one below it: offset, opacity, its own brightness
uniform vec3 hachurePaint@;          // relief, variation of brightness, 1: colours of the surface
uniform vec3 hachurePaintColor@;     // linear colour otherwise

vec3 hachurePainted@ = vec3(0.0); // colour of the paint times its coverage

vec3 hachureDabColor@(vec2 position, vec2 offset, mat2 toPosition, float brightness)
{
  vec3 color =
    hachurePaint@.z > 0.0 ? hachureColorAt(position + toPosition * offset) : hachurePaintColor@;
  return color * (1.0 + hachurePaint@.y * (brightness - 0.5));
}

// Colour of the paint at tile coordinates uv of a copy `size` times smaller.
vec3 hachurePaintAt@(HachurePlacement at, vec2 position, vec2 uv, float size)
{
  int level = int(max(0.0, floor(log2(max(size * at.octaves.x, 1.0)) + 0.5)));
  ivec2 extent = textureSize(hachureDabs@, level);
  vec2 where = fract(uv) * vec2(extent);
  ivec2 texel = min(ivec2(where), extent - 1);
  vec4 top = texelFetch(hachureDabs@, texel, level);
  vec4 below = texelFetch(hachureDabsBelow@, texel, level);
  vec2 toMiddle = (vec2(texel) + 0.5 - where) / vec2(extent);
  vec2 up = hachureUp@(at);
  mat2 toPosition = inverse(size * mat2(at.axis.x, up.x, at.axis.y, up.y));
  vec3 ground = hachurePaint@.z > 0.0 ? hachureSurfaceHere : hachurePaintColor@;
  vec3 color = mix(ground,
    hachureDabColor@(position, toMiddle + below.xy, toPosition, fract(7.31 * below.w)), below.z);
  color = mix(color, hachureDabColor@(position, toMiddle + top.xy, toPosition, below.w), top.z);
  for (float relief = hachurePaint@.x; relief > 0.0; relief = 0.0)
  {
    // Light from the upper left of the picture, over one pixel and a half.
    vec2 aside = vec2(-0.9, 1.2) * hachurePixelMap.xy;
    vec2 other = fract(uv + size * vec2(dot(at.axis.xy, aside), dot(up, aside)));
    ivec2 neighbour = min(ivec2(other * vec2(extent)), extent - 1);
    float rise = top.w - texelFetch(hachureDabs@, neighbour, level).w;
    color *= clamp(1.0 + 2.0 * relief * rise, 0.3, 2.0);
  }
  return clamp(color, vec3(0.0), vec3(1.0));
}
//Section PaintImpl
    float part = share * mix(1.0 - blend, blend, octave);
    hachurePainted@ += part * ink * hachurePaintAt@(at, position, size * uv, size);
//Section One
uniform vec4 hachureAxis@; // where the pattern lies, see HachurePlacement
uniform vec4 hachureOctaves@;

float hachureCoverage@(vec2 position, float tone)
{
  vec2 field = vec2(0.0);
  return hachureInkAt@(
    HachurePlacement(hachureAxis@, hachureOctaves@), position, tone, 1.0, field);
}

//Section Patches
// Each patch has the tone, and so has the mixture of their inks, unless POWER makes them stronger.
float hachureCoverage@(vec2 position, float tone)
{
  float ink = 0.0;
  vec2 field = vec2(0.0);
  HachurePatches rest = hachurePatches;
  do
  {
    float share = pow(rest.shares.x, POWER);
    ink += share *
      hachureInkAt@(hachurePlacementOf(@, rest.numbers.x), position, tone, share, field);
    rest = hachureNextPatches(rest);
  } while (rest.shares.x > 0.0);
  return min(ink, 1.0);
}

//Section MixedPatches
// Where octaves blend as screens, those of the patches do as well, one after the other: each is
// made uniform by the response of its own row of the tables, and their mixture by its distribution.
// That holds for independent screens; screens that lie alike, as at the start, are mixed as inks.
float hachureCoverage@(vec2 position, float tone)
{
  float faded = 0.0;
  vec2 mixed = vec2(0.0);
  float sum = 0.0;
  float flatness = 0.0;
  float turned = 0.0;
  vec2 axes = vec2(0.0);
  HachurePatches rest = hachurePatches;
  do
  {
    float share = rest.shares.x;
    HachurePlacement at = hachurePlacementOf(@, rest.numbers.x);
    vec2 field = vec2(0.0);
    faded += share * hachureInkAt@(at, position, tone, share, field);
    sum += share;
    mixed = mixScreens(mixed, hachureUniformScreen(field, at.octaves.z), share / sum);
    flatness += share * hachureFlatness@(at, at.octaves.y);
    vec2 own = at.axis.xy * (at.octaves.y > 0.5 ? 2.0 : 1.0);
    axes = sum > share ? axes : own;
    turned = max(turned, length(own - axes) / length(axes));
    rest = hachureNextPatches(rest);
  } while (rest.shares.x > 0.0);
  float width = max(mixed.y, 1.0e-4);
  float independent =
    mix(inkCoverage(mixed.x, exactThreshold(tone, width), width), tone, flatness);
  float ink = mix(faded, independent, smoothstep(0.1, 0.3, turned));
  return tone <= 0.0 ? 0.0 : tone >= 1.0 ? 1.0 : ink;
}
