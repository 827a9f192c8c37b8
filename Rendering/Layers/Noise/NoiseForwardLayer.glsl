// A noise layer on a translucent surface: sums up, per fragment, the kernels of all surfaces of the
// object that lie on its own plane, so that every surface has its own noise. What makes ink of the field
// comes from NoiseLayer.glsl. '@' is the layer's number, IDSHERE block and triangle of the fragment, or
// hachureNoIds@ where they are not told apart.

//Hachure::NoiseSums::Dec

const vec2 hachureNoIds@ = vec2(0.0);

uniform vec4 hachureNoisePlace@; // row of the table of thresholds (z), share of flat tone (w)

vec2 hachureField@()
{
  vec2 sum = hachureNoiseSum@(gl_FragCoord.xy, gl_FragCoord.z, IDSHERE);
  vec2 alongX = dFdx(sum);
  vec2 alongY = dFdy(sum);
  return hachureNoiseField@(sum, sum - alongX, sum + alongX, sum - alongY, sum + alongY);
}
