// Which patches overlap on a triangle, and by what weights; see TrianglePatches.

uniform samplerBuffer hachurePatchRecords; // 7 texels for each triangle on which patches overlap
uniform vec3 hachurePatchOrigin;     // of their coordinates, in the model's
uniform mat4 hachureClipToPatches;   // from clip coordinates to theirs
uniform vec4 hachureDrawnArea;       // framebuffer pixels: x, y, width, height

// triangle: its patch, or -1 - its record; point: model coordinates about the records' origin.
void hachureSeeTriangle(float triangle, vec3 point)
{
  hachureSeePatch(triangle);
  // Software OpenGL executes both sides of every branch, but a loop no more often than it must.
  for (int record = int(-triangle); record > 0; record = 0)
  {
    int texel = 7 * (record - 1);
    vec4 corner = texelFetch(hachurePatchRecords, texel);
    vec4 toSecond = texelFetch(hachurePatchRecords, texel + 1);
    vec4 toThird = texelFetch(hachurePatchRecords, texel + 2);
    vec4 numbers =
      vec4(corner.w, toSecond.w, toThird.w, texelFetch(hachurePatchRecords, texel + 3).x);
    hachureSeePatches(numbers,
      patchWeights(point, corner.xyz, toSecond.xyz, toThird.xyz,
        texelFetch(hachurePatchRecords, texel + 4), texelFetch(hachurePatchRecords, texel + 5),
        texelFetch(hachurePatchRecords, texel + 6)));
  }
}
