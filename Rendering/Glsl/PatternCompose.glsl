// The stack of layers on paper, evaluated at one point of the picture. Shared by the screen pass
// of opaque surfaces and by the forward shader of translucent ones. PAPER is the colour of the paper:
// hachurePaper, hachureSurfaceHere or, where there is none, hachurePaperHere.

uniform vec4 hachurePixelMap;  // logical pixel = fragment * xy + zw
uniform vec3 hachurePaper;     // linear colour
uniform vec3 hachureNanColor;  // linear colour of surface without data
uniform sampler2D hachureToneTables; // thresholds of 256 tones across, the rows of all layers up
uniform sampler2D hachureResponses;  // the other way: tones of 256 thresholds (r), and their slope (g)
uniform float hachureTableRows;      // number of these rows

uniform vec3 hachurePatchOrigin;     // near the surface: coordinates about it keep their digits

//Hachure::Seen::Dec

vec3 hachureSurfaceHere = vec3(0.0); // linear colour of the surface, set by hachureCompose
vec3 hachurePaperHere = vec3(1.0);   // linear colour of what is tried in place of a paper

vec3 hachureUnpackNormal(float packedNormal)
{
  float x = floor(packedNormal / 4096.0);
  vec2 p = vec2(x, packedNormal - x * 4096.0) / 4095.0 * 2.0 - 1.0;
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  if (n.z < 0.0)
  {
    n = vec3((1.0 - abs(n.y)) * (n.x < 0.0 ? -1.0 : 1.0),
      (1.0 - abs(n.x)) * (n.y < 0.0 ? -1.0 : 1.0), n.z);
  }
  return normalize(n);
}

vec2 hachureLogicalPosition(vec2 fragment)
{
  return fragment * hachurePixelMap.xy + hachurePixelMap.zw;
}

//Hachure::ColorAt::Dec

// Threshold of a layer's screen; both are texture coordinates of the tables.
float hachureThreshold(float column, float row)
{
  return texture(hachureToneTables, vec2(column, row)).r;
}

// A screen and its change across a pixel, both made uniform: the tone whose threshold is this value,
// which is the share of the screen, as it is drawn, that lies below it.
vec2 hachureUniformScreen(vec2 field, float row)
{
  vec2 response = texture(hachureResponses, vec2(tableColumn(field.x), row)).rg;
  return vec2(response.x, response.y * field.y);
}

// Where a pattern lies; see PatternPlacement.h.
struct HachurePlacement
{
  vec4 axis;    // change of the tile coordinate u along x and y (xy); u and v at the origin
  vec4 octaves; // texels of level 0 per pixel of the framebuffer, weight of the half-size copy, rows of the tone tables of both octaves as texture coordinates
};

//Hachure::Patches::Dec

//Hachure::Layers::Dec

// position: logical pixels; surface: display-referred colour of the surface; tones: per channel,
// negative where the array has no number. Returns a linear colour.
vec3 hachureCompose(vec2 position, vec3 surface, vec4 tones)
{
  if (min(min(tones.x, tones.y), min(tones.z, tones.w)) < 0.0)
  {
    return hachureNanColor;
  }
  hachureSurfaceHere = toLinear(surface);
  vec3 color = PAPER;
  //Hachure::Layers::Impl
  return color;
}
