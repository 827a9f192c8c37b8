//VTK::System::Dec
//VTK::Output::Dec

// Sums of a noise, every pixel of the rectangle for itself: those of all kernels that its tile lists.

in vec2 texCoord;

//Hachure::NoiseSums::Dec

void main()
{
  ivec2 here = ivec2(gl_FragCoord.xy);
  vec2 sum = vec2(0.0);
  // The second part always holds; the quad must use all of its attributes.
  if (hachureNoiseMatters(here) && texCoord.x >= 0.0)
  {
    sum = hachureNoiseSum(vec2(here) + 0.5 + hachureNoiseRectangle.xy, hachureNoiseDepthAt(here),
      hachureNoiseIdsAt(here));
  }
  gl_FragData[0] = vec4(sum, 0.0, 1.0);
}
