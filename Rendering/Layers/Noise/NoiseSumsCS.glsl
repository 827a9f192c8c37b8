#version 430

// Sums of a noise: the pixels of a tile load its kernels together, each one a kernel, and then each
// sums up all of them.

layout(local_size_x = 16, local_size_y = 16) in;

layout(rg32f, binding = 0) uniform writeonly image2D hachureNoiseImage; // of the rectangle

//Hachure::NoiseSums::Dec

const int batch = 256; // invocations of a group

shared PackedKernel kernels[batch];
shared vec4 owns[batch]; // see hachureNoiseAdd

void main()
{
  ivec2 here = ivec2(gl_GlobalInvocationID.xy);
  bool inside = all(lessThan(here, ivec2(hachureNoiseRectangle.zw)));
  bool matters = inside && hachureNoiseMatters(here);
  vec2 pixel = vec2(here) + 0.5 + hachureNoiseRectangle.xy;
  float depth = hachureNoiseDepthAt(here);
  vec2 ids = inside ? hachureNoiseIdsAt(here) : vec2(0.0);
  // A tile is as large as one group or several.
  ivec2 range = hachureNoiseRange(ivec2(gl_WorkGroupID.xy) * 16 / int(hachureNoiseTiles.x));
  vec2 sum = vec2(0.0);
  for (int begin = range.x; begin < range.y; begin += batch)
  {
    int mine = int(gl_LocalInvocationIndex);
    if (begin + mine < range.y)
    {
      int index = hachureNoiseListed(begin + mine);
      kernels[mine] = hachureNoiseKernel(index);
      owns[mine] = hachureNoiseOwn(index);
    }
    barrier();
    int count = matters ? min(batch, range.y - begin) : 0;
    for (int i = 0; i < count; ++i)
    {
      sum += hachureNoiseAdd(kernels[i], owns[i], pixel, depth, ids);
    }
    barrier();
  }
  if (inside)
  {
    imageStore(hachureNoiseImage, here, vec4(sum, 0.0, 1.0));
  }
}
