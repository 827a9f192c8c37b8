//VTK::System::Dec
//VTK::Output::Dec

// From sums of kernels to the field that a noise layer reads: value and half the width.

in vec2 texCoord;

uniform sampler2D hachureNoiseSums; // at the pixels of the rectangle

//Hachure::NoiseSums::Dec

// Sums at a pixel beside this one; where the rectangle ends they go on.
vec2 sumBeside(ivec2 here, ivec2 step, vec2 sum)
{
  ivec2 size = ivec2(hachureNoiseRectangle.zw);
  ivec2 there = here + step;
  bool inside = all(greaterThanEqual(there, ivec2(0))) && all(lessThan(there, size));
  ivec2 opposite = clamp(here - step, ivec2(0), size - 1);
  vec2 found = texelFetch(hachureNoiseSums, inside ? there : opposite, 0).rg;
  return inside ? found : 2.0 * sum - found;
}

void main()
{
  ivec2 here = ivec2(gl_FragCoord.xy);
  vec2 field = vec2(0.0);
  if (hachureNoiseDepthAt(here) < 1.0 && texCoord.x >= 0.0)
  {
    vec2 sum = texelFetch(hachureNoiseSums, here, 0).rg;
    field = hachureNoiseField(sum, sumBeside(here, ivec2(-1, 0), sum),
      sumBeside(here, ivec2(1, 0), sum), sumBeside(here, ivec2(0, -1), sum),
      sumBeside(here, ivec2(0, 1), sum));
  }
  gl_FragData[0] = vec4(field.x, field.y / tileGradientRange, 0.0, 1.0);
}
