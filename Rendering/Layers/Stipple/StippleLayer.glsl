// A layer of stipples: reads the share of every pixel that they cover. '@' is the layer's number.

//Section Ink
uniform sampler2D hachureStipples@; // places covered, of 64, over 255
uniform vec3 hachureStipplePlace@;  // first pixel (xy); 1: there are stipples

// Whether they are on what is drawn here.
bool hachureStippled@();

float hachureCoverage@(vec2 position, float tone)
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - hachureStipplePlace@.xy);
  float covered = texelFetch(hachureStipples@, pixel, 0).r * (255.0 / 64.0);
  // The darkest tone leaves no pinholes.
  return hachureStippled@() && tone < 0.999 ? covered : clamp(tone, 0.0, 1.0);
}

//Section Opaque
bool hachureStippled@()
{
  return hachureStipplePlace@.z > 0.5;
}

//Section Forward
uniform sampler2D hachureStippleDepth@; // window depth of what they are on

bool hachureStippled@()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy - hachureStipplePlace@.xy);
  // More than the rounding of 24 bits.
  return hachureStipplePlace@.z > 0.5 &&
    abs(gl_FragCoord.z - texelFetch(hachureStippleDepth@, pixel, 0).r) < 2.4e-7;
}
