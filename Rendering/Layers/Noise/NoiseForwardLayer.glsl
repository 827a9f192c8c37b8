// A noise layer on a translucent surface: sums up, per fragment, the kernels of all surfaces of the
// object that lie on its own plane, so that every surface has its own noise. '@' is the layer's
// number.

//Hachure::NoiseSums::Dec

uniform vec4 hachureNoisePlace@; // row of the table of thresholds (z), share of flat tone (w)

float hachureCoverage@(vec2 position, float tone)
{
  vec2 sum = hachureNoiseSum@(gl_FragCoord.xy, gl_FragCoord.z, vec2(0.0));
  vec2 alongX = dFdx(sum);
  vec2 alongY = dFdy(sum);
  vec2 field =
    hachureNoiseField@(sum, sum - alongX, sum + alongX, sum - alongY, sum + alongY);
  return patternInk(tone, hachureThreshold(tableColumn(tone), hachureNoisePlace@.z), field,
    hachureNoisePlace@.w);
}
