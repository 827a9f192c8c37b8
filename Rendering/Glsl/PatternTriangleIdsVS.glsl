//VTK::System::Dec

// Unconnected triangles whose corners are given in clip coordinates.

in vec4 cornerClip;

uniform int firstTriangle; // index of the first triangle of this draw

flat out int triangleIndex;

void main()
{
  triangleIndex = firstTriangle + gl_VertexID / 3;
  gl_Position = cornerClip;
}
