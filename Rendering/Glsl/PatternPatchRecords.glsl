// Which patches overlap on a triangle, and by what weights; see VertexPatches in TrianglePatches.h.

uniform samplerBuffer hachurePatchRecords; // shapes and patches of triangles, 4 texels each
uniform samplerBuffer hachurePatchWeights; // at their corners, 3 texels each

// code: of the triangle's last vertex; point: model coordinates about the records' origin. A patch
// without records takes part in the search, and is told apart in the end: software OpenGL executes
// both sides of every branch.
void hachureSeeTriangle(float code, vec3 point)
{
  int record = max(int(-code - 1.0), 0);
  int best = record;
  vec3 place = vec3(0.0, 0.0, -1.0e30);
  bool more = false;
  do
  {
    vec4 corner = texelFetch(hachurePatchRecords, 4 * record);
    vec3 tried =
      placeInTriangle(point, corner.xyz, texelFetch(hachurePatchRecords, 4 * record + 1).xyz,
        texelFetch(hachurePatchRecords, 4 * record + 2).xyz);
    bool better = tried.z > place.z;
    best = better ? record : best;
    place = better ? tried : place;
    more = code < 0.0 && corner.w > 0.0;
    ++record;
  } while (more);
  vec4 numbers = texelFetch(hachurePatchRecords, 4 * best + 3);
  vec4 weights = patchWeights(place, texelFetch(hachurePatchWeights, 3 * best),
    texelFetch(hachurePatchWeights, 3 * best + 1), texelFetch(hachurePatchWeights, 3 * best + 2));
  hachureSeePatches(
    code < 0.0 ? numbers : vec4(code), code < 0.0 ? weights : vec4(1.0, 0.0, 0.0, 0.0));
}
