// What the screen pass reads for layers that lie on the surface.

//Section PointDec
uniform sampler2D hachureSurfacePoint; // model coordinates, w: packed normal of the triangle
//Section PointImpl
  vec4 point = texelFetch(hachureSurfacePoint, pixel, 0);
  hachureSeeSurface(point.xyz, hachureUnpackNormal(point.w));
//Section PlaceDec
uniform mat4 hachureFragmentToPatches; // from fragment and depth to model coordinates about hachurePatchOrigin
//Section PlaceImpl
  vec4 place = hachureFragmentToPatches * vec4(gl_FragCoord.xy, depth, 1.0);
//Section RunDec
uniform sampler2D hachureSurfaceRun; // first record of the triangles to try
//Section RunImpl
  hachureSeeRun(texelFetch(hachureSurfaceRun, pixel, 0).r, place.xyz / place.w);
//Section PatchDec
uniform sampler2D hachureSurfacePatch; // patch of the triangle, or -1 - the first record to try
//Section PatchImpl
  hachureSeeTriangle(texelFetch(hachureSurfacePatch, pixel, 0).r, place.xyz / place.w);
//Section TextureDec
uniform sampler2D hachureSurfaceTexture;       // texture coordinates, z: 1 where there are some
uniform sampler2D hachureSurfaceTextureSlopes; // their change per fragment: along x, along y
//Section TextureImpl
  hachureSeeTexture(texelFetch(hachureSurfaceTexture, pixel, 0).xyz,
    texelFetch(hachureSurfaceTextureSlopes, pixel, 0));
