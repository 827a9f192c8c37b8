// Which patches overlap on a triangle, and by what weights; see VertexPatches in TrianglePatches.h.

uniform samplerBuffer hachurePatchRecords; // 7 texels for each triangle on which patches overlap
uniform vec3 hachurePatchOrigin; // of their coordinates, in the model's

// code: of the triangle's last vertex; point: model coordinates about the records' origin. A patch
// without records takes part in the search, and is told apart in the end: software OpenGL executes
// both sides of every branch.
void hachureSeeTriangle(float code, vec3 point)
{
  int texel = 7 * max(int(-code - 1.0), 0);
  int best = texel;
  vec3 place = vec3(0.0, 0.0, -1.0e30);
  bool more = false;
  do
  {
    vec4 corner = texelFetch(hachurePatchRecords, texel);
    vec3 tried =
      placeInTriangle(point, corner.xyz, texelFetch(hachurePatchRecords, texel + 1).xyz,
        texelFetch(hachurePatchRecords, texel + 2).xyz);
    bool better = tried.z > place.z;
    best = better ? texel : best;
    place = better ? tried : place;
    more = code < 0.0 && corner.w > 0.0;
    texel += 7;
  } while (more);
  vec4 numbers = texelFetch(hachurePatchRecords, best + 3);
  vec4 weights = patchWeights(place, texelFetch(hachurePatchRecords, best + 4),
    texelFetch(hachurePatchRecords, best + 5), texelFetch(hachurePatchRecords, best + 6));
  hachureSeePatches(
    code < 0.0 ? numbers : vec4(code), code < 0.0 ? weights : vec4(1.0, 0.0, 0.0, 0.0));
}
