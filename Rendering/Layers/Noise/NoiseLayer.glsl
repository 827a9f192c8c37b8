// A noise layer: reads the field that was summed up for the pixels of the framebuffer. '@' is the
// layer's number.

uniform sampler2D hachureNoise@;   // screen and gradient, see tileTexel
uniform vec4 hachureNoisePlace@;   // first pixel (xy), row of the table of thresholds, share of flat tone

float hachureCoverage@(vec2 position, float tone)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - hachureNoisePlace@.xy);
  vec2 field = tileTexel(texelFetch(hachureNoise@, pixel, 0).rg);
  return patternInk(tone, hachureThreshold(tableColumn(tone), hachureNoisePlace@.z), field,
    hachureNoisePlace@.w);
}
