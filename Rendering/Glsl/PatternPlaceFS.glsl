//VTK::System::Dec
//VTK::Output::Dec

// Puts what was drawn of one object into the picture, at its depth.

in vec2 texCoord;

uniform sampler2D hachureDrawn;        // display-referred colour times alpha
uniform sampler2D hachureSurfaceDepth; // window depth, 1 where nothing was drawn
uniform float hachureMostLeftOut;      // alpha

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(hachureSurfaceDepth, pixel, 0).r;
  vec4 drawn = texelFetch(hachureDrawn, pixel, 0);
  // The last part never holds; the quad must use all of its attributes.
  if (depth >= 1.0 || drawn.a <= hachureMostLeftOut || texCoord.x < 0.0)
  {
    discard;
  }
  gl_FragData[0] = drawn;
  gl_FragDepth = depth;
}
