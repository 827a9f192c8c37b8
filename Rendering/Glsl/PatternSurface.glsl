// What Hachure adds to VTK's own polydata shader, one section per place it is put in.
// Variables that start with "hachure" are ours; all others are VTK's. K stands for a tone channel,
// LIGHTS for the number of lights, FIRST and LAST for a range of them.

//Section IdsFSDec
uniform samplerBuffer hachurePrimitiveIds; // per primitive: block and triangle that a noise knows it by
vec2 hachureIdsHere = vec2(-1.0);
//Section IdsForward
  hachureIdsHere = texelFetch(hachurePrimitiveIds, gl_PrimitiveID + PrimitiveIDOffset).xy;
//Section PeelFSDec
uniform sampler2D hachureDepthBefore; // window depth of the layer before, of a rectangle
uniform vec2 hachureDepthOrigin;      // its first pixel
//Section PeelFSImpl
  // More than the rounding of 24 bits.
  if (gl_FragCoord.z <=
    texelFetch(hachureDepthBefore, ivec2(gl_FragCoord.xy - hachureDepthOrigin), 0).r + 2.4e-7)
  {
    discard;
  }
//Section PointToneVSDec
in vec2 hachureToneKMC; // x: tone before clamping, y: 1 where the array has a number
out vec2 hachureToneKVSOutput;
//Section PointToneVSImpl
  hachureToneKVSOutput = hachureToneKMC;
//Section PointToneGSDec
in vec2 hachureToneKVSOutput[];
out vec2 hachureToneKGSOutput;
//Section PointToneGSImpl
  hachureToneKGSOutput = hachureToneKVSOutput[i];
//Section PointToneFSDec
in vec2 hachureToneKVSOutput;
//Section PointToneFSImpl
  vec2 hachureArrayK = hachureToneKVSOutput;
//Section CellToneFSDec
uniform samplerBuffer hachureCellToneK; // per primitive: tone before clamping, 1 where there is a number
//Section CellToneFSImpl
  vec2 hachureArrayK = texelFetch(hachureCellToneK, gl_PrimitiveID + PrimitiveIDOffset).xy;
//Section ToneArray
  hachureTone[K] = hachureArrayK.y > 0.999 ? clamp(hachureArrayK.x, 0.0, 1.0) : -1.0;
//Section ToneLit
  hachureTone[K] = hachureLitTone;
//Section ToneLitColor
  hachureTone[K] = clamp(1.0 - hachureLuma(gl_FragData[0].rgb), 0.0, 1.0);
//Section ToneLight
  hachureTone[K] = hachureToneOf(ambientIntensity,
    diffuseIntensity * hachureDiffuseLight(FIRST, LAST, vertexVC.xyz, normalVCVSOutput));
//Section ToneNoLight
  hachureTone[K] = hachureToneOf(ambientIntensity, vec3(0.0));
//Section ToneHighlight
  hachureTone[K] = hachureHighlight(FIRST, LAST, vertexVC.xyz, normalVCVSOutput,
    hachurePowerK > 0.0 ? hachurePowerK : specularPower);
//Section ToneNoHighlight
  hachureTone[K] = 0.0;
//Section ToneLuminance
  hachureTone[K] = clamp(1.0 - hachureLuma(hachureOwnColor), 0.0, 1.0);
//Section HighlightDec
uniform float hachurePowerK; // of the highlight, 0: the surface's own
//Section LightsDec
// Every light of the scene, in its order; those that are switched off are black.
uniform vec4 hachureLightColor[LIGHTS];     // w: 1 = it has a position
uniform vec4 hachureLightDirection[LIGHTS]; // view coordinates; w: cosine of the cone, -1 without
uniform vec4 hachureLightPosition[LIGHTS];  // view coordinates; w: exponent of the cone
uniform vec3 hachureLightAttenuation[LIGHTS];

// Light on a white surface.
vec3 hachureDiffuseLight(int first, int last, vec3 point, vec3 normal)
{
  vec3 sum = vec3(0.0);
  for (int i = first; i < last; ++i)
  {
    vec4 rays = lightRays(point, hachureLightDirection[i], hachureLightPosition[i],
      hachureLightAttenuation[i], hachureLightColor[i].w);
    sum += hachureLightColor[i].rgb * diffuseShare(normal, rays);
  }
  return sum;
}

// Strength of the highlights on a white mirror.
float hachureHighlight(int first, int last, vec3 point, vec3 normal, float power)
{
  vec3 sum = vec3(0.0);
  for (int i = first; i < last; ++i)
  {
    vec4 rays = lightRays(point, hachureLightDirection[i], hachureLightPosition[i],
      hachureLightAttenuation[i], hachureLightColor[i].w);
    sum += hachureLightColor[i].rgb * highlightShare(normal, rays, point, power);
  }
  return clamp(hachureLuma(min(sum, vec3(1.0))), 0.0, 1.0);
}

