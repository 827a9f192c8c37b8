// Contours found in the attribute images: where the surface ends in front of something farther
// (silhouettes, borders) and where it bends sharply (creases). Lines lie inside the surface.
//
// A flat surface has a window depth that is affine in the picture, so the normal tells the depth
// of every neighbour if the surface went on flat. What deviates is a contour.

//Section Functions
uniform vec4 hachureOutlineInk;     // rgb display-referred, a: opacity
uniform vec3 hachureOutlineShape;   // width in framebuffer pixels, cos of the crease angle, depth slack in view units
uniform vec3 hachureOutlineKinds;   // 1 where silhouettes, creases, borders are drawn
uniform vec4 hachureDepthToView;    // view z = (x - ndc * y) / (ndc * z - w), ndc = 2 depth - 1
uniform vec4 hachureFragmentToView; // view xy (perspective: at unit depth): fragment * xy + zw
uniform vec4 hachureViewport;       // first and last pixels of the viewport

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

// The eight neighbours, those beside first.
ivec2 hachureDirection(int index)
{
  int side = 1 - 2 * (index % 2);
  ivec2 straight = index < 2 ? ivec2(side, 0) : ivec2(0, side);
  ivec2 oblique = index < 6 ? ivec2(side, side) : ivec2(side, -side);
  return index < 4 ? straight : oblique;
}

// Coverage of the outline at a pixel.
//
// First the surroundings are tried, one tap to each side, far enough that no line can pass between.
// Only where one of them leaves the plane, all taps nearer by are tried for the nearest contour. One
// loop does both: software OpenGL executes both sides of every branch, but a loop no more often than
// it must.
float hachureOutline(ivec2 pixel, float depth, float codedNormal)
{
  vec3 normal = hachureUnpackNormal(codedNormal);
  HachurePlane plane = hachurePlaneAt(pixel, depth, normal);
  // Distances count from the middle between two pixels; lines end half a pixel past their width.
  int reach = int(ceil(1.4142 * (hachureOutlineShape.x + 0.5)));
  int strides = int(hachureOutlineShape.x + 1.0);
  float slack = hachureOutlineShape.z * plane.perUnit;
  // A bend by 15 degrees over the reach; depth magnifies bends as the view grazes the surface.
  float facing = clamp(plane.facing, 0.2, 1.0);
  float bend = 0.25 * float(reach) * plane.unit * plane.perUnit / (facing * facing) + 1e-6;
  // A contour of a surface that still faces the viewer is a border or a sharp corner.
  bool contours =
    hachureOutlineKinds.x > 0.0 || (plane.facing > 0.25 && hachureOutlineKinds.z > 0.0);
  float nearest = 1e6;
  int last = depth < 1.0 ? 3 : 0;
  int tap = 0;
  for (;;)
  {
    bool trying = tap < 4;
    int stride = trying ? reach : (tap - 4) / 8 + 1;
    // What lies past the border of the picture is unknown: the border stands for it.
    vec2 neighbour = clamp(vec2(pixel + stride * hachureDirection(trying ? tap : (tap - 4) % 8)),
      hachureViewport.xy, hachureViewport.zw);
    ivec2 offset = ivec2(neighbour) - pixel;
    float other = texelFetch(hachureSurfaceDepth, pixel + offset, 0).r;
    float rise = dot(plane.slope, vec2(offset));
    float step = other - depth - rise;
    bool behind = other >= 1.0 || step > slack + 2.0 * abs(rise);
    bool bent = abs(step) > bend && hachureOutlineKinds.y > 0.0;
    if (trying)
    {
      last = depth < 1.0 && (behind || bent) ? 3 + 8 * strides : last;
    }
    else
    {
      float distance = length(vec2(offset)) * (1.0 - 0.5 / float(stride));
      //Hachure::Crease::Impl
      nearest = behind && contours ? min(nearest, distance) : nearest;
    }
    ++tap;
    if (tap > last || nearest < 1.0)
    {
      break;
    }
  }
  return clamp(hachureOutlineShape.x - nearest + 0.5, 0.0, 1.0);
}

//Section Crease
      // Both sides of a crease draw half of the line.
      vec3 otherNormal =
        hachureUnpackNormal(texelFetch(hachureSurfaceNormal, pixel + offset, 0).r);
      nearest = !behind && dot(normal, otherNormal) < hachureOutlineShape.y
        ? min(nearest, distance + 0.5 * hachureOutlineShape.x)
        : nearest;
//Section Call
  color = mix(color, toLinear(hachureOutlineInk.rgb), hachureOutline(pixel, depth, texelFetch(hachureSurfaceNormal, pixel, 0).r) * hachureOutlineInk.a);
