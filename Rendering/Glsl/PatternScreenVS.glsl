//VTK::System::Dec

// The rectangle of a viewport, as far away as nothing is.

in vec4 ndCoordIn;
in vec2 texCoordIn;

out vec2 texCoord;

//Hachure::Flat::Dec

void main()
{
  gl_Position = ndCoordIn.xyww;
  texCoord = texCoordIn;
  //Hachure::Flat::Impl
}
