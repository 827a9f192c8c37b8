// Contours found in the attribute images: where the surface ends in front of something farther
// (silhouettes, borders) and where it bends sharply (creases). Lines lie inside the surface.
//
// A flat surface has a window depth that is affine in the picture, so the normal tells the depth
// of every neighbour if the surface went on flat. What deviates is a contour.

uniform vec4 hachureOutlineInk;     // rgb display-referred, a: opacity
uniform vec4 hachureOutlineShape;   // width in framebuffer pixels, cos of the crease angle, depth slack in view units, pixels to march
uniform vec3 hachureOutlineKinds;   // 1 where silhouettes, creases, borders are drawn
uniform vec4 hachureDepthToView;    // view z = (x - ndc * y) / (ndc * z - w), ndc = 2 depth - 1
uniform vec4 hachureFragmentToView; // view xy (perspective: at unit depth): fragment * xy + zw
uniform vec4 hachureRectangle;      // pixels the attribute stage covered: lower left, upper right
uniform vec4 hachureViewport;       // pixels of the viewport, likewise

vec3 hachureUnpackNormal(float coded)
{
  float x = floor(coded / 4096.0);
  vec2 p = vec2(x, coded - x * 4096.0) / 4095.0 * 2.0 - 1.0;
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  if (n.z < 0.0)
  {
    n = vec3((1.0 - abs(n.y)) * (n.x < 0.0 ? -1.0 : 1.0),
      (1.0 - abs(n.x)) * (n.y < 0.0 ? -1.0 : 1.0), n.z);
  }
  return normalize(n);
}

// Window depth of a neighbour; background where this object did not draw, `depth` where the
// picture ends and nobody knows.
float hachureNeighbourDepth(ivec2 pixel, float depth)
{
  vec2 at = vec2(pixel);
  if (any(lessThan(at, hachureViewport.xy)) || any(greaterThanEqual(at, hachureViewport.zw)))
  {
    return -1.0;
  }
  bool drawn = all(greaterThanEqual(at, hachureRectangle.xy)) &&
    all(lessThan(at, hachureRectangle.zw));
  return drawn ? texelFetch(hachureSurfaceDepth, pixel, 0).r : 1.0;
}

// What one pixel knows of its surroundings.
struct HachurePlane
{
  vec2 slope;     // change of window depth per pixel if the surface is flat
  float perUnit;  // change of window depth per view unit of depth
  float unit;     // view units per pixel
  float facing;   // cosine between normal and the ray to the eye
};

HachurePlane hachurePlaneAt(ivec2 pixel, float depth, vec3 normal)
{
  float ndc = 2.0 * depth - 1.0;
  float z = (hachureDepthToView.x - ndc * hachureDepthToView.y) /
    (ndc * hachureDepthToView.z - hachureDepthToView.w);
  vec2 ray = (vec2(pixel) + 0.5) * hachureFragmentToView.xy + hachureFragmentToView.zw;
  HachurePlane plane;
  if (hachureDepthToView.z != 0.0)
  {
    vec3 toEye = normalize(vec3(-ray, 1.0));
    plane.facing = dot(normal, toEye);
    // n . p over the depth of p, kept away from grazing views
    float along = min(dot(normal, vec3(ray, -1.0)), -0.05);
    plane.slope = 0.5 * hachureDepthToView.x * normal.xy * hachureFragmentToView.xy / (along * -z);
    plane.perUnit = 0.5 * abs(hachureDepthToView.x) / (z * z);
    plane.unit = hachureFragmentToView.x * -z;
  }
  else
  {
    plane.facing = normal.z;
    plane.slope = -0.5 * hachureDepthToView.w * normal.xy * hachureFragmentToView.xy /
      max(normal.z, 0.05);
    plane.perUnit = 0.5 * abs(hachureDepthToView.w);
    plane.unit = hachureFragmentToView.x;
  }
  return plane;
}

// True where no contour can be near: the surroundings at the reach of a line lie in the plane.
bool hachureIsFlat(ivec2 pixel, float depth, HachurePlane plane)
{
  int reach = int(hachureOutlineShape.w);
  // A bend by 15 degrees over the reach; depth magnifies bends as the view grazes the surface.
  float facing = clamp(plane.facing, 0.2, 1.0);
  float bend = 0.25 * float(reach) * plane.unit * plane.perUnit / (facing * facing) + 1e-6;
  float slack = hachureOutlineShape.z * plane.perUnit;
  for (int direction = 0; direction < 9; ++direction)
  {
    ivec2 offset = reach * ivec2((direction / 3) - 1, (direction % 3) - 1);
    float other = hachureNeighbourDepth(pixel + offset, depth);
    float rise = dot(plane.slope, vec2(offset));
    float step = other - depth - rise;
    float allowed = slack + 2.0 * abs(rise);
    bool bent = hachureOutlineKinds.y > 0.0 && abs(step) > bend;
    if (other >= 0.0 && (other >= 1.0 || bent || step > allowed))
    {
      return false;
    }
  }
  return true;
}

// Coverage of the outline at a pixel.
float hachureOutline(ivec2 pixel, float depth, float codedNormal)
{
  vec3 normal = hachureUnpackNormal(codedNormal);
  HachurePlane plane = hachurePlaneAt(pixel, depth, normal);
  if (hachureIsFlat(pixel, depth, plane))
  {
    return 0.0;
  }
  // A contour of a surface that still faces the viewer is a border or a sharp corner.
  bool contour = hachureOutlineKinds.x > 0.0 || (plane.facing > 0.25 && hachureOutlineKinds.z > 0.0);
  float slack = hachureOutlineShape.z * plane.perUnit;
  float nearest = 1e6;
  for (int direction = 0; direction < 9; ++direction)
  {
    ivec2 offset = ivec2((direction / 3) - 1, (direction % 3) - 1);
    float stride = length(vec2(offset));
    for (int k = 1; k <= int(hachureOutlineShape.w); ++k)
    {
      float distance = stride * (float(k) - 0.5);
      if (stride == 0.0 || distance > hachureOutlineShape.x + 0.5 || distance >= nearest)
      {
        break;
      }
      ivec2 other = pixel + k * offset;
      float otherDepth = hachureNeighbourDepth(other, depth);
      if (otherDepth < 0.0)
      {
        break;
      }
      float rise = dot(plane.slope, vec2(k * offset));
      float step = otherDepth - depth - rise;
      float allowed = slack + 2.0 * abs(rise);
      if (otherDepth >= 1.0 || step > allowed)
      {
        nearest = contour ? min(nearest, distance) : nearest;
        break;
      }
      if (hachureOutlineKinds.y > 0.0 && abs(step) <= allowed &&
        dot(normal, hachureUnpackNormal(texelFetch(hachureSurfaceData, other, 0).a)) <
          hachureOutlineShape.y)
      {
        // Both sides of a crease draw half of the line.
        nearest = min(nearest, distance + 0.5 * hachureOutlineShape.x);
        break;
      }
    }
  }
  return clamp(hachureOutlineShape.x - nearest + 0.5, 0.0, 1.0);
}

//Section Call
  color = mix(color, toLinear(hachureOutlineInk.rgb), hachureOutline(pixel, depth, data.a) * hachureOutlineInk.a);
