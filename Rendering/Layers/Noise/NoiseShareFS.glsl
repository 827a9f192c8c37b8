//VTK::System::Dec
//VTK::Output::Dec

// How much of each kernel's disc is seen, one fragment a kernel (after Cole & Finkelstein 2008): the
// share of its samples that lie on its plane, and whether all do. Samples are the pixels whose column
// and row are multiples of a step; see NoiseVisibility.h, which this repeats. Pixels outside the
// rectangle are not known and count neither way; where nothing is there nothing is seen.

in vec2 texCoord;

//Hachure::NoiseSums::Dec

const float largestStep = 512.0;

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  int index = texel.y * NOISEROW + texel.x;
  if (index >= int(hachureNoiseShape.y) || texCoord.x < 0.0)
  {
    gl_FragData[0] = vec4(0.0);
    return;
  }
  if (hachureNoiseTests.x + hachureNoiseTests.y < 0.5) // nothing hides a kernel
  {
    gl_FragData[0] = vec4(1.0);
    return;
  }
  PackedKernel kernel = hachureNoiseKernel(index);
  float object = texelFetch(hachureNoiseKernels, 4 * index + 3).x;
  float radius = kernel.plane.w;
  float spacing = min(noiseSampleStep(radius), largestStep);
  // Disturbances are known before they reach the disc.
  float reach = radius + 0.5 * spacing;
  vec2 low = max(kernel.place.xy - reach - 0.5, hachureNoiseRectangle.xy);
  vec2 high = min(
    kernel.place.xy + reach - 0.5, hachureNoiseRectangle.xy + hachureNoiseRectangle.zw - 1.0);
  ivec2 first = ivec2(ceil(low / spacing));
  ivec2 last = ivec2(floor(high / spacing));
  float known = 0.0;
  float seen = 0.0;
  float missing = 0.0;
  for (int row = first.y; row <= last.y; ++row)
  {
    for (int column = first.x; column <= last.x; ++column)
    {
      vec2 pixel = spacing * vec2(column, row);
      vec2 offset = pixel + 0.5 - kernel.place.xy;
      float square = dot(offset, offset);
      if (square <= reach * reach)
      {
        ivec2 here = ivec2(pixel - hachureNoiseRectangle.xy);
        float depth = hachureNoiseDepthAt(here);
        float weight = depth < 1.0
          ? noisePlaneWeight(offset, depth, kernel.plane, hachureNoiseShape.x)
          : 0.0;
        bool other = hachureNoiseTests.z > 0.5 && hachureNoiseIdsAt(here).x != object;
        weight = other ? 0.0 : weight;
        float share = noiseSampleWeight(square, radius);
        known += share;
        seen += share * weight;
        missing += depth < 1.0 ? 1.0 - weight : 0.0;
      }
    }
  }
  vec2 result = known > 0.0 ? vec2(noiseShownShare(seen / known), missing == 0.0 ? 1.0 : 0.0)
                            : vec2(1.0, 0.0);
  gl_FragData[0] = vec4(result, 0.0, 1.0);
}
