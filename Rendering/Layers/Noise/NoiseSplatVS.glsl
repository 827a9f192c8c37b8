//VTK::System::Dec

// Squares around kernels, two triangles each, without any vertex buffer.

//Hachure::NoiseSums::Dec

flat out int kernelIndex;

void main()
{
  kernelIndex = gl_VertexID / 6;
  int corner = gl_VertexID - 6 * kernelIndex;
  bool right = corner == 1 || corner == 2 || corner == 4;
  bool top = corner == 2 || corner == 4 || corner == 5;
  PackedKernel kernel = hachureNoiseKernel(kernelIndex);
  // One pixel more: what belongs to the disc is decided in the fragments.
  float reach = hachureNoiseShare(kernelIndex).x > 0.0 ? kernel.plane.w + 1.0 : 0.0;
  vec2 place = kernel.place.xy + reach * vec2(right ? 1.0 : -1.0, top ? 1.0 : -1.0);
  vec2 inside = (place - hachureNoiseRectangle.xy) / hachureNoiseRectangle.zw;
  gl_Position = vec4(2.0 * inside - 1.0, 0.0, 1.0);
}
