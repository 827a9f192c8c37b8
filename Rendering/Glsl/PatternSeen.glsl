// The point of the surface that is seen, for layers that lie on the surface.

uniform vec4 hachureClipX; // rows of the matrix from model to clip coordinates
uniform vec4 hachureClipY;
uniform vec4 hachureClipW;
uniform vec2 hachureFragmentSize; // of a fragment in normalised device coordinates

// Set by hachureSeeSurface and hachureSeeTexture before hachureCompose.
vec3 hachurePoint = vec3(0.0);  // model coordinates
vec3 hachureFacet = vec3(0.0, 0.0, 1.0); // normal of the triangle, model coordinates
vec3 hachurePointDx = vec3(0.0); // change of the point per fragment
vec3 hachurePointDy = vec3(0.0);
vec3 hachureTexture = vec3(0.0); // texture coordinates, z: 1 where there are some
vec4 hachureTextureSlopes = vec4(0.0); // their change per fragment: along x, along y

void hachureSeeSurface(vec3 point, vec3 normal)
{
  SurfaceSlopes slopes = surfaceSlopes(point, normal, hachureClipX, hachureClipY, hachureClipW);
  hachurePoint = point;
  hachureFacet = normal;
  hachurePointDx = slopes.alongX * hachureFragmentSize.x;
  hachurePointDy = slopes.alongY * hachureFragmentSize.y;
}

void hachureSeeTexture(vec3 coordinates, vec4 slopes)
{
  hachureTexture = coordinates;
  hachureTextureSlopes = slopes;
}