//Section PointVSDec
uniform vec3 hachureCoordScale; // from VTK's vertex buffer to model coordinates
uniform vec3 hachureCoordShift;
out vec3 hachurePointVSOutput;
//Section PointVSImpl
  hachurePointVSOutput = vertexMC.xyz * hachureCoordScale + hachureCoordShift;
//Section PointGSDec
in vec3 hachurePointVSOutput[];
out vec3 hachurePointGSOutput;
//Section PointGSImpl
  hachurePointGSOutput = hachurePointVSOutput[i];
//Section PointFSDec
in vec3 hachurePointVSOutput;
//Section FacetFSImpl
  vec3 hachureFacetNormal = cross(dFdx(hachurePointVSOutput), dFdy(hachurePointVSOutput));
  hachureFacetNormal /= max(length(hachureFacetNormal), 1e-30);
//Section RunVSDec
uniform samplerBuffer hachureRunOfVertex; // first record of the triangles that end there
flat out float hachureRunVSOutput;
//Section RunVSImpl
  hachureRunVSOutput = texelFetch(hachureRunOfVertex, gl_VertexID).x;
//Section RunGSDec
flat in float hachureRunVSOutput[];
flat out float hachureRunGSOutput;
//Section RunGSImpl
  hachureRunGSOutput = hachureRunVSOutput[2]; // the last vertex tells of the triangle
//Section RunFSDec
flat in float hachureRunVSOutput;
//Section PatchVSDec
uniform samplerBuffer hachurePatchOfVertex; // the patch of its triangles, or -1 - their first record
uniform float hachurePatchBase;             // records of other helpers before those of this one
flat out float hachurePatchVSOutput;
//Section PatchVSImpl
  hachurePatchVSOutput = texelFetch(hachurePatchOfVertex, gl_VertexID).x;
  hachurePatchVSOutput -= hachurePatchVSOutput < 0.0 ? hachurePatchBase : 0.0;
//Section PatchGSDec
flat in float hachurePatchVSOutput[];
flat out float hachurePatchGSOutput;
//Section PatchGSImpl
  hachurePatchGSOutput = hachurePatchVSOutput[2]; // the last vertex tells of the triangle
//Section PatchFSDec
flat in float hachurePatchVSOutput;
//Section TextureVSDec
in vec3 hachureTextureMC; // z: 1 where the block has texture coordinates
out vec3 hachureTextureVSOutput;
//Section TextureVSImpl
  hachureTextureVSOutput = hachureTextureMC;
//Section TextureGSDec
in vec3 hachureTextureVSOutput[];
out vec3 hachureTextureGSOutput;
//Section TextureGSImpl
  hachureTextureGSOutput = hachureTextureVSOutput[i];
//Section TextureFSDec
in vec3 hachureTextureVSOutput;
//Section TextureFSImpl
  vec4 hachureTextureChange =
    vec4(dFdx(hachureTextureVSOutput.st), dFdy(hachureTextureVSOutput.st));

//Section Dec
float hachureLuma(vec3 color)
{
  return dot(color, vec3(0.2126, 0.7152, 0.0722));
}

float hachureToneOf(float ambient, vec3 diffuse)
{
  return clamp(1.0 - hachureLuma(min(vec3(ambient) + diffuse, vec3(1.0))), 0.0, 1.0);
}

// Octahedral map of a unit vector, 12 bits a coordinate in one exactly representable float.
float hachurePackNormal(vec3 n)
{
  vec2 p = n.xy / max(abs(n.x) + abs(n.y) + abs(n.z), 1e-6);
  if (n.z < 0.0)
  {
    p = (1.0 - abs(p.yx)) * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  }
  vec2 q = floor(clamp(p * 0.5 + 0.5, 0.0, 1.0) * 4095.0 + 0.5);
  return q.x * 4096.0 + q.y;
}

//Section BeforeLightBlinnPhong
  // Light a white surface; the surface's own colour is put back behind the lighting.
  vec3 hachureSurfaceColor = diffuseColor;
  diffuseColor = vec3(diffuseIntensity);
//Section AfterLightBlinnPhong
  float hachureLitTone = hachureToneOf(ambientIntensity, diffuse);
  gl_FragData[0].rgb += diffuse * (hachureSurfaceColor / max(diffuseIntensity, 1e-6) - vec3(1.0));
