//VTK::System::Dec
//VTK::Output::Dec

// Writes the index of the triangle, exactly, in two floats: low 16 bits, high bits; and 1 = covered.

flat in int triangleIndex;

void main()
{
  gl_FragData[0] = vec4(float(triangleIndex & 65535), float(triangleIndex >> 16), 1.0, 1.0);
}
