// Where the patterns of several patches lie, which overlap at this point of the surface. LAYERS is the
// number of layers.

uniform samplerBuffer hachurePlacements; // of every layer on the first patch, on the second, ...: two texels each

// Up to four patches, those with a share first.
struct HachurePatches
{
  vec4 numbers;
  vec4 shares;
};

HachurePatches hachurePatches = HachurePatches(vec4(0.0), vec4(1.0, 0.0, 0.0, 0.0)); // here

// Those marked by 1 give way to the next one.
HachurePatches hachureMovedUp(HachurePatches patches, vec4 marked)
{
  HachurePatches next =
    HachurePatches(patches.numbers.yzwx, vec4(patches.shares.yzw, 0.0));
  return HachurePatches(mix(patches.numbers, next.numbers, marked),
    mix(patches.shares, next.shares, marked));
}

// Without the first one: a loop over the patches takes each from the front, as software OpenGL takes
// vectors apart wherever they have an index.
HachurePatches hachureNextPatches(HachurePatches patches)
{
  return hachureMovedUp(patches, vec4(1.0));
}

// Closes the gaps that patches without a share leave; the others keep their order.
void hachureSeePatches(vec4 numbers, vec4 weights)
{
  HachurePatches found = HachurePatches(numbers, relevantWeights(weights));
  found = hachureMovedUp(found, step(found.shares.z, 0.0) * vec4(0.0, 0.0, 1.0, 1.0));
  found = hachureMovedUp(found, step(found.shares.y, 0.0) * vec4(0.0, 1.0, 1.0, 1.0));
  hachurePatches = hachureMovedUp(found, step(found.shares.x, 0.0) * vec4(1.0));
}

HachurePlacement hachurePlacementOf(int layer, float patchNumber)
{
  int texel = 2 * (LAYERS * int(patchNumber) + layer);
  return HachurePlacement(
    texelFetch(hachurePlacements, texel), texelFetch(hachurePlacements, texel + 1));
}
