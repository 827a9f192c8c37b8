// Where the patterns of several patches lie, which overlap at this point of the surface.

uniform sampler2D hachurePlacements; // patches up, three texels for every layer across

// The patches here, and how many there are.
vec4 hachurePatchNumbers = vec4(0.0);
vec4 hachurePatchShares = vec4(1.0, 0.0, 0.0, 0.0);
int hachurePatchCount = 1;

// Patches without a share go to the end; the others keep their order.
void hachureSeePatches(vec4 numbers, vec4 weights)
{
  vec4 shares = relevantWeights(weights);
  for (int turn = 0; turn < 3; ++turn)
  {
    for (int i = 0; i < 3; ++i)
    {
      bool empty = shares[i] <= 0.0;
      shares[i] = empty ? shares[i + 1] : shares[i];
      numbers[i] = empty ? numbers[i + 1] : numbers[i];
      shares[i + 1] = empty ? 0.0 : shares[i + 1];
    }
  }
  hachurePatchNumbers = numbers;
  hachurePatchShares = shares;
  hachurePatchCount = int(dot(step(vec4(1.0e-6), shares), vec4(1.0)));
}

HachurePlacement hachurePlacementOf(int layer, float patchNumber)
{
  ivec2 texel = ivec2(3 * layer, int(patchNumber));
  return HachurePlacement(texelFetch(hachurePlacements, texel, 0),
    texelFetch(hachurePlacements, texel + ivec2(1, 0), 0),
    texelFetch(hachurePlacements, texel + ivec2(2, 0), 0));
}
