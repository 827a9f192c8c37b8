// Sums of kernels at a pixel (Benard et al. 2010, section 3), for every shader that makes them: of
// back ends, and of translucent surfaces, where '@' is the layer's number; elsewhere it is nothing.
// Pixels are those of the framebuffer.

//Section Kernels
uniform samplerBuffer hachureNoiseKernels@; // four texels each: those of a PackedKernel; object, triangle
uniform vec4 hachureNoiseRectangle@; // that has the noise: x, y, width, height
uniform vec4 hachureNoiseTests@;     // 1 = by depth, partial visibility, by object, by triangle
uniform vec4 hachureNoiseShape@;     // tolerance of depth, number of kernels

PackedKernel hachureNoiseKernel@(int index)
{
  return PackedKernel(texelFetch(hachureNoiseKernels@, 4 * index),
    texelFetch(hachureNoiseKernels@, 4 * index + 1),
    texelFetch(hachureNoiseKernels@, 4 * index + 2));
}

//Section Shares
uniform sampler2D hachureNoiseShares; // per kernel: share that is seen, 1 = all of it

vec2 hachureNoiseShare@(int index)
{
  int row = index / NOISEROW;
  return texelFetch(hachureNoiseShares, ivec2(index - row * NOISEROW, row), 0).rg;
}

//Section NoShares
vec2 hachureNoiseShare@(int index)
{
  return vec2(1.0, 0.0);
}

//Section Gabor
vec2 hachureNoiseTerm@(PackedKernel kernel, vec2 offset, float share)
{
  return gaborTerm(kernel, offset, share);
}

//Section Phasor
vec2 hachureNoiseTerm@(PackedKernel kernel, vec2 offset, float share)
{
  return phasorTerm(kernel, offset, share);
}

//Section Numbers
uniform samplerBuffer hachureNoiseNumbers@; // shares of the distribution, then texels of the spot

float hachureNoiseNumber@(int index)
{
  return texelFetch(hachureNoiseNumbers@, index).r;
}

//Section Spot
uniform vec4 hachureNoiseSpot@; // width, height, first of its numbers

vec2 hachureNoiseTerm@(PackedKernel kernel, vec2 offset, float share)
{
  vec2 texel = spotTexel(kernel, offset, hachureNoiseSpot@.xy);
  vec2 whole = floor(texel);
  int stride = int(hachureNoiseSpot@.x) + 2;
  int first = int(hachureNoiseSpot@.z) + int(whole.y) * stride + int(whole.x);
  vec2 part = texel - whole;
  float below = mix(hachureNoiseNumber@(first), hachureNoiseNumber@(first + 1), part.x);
  float above =
    mix(hachureNoiseNumber@(first + stride), hachureNoiseNumber@(first + stride + 1), part.x);
  return spotTerm(kernel, mix(below, above, part.y), share);
}

//Section Adding
// What one kernel adds at a pixel. depth, ids: seen there, object and triangle; own: those of the
// kernel, then its share. Where nothing is seen the noise goes on, so that differences across a
// silhouette are those of the noise.
vec2 hachureNoiseAdd@(PackedKernel kernel, vec4 own, vec2 pixel, float depth, vec2 ids)
{
  vec2 offset = pixel - kernel.place.xy;
  if (!(own.z > 0.0) || !insideKernel(kernel.place, offset))
  {
    return vec2(0.0);
  }
  float share = hachureNoiseTests@.y > 0.5 ? own.z : 1.0;
  if (depth < 1.0)
  {
    if (hachureNoiseTests@.x > 0.5 && own.w < 0.5)
    {
      share *= noisePlaneWeight(offset, depth, kernel.plane, hachureNoiseShape@.x);
    }
    vec2 differs = hachureNoiseTests@.zw * abs(own.xy - ids);
    share = differs.x + differs.y > 0.0 ? 0.0 : share;
  }
  return hachureNoiseTerm@(kernel, offset, share);
}

vec4 hachureNoiseOwn@(int index)
{
  vec2 ids = hachureNoiseTests@.z + hachureNoiseTests@.w > 0.5
    ? texelFetch(hachureNoiseKernels@, 4 * index + 3).xy
    : vec2(0.0);
  return vec4(ids, hachureNoiseShare@(index));
}

//Section Lists
uniform samplerBuffer hachureNoiseLists@; // where the list of each tile begins and ends here, then kernels
uniform vec4 hachureNoiseTiles@;          // size in pixels, columns, rows

