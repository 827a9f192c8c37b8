// The surface's linear colour at another position of the picture, for marks that are larger than a
// pixel.

//Section Images
uniform vec4 hachureDrawnRectangle; // of the attribute images: first and last fragment

// Where nothing of this object is seen: that of this pixel.
vec3 hachureColorAt(vec2 position)
{
  vec2 fragment = floor((position - hachurePixelMap.zw) / hachurePixelMap.xy);
  vec2 inside = clamp(fragment, hachureDrawnRectangle.xy, hachureDrawnRectangle.zw);
  vec4 there = texelFetch(hachureSurfaceColor, ivec2(inside), 0);
  bool seen = there.a > 0.0 && all(equal(inside, fragment));
  return seen ? toLinear(there.rgb) : hachureSurfaceHere;
}
//Section Forward
// A translucent surface knows its own pixel alone.
vec3 hachureColorAt(vec2 position)
{
  return hachureSurfaceHere;
}
