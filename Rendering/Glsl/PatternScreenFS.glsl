//VTK::System::Dec
//VTK::Output::Dec

// Draws the layers of one object over the pixels that its attribute stage covered. A depth test passes
// over all others, before anything is computed.

in vec2 texCoord;

uniform sampler2D hachureSurfaceColor;  // rgb display-referred colour, a: 1 - half the drawn edge, a quarter of it without data,
                                        // 0.03 where another process draws it
uniform sampler2D hachureSurfaceTone;   // tones of four channels
uniform sampler2D hachureSurfaceNormal; // packed normal in view coordinates, for outlines
uniform sampler2D hachureSurfaceDepth;  // window depth, 1 where nothing was drawn

//Hachure::Compose::Dec

//Hachure::Surface::Dec

//Hachure::Outline::Dec

// Display-referred.
vec3 hachurePicture(ivec2 pixel, float depth, vec4 surface, vec4 tones, bool hasData)
{
  vec3 color = hachureCompose(hachureLogicalPosition(gl_FragCoord.xy), surface.rgb, tones);
  //Hachure::Outline::Impl
  // Edges that VTK drew lie over the pattern.
  return mix(fromLinear(color), surface.rgb, clamp(2.0 - (hasData ? 2.0 : 8.0) * surface.a, 0.0, 1.0));
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(hachureSurfaceDepth, pixel, 0).r;
  vec4 surface = texelFetch(hachureSurfaceColor, pixel, 0);
  bool hasData = surface.a > 0.4;
  vec4 tones = hasData ? texelFetch(hachureSurfaceTone, pixel, 0) : vec4(-1.0);
  //Hachure::Surface::Impl
  //Hachure::Picture::Impl
  // The quad must use all of its attributes.
  gl_FragData[0] = vec4(picture.rgb, surface.a < 0.06 || texCoord.x < 0.0 ? 0.0 : picture.a);
}
