//VTK::System::Dec
//VTK::Output::Dec

// Keeps the visibility of a sample only where its own object is what the finished picture shows; and
// tells the depth of that, by which other processes' pictures of the scene may hide it.

in vec2 texCoord;

uniform sampler2D ownVisibility; // see PatternVisibilityOwnFS.glsl
uniform sampler2D depthImage;    // window depth of the finished picture

void main()
{
  vec4 own = texelFetch(ownVisibility, ivec2(texCoord * vec2(textureSize(ownVisibility, 0))), 0);
  float depth = texelFetch(depthImage, ivec2(own.zw), 0).r;
  float code = floor(clamp(depth, 0.0, 1.0) * 16777215.0);
  vec3 bytes = vec3(floor(code / 65536.0), mod(floor(code / 256.0), 256.0), mod(code, 256.0));
  gl_FragData[0] = vec4(abs(own.y - depth) <= 2e-6 ? own.x : 0.0, bytes / 255.0);
}
