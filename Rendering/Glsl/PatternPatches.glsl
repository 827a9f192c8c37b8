// Where the patterns of several patches lie, which overlap at this point of the surface.

uniform sampler2D hachurePlacements; // patches up, three texels for every layer across

// The patches here, those that matter first; the rest has no weight.
vec4 hachurePatchNumbers = vec4(0.0);
vec4 hachurePatchShares = vec4(1.0, 0.0, 0.0, 0.0);

void hachureSeePatch(float number)
{
  hachurePatchNumbers.x = max(number, 0.0);
}

void hachureSeePatches(vec4 numbers, vec4 weights)
{
  vec4 kept = relevantWeights(weights);
  hachurePatchShares = vec4(0.0);
  int found = 0;
  for (int i = 0; i < 4; ++i)
  {
    if (kept[i] > 0.0)
    {
      hachurePatchNumbers[found] = numbers[i];
      hachurePatchShares[found] = kept[i];
      ++found;
    }
  }
}

HachurePlacement hachurePlacementOf(int layer, float patchNumber)
{
  ivec2 texel = ivec2(3 * layer, int(patchNumber));
  return HachurePlacement(texelFetch(hachurePlacements, texel, 0),
    texelFetch(hachurePlacements, texel + ivec2(1, 0), 0),
    texelFetch(hachurePlacements, texel + ivec2(2, 0), 0));
}
