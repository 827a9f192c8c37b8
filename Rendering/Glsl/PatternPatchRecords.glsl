// Which patches overlap on a triangle, and by what weights; see VertexPatches in TrianglePatches.h.

uniform samplerBuffer hachurePatchRecords; // 7 texels for each triangle on which patches overlap
uniform vec3 hachurePatchOrigin; // of their coordinates, in the model's

// code: of the triangle's last vertex; point: model coordinates about the records' origin.
void hachureSeeTriangle(float code, vec3 point)
{
  hachurePatches.numbers.x = max(code, 0.0);
  // Software OpenGL executes both sides of every branch, but a loop no more often than it must.
  int texel = 7 * int(-code - 1.0);
  int best = texel;
  float bestFit = -1.0e30;
  bool more = code < 0.0;
  while (more)
  {
    vec4 corner = texelFetch(hachurePatchRecords, texel);
    float fit = triangleFit(point, corner.xyz, texelFetch(hachurePatchRecords, texel + 1).xyz,
      texelFetch(hachurePatchRecords, texel + 2).xyz);
    best = fit > bestFit ? texel : best;
    bestFit = max(fit, bestFit);
    more = corner.w > 0.0;
    texel += 7;
  }
  for (bool found = code < 0.0; found; found = false)
  {
    hachureSeePatches(texelFetch(hachurePatchRecords, best + 3),
      patchWeights(point, texelFetch(hachurePatchRecords, best).xyz,
        texelFetch(hachurePatchRecords, best + 1).xyz,
        texelFetch(hachurePatchRecords, best + 2).xyz, texelFetch(hachurePatchRecords, best + 4),
        texelFetch(hachurePatchRecords, best + 5), texelFetch(hachurePatchRecords, best + 6)));
  }
}