// First and behind the last place of the kernels of a tile; empty outside the rectangle.
ivec2 hachureNoiseRange@(ivec2 tile)
{
  ivec2 tiles = ivec2(hachureNoiseTiles@.yz);
  if (any(lessThan(tile, ivec2(0))) || any(greaterThanEqual(tile, tiles)))
  {
    return ivec2(0);
  }
  int place = tile.y * tiles.x + tile.x;
  return ivec2(
    texelFetch(hachureNoiseLists@, place).r, texelFetch(hachureNoiseLists@, place + 1).r);
}

int hachureNoiseListed@(int place)
{
  return int(texelFetch(hachureNoiseLists@, place).r);
}

//Section Sum
vec2 hachureNoiseSum@(vec2 pixel, float depth, vec2 ids)
{
  vec2 place = floor((pixel - hachureNoiseRectangle@.xy) / hachureNoiseTiles@.x);
  ivec2 range = hachureNoiseRange@(ivec2(place));
  vec2 sum = vec2(0.0);
  for (int i = range.x; i < range.y; ++i)
  {
    int index = hachureNoiseListed@(i);
    vec4 reach = texelFetch(hachureNoiseKernels@, 4 * index);
    if (insideKernel(reach, pixel - reach.xy))
    {
      sum += hachureNoiseAdd@(
        hachureNoiseKernel@(index), hachureNoiseOwn@(index), pixel, depth, ids);
    }
  }
  return sum;
}

//Section Seen
uniform sampler2D hachureNoiseDepth; // window depth at the pixels of the framebuffer
uniform sampler2D hachureNoiseIds;   // object and triangle at those of the rectangle

// here: pixel of the rectangle.
float hachureNoiseDepthAt(ivec2 here)
{
  ivec2 inside = clamp(here, ivec2(0), ivec2(hachureNoiseRectangle@.zw) - 1);
  return texelFetch(hachureNoiseDepth, inside + ivec2(hachureNoiseRectangle@.xy), 0).r;
}

vec2 hachureNoiseIdsAt(ivec2 here)
{
  return hachureNoiseTests@.z + hachureNoiseTests@.w > 0.5
    ? texelFetch(hachureNoiseIds, here, 0).rg
    : vec2(0.0);
}

// Whether something is seen at a pixel or beside it, where differences are taken from.
bool hachureNoiseMatters(ivec2 here)
{
  float least = min(hachureNoiseDepthAt(here + ivec2(1, 0)), hachureNoiseDepthAt(here - ivec2(1, 0)));
  least = min(least, hachureNoiseDepthAt(here + ivec2(0, 1)));
  least = min(least, hachureNoiseDepthAt(here - ivec2(0, 1)));
  return min(least, hachureNoiseDepthAt(here)) < 1.0;
}

//Section Table
uniform vec4 hachureNoiseTable@; // range of the distribution, its steps, variance that is hardly any, least width

float hachureNoiseValue@(vec2 sum)
{
  float value = normalisedNoise(sum.x, sum.y, hachureNoiseTable@.z);
  float position = noiseTablePosition(value, hachureNoiseTable@.x, hachureNoiseTable@.y);
  int whole = int(position);
  return mix(
    hachureNoiseNumber@(whole), hachureNoiseNumber@(whole + 1), position - float(whole));
}

// The field, uniform in [0,1], and its width, from the sums of a pixel and of those beside it.
vec2 hachureNoiseField@(vec2 sum, vec2 left, vec2 right, vec2 below, vec2 above)
{
  vec2 change = vec2(hachureNoiseValue@(right) - hachureNoiseValue@(left),
    hachureNoiseValue@(above) - hachureNoiseValue@(below));
  return vec2(hachureNoiseValue@(sum),
    noiseFieldWidth(
      0.5 * change, noiseFlatWidth(sum.y, hachureNoiseTable@.z), hachureNoiseTable@.w));
}

//Section Phase
uniform vec4 hachureNoiseTable@; // w: least width

vec2 hachureNoiseField@(vec2 sum, vec2 left, vec2 right, vec2 below, vec2 above)
{
  vec2 change =
    vec2(phasorChange(sum, 0.5 * (right - left)), phasorChange(sum, 0.5 * (above - below)));
  return vec2(phasorValue(sum),
    noiseFieldWidth(change, noiseFlatWidth(dot(sum, sum), phasorFloor), hachureNoiseTable@.w));
}
