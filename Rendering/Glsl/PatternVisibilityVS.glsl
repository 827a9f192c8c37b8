//VTK::System::Dec

// A rectangle. The matrices are the same for all of it: software OpenGL reads those of vertices once,
// but uniforms for every fragment and number by number.

in vec4 ndCoordIn;
in vec2 texCoordIn;

uniform mat4 sampleToFragment;
uniform mat4 fragmentToSample;
uniform vec4 viewportPixels;

out vec2 texCoord;
flat out mat4 toFragment;
flat out mat4 fromFragment;
flat out vec4 lastFragment;

void main()
{
  gl_Position = ndCoordIn;
  texCoord = texCoordIn;
  toFragment = sampleToFragment;
  fromFragment = fragmentToSample;
  lastFragment = viewportPixels;
}
