//VTK::System::Dec

// The rectangle of a viewport. What is the same for all of it: software OpenGL reads values of vertices
// once, but uniforms for every fragment and number by number.

in vec4 ndCoordIn;
in vec2 texCoordIn;

uniform mat4 hachurePatchMatrix; // from fragment and depth to the coordinates of patches' records

out vec2 texCoord;
flat out mat4 hachureFragmentToPatches;

void main()
{
  gl_Position = ndCoordIn;
  texCoord = texCoordIn;
  hachureFragmentToPatches = hachurePatchMatrix;
}
