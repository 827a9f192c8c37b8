// A noise layer: reads the field that was summed up for the pixels of the framebuffer. '@' is the
// layer's number.

//Section Field
uniform sampler2D hachureNoise@;   // screen and gradient, see tileTexel
uniform vec4 hachureNoisePlace@;   // first pixel (xy), row of the table of thresholds, share of flat tone

vec2 hachureField@()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - hachureNoisePlace@.xy);
  return tileTexel(texelFetch(hachureNoise@, pixel, 0).rg);
}

//Section Threshold
float hachureCoverage@(vec2 position, float tone)
{
  return patternInk(tone, hachureThreshold(tableColumn(tone), hachureNoisePlace@.z), hachureField@(),
    hachureNoisePlace@.w);
}

//Section ThresholdImage
uniform sampler2D hachureInkSums@; // ink of all values up to a value (across), by tone (up)

float hachureInkSum@(float value, float tone)
{
  vec2 size = vec2(textureSize(hachureInkSums@, 0));
  return texture(hachureInkSums@, (vec2(value, tone) * (size - 1.0) + 0.5) / size).r;
}

float hachureCoverage@(vec2 position, float tone)
{
  vec2 field = hachureField@();
  float column = 1.0 / float(textureSize(hachureInkSums@, 0).x - 1);
  vec2 seen = screenInterval(field.x, max(field.y, column));
  float ink = (hachureInkSum@(seen.y, tone) - hachureInkSum@(seen.x, tone)) / (seen.y - seen.x);
  return clamp(mix(ink, hachureInkSum@(1.0, tone), hachureNoisePlace@.w), 0.0, 1.0);
}
