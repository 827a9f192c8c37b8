//VTK::System::Dec
//VTK::Output::Dec

// Fuzzy visibility of surface samples (Breslav et al. 2007, section 3.1), one fragment a sample:
// compares each sample with the point of its own object that is seen at its pixel. Writes the
// visibility, the own window depth there (2 outside the picture) and the pixel.

in vec2 texCoord;
flat in mat4 toFragment;   // from sample positions to clip coordinates in pixels of the framebuffer
flat in mat4 fromFragment; // from pixel and depth to sample positions
flat in vec4 lastFragment; // of the viewport: first pixels (xy), behind the last ones (zw)

uniform sampler2D samplePositions; // xyz: model coordinates about the object's centre, w: spacing
uniform sampler2D depthImage;      // window depth of the own attribute stage

void main()
{
  ivec2 texel = ivec2(texCoord * vec2(textureSize(samplePositions, 0)));
  vec4 sampled = texelFetch(samplePositions, texel, 0);
  vec4 clip = toFragment * vec4(sampled.xyz, 1.0);
  vec2 window = clip.xy / max(clip.w, 1e-20);
  bool inside = clip.w > 0.0 && all(greaterThanEqual(window, lastFragment.xy)) &&
    all(lessThan(window, lastFragment.zw));
  vec2 pixel = floor(clamp(window, lastFragment.xy, lastFragment.zw - 1.0));
  float depth = texelFetch(depthImage, ivec2(pixel), 0).r;
  vec4 seen = fromFragment * vec4(pixel + 0.5, depth, 1.0);
  vec3 place = seen.xyz / seen.w;
  // A pixel may be coarser than the spacing: then one pixel is the unit.
  vec3 toNextPixel = (fromFragment[0].xyz - fromFragment[0].w * place) / seen.w;
  float unit = max(0.25 * sampled.w, length(toNextPixel));
  float visibility = 1.0 - smoothstep(unit, 2.0 * unit, length(place - sampled.xyz));
  gl_FragData[0] = vec4(inside && depth < 1.0 ? visibility : 0.0, inside ? depth : 2.0, pixel);
}
