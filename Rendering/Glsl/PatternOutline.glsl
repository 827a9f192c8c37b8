// Contours found in the attribute images: where the surface ends in front of something farther
// (silhouettes, borders) and where it bends sharply (creases). Lines lie inside the surface.

uniform vec4 hachureOutlineInk;      // rgb display-referred, a: opacity
uniform vec4 hachureOutlineShape;    // width in framebuffer pixels, cos of the crease angle, depth slack in view units, pixels to march
uniform vec3 hachureOutlineKinds;    // 1 where silhouettes, creases, borders are drawn
uniform vec4 hachureDepthToView;     // view z = (x - ndc * y) / (ndc * z - w), ndc = 2 depth - 1
uniform vec4 hachureFragmentToView;  // view xy at unit |clip w|: fragment * xy + zw
uniform vec4 hachureRectangle;       // pixels the attribute stage covered: lower left, upper right

vec3 hachureUnpackNormal(float packedNormal)
{
  float x = floor(packedNormal / 4096.0);
  vec2 p = vec2(x, packedNormal - x * 4096.0) / 4095.0 * 2.0 - 1.0;
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  if (n.z < 0.0)
  {
    n = vec3((1.0 - abs(n.y)) * (n.x < 0.0 ? -1.0 : 1.0),
      (1.0 - abs(n.x)) * (n.y < 0.0 ? -1.0 : 1.0), n.z);
  }
  return normalize(n);
}

float hachureViewZ(float depth)
{
  float ndc = 2.0 * depth - 1.0;
  return (hachureDepthToView.x - ndc * hachureDepthToView.y) /
    (ndc * hachureDepthToView.z - hachureDepthToView.w);
}

// Direction of the view ray through a fragment at unit depth (perspective), in view coordinates.
vec2 hachureViewRay(ivec2 pixel)
{
  return (vec2(pixel) + 0.5) * hachureFragmentToView.xy + hachureFragmentToView.zw;
}

// Coverage of the outline at a pixel.
float hachureOutline(ivec2 pixel, float depth, float packedNormal)
{
  vec3 normal = hachureUnpackNormal(packedNormal);
  float z = hachureViewZ(depth);
  float perspective = hachureDepthToView.z == 0.0 ? 0.0 : 1.0;
  vec2 ray = hachureViewRay(pixel);
  vec3 point = vec3(ray * mix(1.0, -z, perspective), z);
  vec3 toEye = mix(vec3(0.0, 0.0, 1.0), -normalize(point), perspective);
  float facing = dot(normal, toEye);
  float contour = facing < 0.25 ? hachureOutlineKinds.x : max(hachureOutlineKinds.z, hachureOutlineKinds.x);
  float nearest = 1e6;
  for (int direction = 0; direction < 9; ++direction)
  {
    ivec2 offset = ivec2((direction / 3) - 1, (direction % 3) - 1);
    if (offset == ivec2(0))
    {
      continue;
    }
    float stride = length(vec2(offset));
    for (int k = 1; k <= int(hachureOutlineShape.w); ++k)
    {
      float distance = stride * float(k) - 0.5 * stride;
      if (distance > hachureOutlineShape.x + 0.5 || distance >= nearest)
      {
        break;
      }
      ivec2 other = pixel + k * offset;
      bool inside = all(greaterThanEqual(vec2(other), hachureRectangle.xy)) &&
        all(lessThan(vec2(other), hachureRectangle.zw));
      float otherDepth = inside ? texelFetch(hachureSurfaceDepth, other, 0).r : 1.0;
      if (otherDepth >= 1.0)
      {
        nearest = contour > 0.0 ? min(nearest, distance) : nearest;
        break;
      }
      // Depth this surface would have there if it went on flat.
      vec2 otherRay = hachureViewRay(other);
      vec3 along = mix(vec3(0.0, 0.0, -1.0), vec3(otherRay, -1.0), perspective);
      vec3 start = mix(vec3(otherRay, 0.0), vec3(0.0), perspective);
      float slope = dot(normal, along);
      float reach = dot(normal, point - start) / (slope < -0.05 ? slope : -0.05);
      float expected = start.z + along.z * reach;
      float otherZ = hachureViewZ(otherDepth);
      float slack = hachureOutlineShape.z + 2.0 * abs(expected - z);
      if (expected - otherZ > slack)
      {
        nearest = contour > 0.0 ? min(nearest, distance) : nearest;
        break;
      }
      if (hachureOutlineKinds.y > 0.0 && abs(expected - otherZ) <= slack &&
        dot(normal, hachureUnpackNormal(texelFetch(hachureSurfaceData, other, 0).a)) <
          hachureOutlineShape.y)
      {
        nearest = min(nearest, distance + 0.5 * hachureOutlineShape.x);
        break;
      }
    }
  }
  return clamp(hachureOutlineShape.x - nearest + 0.5, 0.0, 1.0);
}

//Section Call
  float hachureLine = hachureOutline(pixel, depth, data.a) * hachureOutlineInk.a;
  color = fromLinear(mix(toLinear(color), toLinear(hachureOutlineInk.rgb), hachureLine));
