// A layer of stipples: reads the share of every pixel that they cover. '@' is the layer's number.

uniform sampler2D hachureStipples@;   // places covered, of 64, over 255
uniform vec3 hachureStipplePlace@;    // first pixel (xy); 1: there are stipples

float hachureCoverage@(vec2 position, float tone)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - hachureStipplePlace@.xy);
  float covered = texelFetch(hachureStipples@, pixel, 0).r * (255.0 / 64.0);
  // The darkest tone leaves no pinholes.
  return hachureStipplePlace@.z > 0.5 && tone < 0.999 ? covered : clamp(tone, 0.0, 1.0);
}