//Section BeforeLightPhysical
  // Physically based shading is not linear in the albedo: the surface keeps its colour, and
  // the tone is that of the picture.
  vec3 hachureSurfaceColor = diffuseColor;
//Section AfterLightPhysical
  float hachureLitTone = clamp(1.0 - hachureLuma(gl_FragData[0].rgb), 0.0, 1.0);
//Section BeforeLightUnlit
  vec3 hachureSurfaceColor = diffuseColor;
//Section AfterLightUnlit
  float hachureLitTone = 0.0; // no light in the scene's model: paper
//Section NormalLit
  vec3 hachureNormal = normalVCVSOutput;
//Section NormalUnlit
  vec3 hachureNormal = vec3(0.0, 0.0, 1.0);
//Section EdgesOn
  float hachureEdge = emix;
//Section EdgesBlended
  float hachureEdge = emix * edgeOpacity;
//Section EdgesOff
  float hachureEdge = 0.0;
//Section ToneStart
  vec4 hachureTone = vec4(0.0);
//Section OwnColor
  vec3 hachureOwnColor = diffuseIntensity > 0.0 ? hachureSurfaceColor / diffuseIntensity
                                                : ambientColor / max(ambientIntensity, 1e-6);
//Section FlatPaper
  gl_FragData[0].rgb = hachureOwnColor;

//Section Attributes
  float hachureLeastTone =
    min(min(hachureTone.x, hachureTone.y), min(hachureTone.z, hachureTone.w));
  // Where a tone's data has no number, a quarter of it.
  gl_FragData[0].a = (1.0 - 0.5 * hachureEdge) * (hachureLeastTone < 0.0 ? 0.25 : 1.0);
  gl_FragData[1] = hachureTone;
//Section SurroundingsFSDec
uniform float hachureNotDrawn; // 1 where another process draws the block
//Section SurroundingsAttribute
  // VTK discards what has no alpha at all.
  gl_FragData[0].a = hachureNotDrawn > 0.5 ? 0.03 : gl_FragData[0].a;
//Section NoColors
  // Nobody looks at them, and the lighting that would make them falls away: a third of the time of a
  // surface of small triangles in software OpenGL.
  gl_FragData[0].rgb = vec3(0.0);
//Section NormalAttribute
  gl_FragData[IMAGE] = vec4(hachurePackNormal(hachureNormal), 0.0, 0.0, 1.0);
//Section RunAttribute
  gl_FragData[IMAGE] = vec4(hachureRunVSOutput, 0.0, 0.0, 1.0);
//Section PatchAttribute
  gl_FragData[IMAGE] = vec4(hachurePatchVSOutput, 0.0, 0.0, 1.0);
//Section PointAttribute
  gl_FragData[IMAGE] = vec4(hachurePointVSOutput, hachurePackNormal(hachureFacetNormal));
//Section TextureAttribute
  gl_FragData[IMAGE] = vec4(hachureTextureVSOutput, 1.0);
//Section SlopesAttribute
  gl_FragData[IMAGE] = hachureTextureChange;
//Section RunForward
  hachureSeeRun(hachureRunVSOutput, hachurePointVSOutput - hachurePatchOrigin);
//Section PatchForward
  hachureSeeTriangle(hachurePatchVSOutput, hachurePointVSOutput - hachurePatchOrigin);
//Section PointForward
  hachureSeeSurface(hachurePointVSOutput, hachureFacetNormal);
//Section TextureForward
  hachureSeeTexture(hachureTextureVSOutput, hachureTextureChange);
//Section Forward
  gl_FragData[0].rgb = mix(
    fromLinear(
      hachureCompose(hachureLogicalPosition(gl_FragCoord.xy), gl_FragData[0].rgb, hachureTone)),
    gl_FragData[0].rgb, hachureEdge);
//Section ForwardNoPaper
  // On black and on white tells what shows through.
  vec3 hachureOwn = gl_FragData[0].rgb;
  hachurePaperHere = vec3(0.0);
  vec3 hachureOnBlack = mix(
    fromLinear(hachureCompose(hachureLogicalPosition(gl_FragCoord.xy), hachureOwn, hachureTone)),
    hachureOwn, hachureEdge);
  hachurePaperHere = vec3(1.0);
  vec3 hachureOnWhite = mix(
    fromLinear(hachureCompose(hachureLogicalPosition(gl_FragCoord.xy), hachureOwn, hachureTone)),
    hachureOwn, hachureEdge);
  float hachureHides =
    1.0 - clamp(dot(hachureOnWhite - hachureOnBlack, vec3(1.0 / 3.0)), 0.0, 1.0);
  gl_FragData[0] = vec4(hachureOnBlack / max(hachureHides, 0.001), gl_FragData[0].a * hachureHides);
