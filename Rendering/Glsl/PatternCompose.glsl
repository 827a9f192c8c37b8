// The stack of layers on paper, evaluated at one point of the picture. Shared by the screen pass
// of opaque surfaces and by the forward shader of translucent ones.

uniform vec4 hachurePixelMap;  // logical pixel = fragment * xy + zw
uniform vec4 hachurePaper;     // linear colour; w: 1 = the surface's colour instead
uniform vec3 hachureNanColor;  // linear colour of surface without data
uniform sampler2D hachureToneTables; // 256 tones across, the rows of all layers up
uniform float hachureTableRows;      // number of these rows

vec2 hachureLogicalPosition(vec2 fragment)
{
  return fragment * hachurePixelMap.xy + hachurePixelMap.zw;
}

// Threshold of a layer's screen; both are texture coordinates of the tables.
float hachureThreshold(float column, float row)
{
  return texture(hachureToneTables, vec2(column, row)).r;
}

// Tone after the layer's own curve: gamma, and 1 where light and dark are exchanged.
float hachureToneCurve(float tone, vec2 curve)
{
  return pow(mix(tone, 1.0 - tone, curve.y), curve.x);
}

//Hachure::Layers::Dec

// position: logical pixels; surface: display-referred colour of the surface; tones: per channel,
// negative where the array has no number. Returns a linear colour.
vec3 hachureCompose(vec2 position, vec3 surface, vec3 tones)
{
  if (min(tones.x, min(tones.y, tones.z)) < 0.0)
  {
    return hachureNanColor;
  }
  vec3 color = hachurePaper.w > 0.0 ? toLinear(surface) : hachurePaper.rgb;
  //Hachure::Layers::Impl
  return color;
}
