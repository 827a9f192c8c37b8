//VTK::System::Dec
//VTK::Output::Dec

// Fuzzy visibility of surface samples (Breslav et al. 2007, section 3.1), one fragment a sample.
// Own stage: compares each sample with the point of its own object that is seen at its pixel.
// Scene stage: keeps it only where that object is what the finished picture shows.

in vec2 texCoord;

uniform sampler2D samplePositions; // xyz: model coordinates about the object's centre, w: spacing
uniform sampler2D depthImage;      // window depth: own attribute stage, or the finished picture
uniform sampler2D ownVisibility;   // scene stage: r visibility, g own window depth at the pixel
uniform int sceneStage;
uniform mat4 modelToClip;
uniform mat4 clipToModel;
uniform vec4 viewport; // framebuffer pixels: x, y, width, height

void main()
{
  ivec2 texel = ivec2(texCoord * vec2(textureSize(samplePositions, 0)));
  vec4 position = texelFetch(samplePositions, texel, 0);
  vec4 clip = modelToClip * vec4(position.xyz, 1.0);
  gl_FragData[0] = vec4(0.0, 2.0, 0.0, 1.0);
  vec2 window = (clip.xy / max(clip.w, 1e-20) * 0.5 + 0.5) * viewport.zw;
  if (clip.w > 0.0 && all(greaterThanEqual(window, vec2(0.0))) && all(lessThan(window, viewport.zw)))
  {
    ivec2 pixel = ivec2(viewport.xy + window);
    float depth = texelFetch(depthImage, pixel, 0).r;
    if (sceneStage == 1)
    {
      vec2 own = texelFetch(ownVisibility, texel, 0).xy;
      gl_FragData[0].r = abs(own.y - depth) <= 2e-6 ? own.x : 0.0;
    }
    else if (depth < 1.0)
    {
      vec2 center = floor(window) + 0.5;
      vec4 seen = clipToModel * vec4(vec3(center / viewport.zw, depth) * 2.0 - 1.0, 1.0);
      vec4 beside = clipToModel *
        vec4(vec3((center + vec2(1.0, 0.0)) / viewport.zw, depth) * 2.0 - 1.0, 1.0);
      // A pixel may be coarser than the spacing: then one pixel is the unit.
      float unit = max(0.25 * position.w, length(beside.xyz / beside.w - seen.xyz / seen.w));
      float apart = length(seen.xyz / seen.w - position.xyz);
      gl_FragData[0] = vec4(1.0 - smoothstep(unit, 2.0 * unit, apart), depth, 0.0, 1.0);
    }
  }
}
