//VTK::System::Dec
//VTK::Output::Dec

// What one kernel adds to the sums: blending adds up.

flat in int kernelIndex;

//Hachure::NoiseSums::Dec

void main()
{
  ivec2 here = ivec2(gl_FragCoord.xy);
  vec2 added = hachureNoiseAdd(hachureNoiseKernel(kernelIndex), hachureNoiseOwn(kernelIndex),
    vec2(here) + 0.5 + hachureNoiseRectangle.xy, hachureNoiseDepthAt(here),
    hachureNoiseIdsAt(here));
  gl_FragData[0] = vec4(added, 0.0, 0.0);
}
