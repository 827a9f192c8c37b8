// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternScreenPass.h"

#include "vtkHachureCompatibility.h"

#include "PatternOutline.h"
#include "PatternPicture.h"
#include "PatternPlaceFS.h"
#include "PatternScreenFS.h"
#include "PatternScreenVS.h"
#include "PatternSurfaceImages.h"
#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPatternCompositor.h"
#include "vtkPatternShaderText.h"
#include "vtkPatternStyle.h"
#include "vtkPatternViewport.h"
#include "vtkPatternWindowResources.h"
#include "vtkShaderProgram.h"

#include <cmath>
#include <sstream>

namespace
{
// Replaces uniforms of a fragment shader by values that the vertices of its rectangle hand on,
// which are the same for all of it. Software OpenGL reads those once, but uniforms for every
// fragment and number by number: a quarter of the time of a drawing in three layers. As many as any
// OpenGL takes.
std::string TakeUniforms(std::string& fragment)
{
  constexpr int vectorsOfAnyOpenGL = 16;
  int free = vectorsOfAnyOpenGL - 1; // one is the texture coordinate's
  std::ostringstream declarations;
  std::ostringstream assignments;
  const std::string keyword = "uniform ";
  for (std::size_t at = fragment.find(keyword); at != std::string::npos;
       at = fragment.find(keyword, at + 1))
  {
    const std::size_t typeEnd = fragment.find(' ', at + keyword.size());
    const std::size_t end = fragment.find(';', at);
    const std::string type = fragment.substr(at + keyword.size(), typeEnd - at - keyword.size());
    const std::string name = fragment.substr(typeEnd + 1, end - typeEnd - 1);
    const bool matrix = type == "mat4";
    const bool vector = type == "vec2" || type == "vec3" || type == "vec4";
    const bool used = fragment.find(name, end) != std::string::npos;
    const int size = matrix ? 4 : 1;
    if ((at > 0 && fragment[at - 1] != '\n') || !(matrix || vector) || !used || size > free)
    {
      continue;
    }
    free -= size;
    const std::string flat = name + "Flat";
    std::ostringstream handedOn;
    handedOn << "flat in " << type << " " << flat << ";\n#define " << name << " " << flat << "\n";
    declarations << "uniform " << type << " " << name << ";\n";
    declarations << "flat out " << type << " " << flat << ";\n";
    assignments << "  " << flat << " = " << name << ";\n";
    fragment.replace(at, end + 1 - at, handedOn.str());
  }
  std::string vertex = PatternScreenVS;
  vtkShaderProgram::Substitute(vertex, "//Hachure::Flat::Dec", declarations.str());
  vtkShaderProgram::Substitute(vertex, "  //Hachure::Flat::Impl", assignments.str());
  return vertex;
}
} // namespace

vtkPatternScreenPass::vtkPatternScreenPass() = default;
vtkPatternScreenPass::~vtkPatternScreenPass() = default;

double vtkPatternScreenPass::OutlineWidth(
  vtkPatternStyle* style, const vtkPatternViewport& viewport)
{
  if (!style->GetOutline())
  {
    return 0.0;
  }
  return viewport.PixelsPerLogical *
    style->GetLengthInPixels(style->GetOutlineWidth(), style->GetOutlineWidthUnit());
}

std::string vtkPatternScreenPass::TextOf(
  vtkPatternStyle* style, vtkPatternCompositor& compositor, bool outline)
{
  std::string text = PatternScreenFS;
  vtkShaderProgram::Substitute(text, "//Hachure::Compose::Dec", compositor.GetShaderText(false));
  vtkShaderProgram::Substitute(text, "  //Hachure::Picture::Impl",
    vtkPattern::ShaderSection(
      PatternPicture, style->GetPaperSource() == vtkPatternStyle::NO_PAPER ? "NoPaper" : "Paper"));
  const vtkPatternAttributes needed = compositor.GetAttributes();
  std::string surfaceDec;
  std::string surfaceImpl;
  if (needed.Runs || needed.Patches)
  {
    surfaceDec += vtkPattern::ShaderSection(PatternSurfaceImages, "PlaceDec");
    surfaceImpl += vtkPattern::ShaderSection(PatternSurfaceImages, "PlaceImpl");
  }
  const std::pair<vtkPatternAttributes::Image, const char*> kinds[] = {
    { vtkPatternAttributes::RUN, "Run" }, { vtkPatternAttributes::PATCH, "Patch" },
    { vtkPatternAttributes::POINT, "Point" }, { vtkPatternAttributes::TEXTURE, "Texture" }
  };
  for (const auto& kind : kinds)
  {
    if (needed.Has(kind.first))
    {
      const std::string name = kind.second;
      surfaceDec += vtkPattern::ShaderSection(PatternSurfaceImages, name + "Dec");
      surfaceImpl += vtkPattern::ShaderSection(PatternSurfaceImages, name + "Impl");
    }
  }
  vtkShaderProgram::Substitute(text, "//Hachure::Surface::Dec", surfaceDec);
  vtkShaderProgram::Substitute(text, "//Hachure::Surface::Impl", surfaceImpl);
  if (outline)
  {
    vtkShaderProgram::Substitute(
      text, "//Hachure::Outline::Dec", vtkPattern::ShaderSection(PatternOutline, "Functions"));
    vtkShaderProgram::Substitute(
      text, "//Hachure::Outline::Impl", vtkPattern::ShaderSection(PatternOutline, "Call"));
    vtkShaderProgram::Substitute(text, "//Hachure::Crease::Impl",
      style->GetOutlineCreases() ? vtkPattern::ShaderSection(PatternOutline, "Crease")
                                 : std::string());
  }
  return text;
}

vtkShaderProgram* vtkPatternScreenPass::Prepare(
  const Scene& scene, vtkPatternCompositor& compositor)
{
  const bool outline = OutlineWidth(scene.Style, scene.Viewport) > 0.0;
  const std::string text = TextOf(scene.Style, compositor, outline);
  if (this->Text != text)
  {
    this->Text = text;
    this->FragmentText = text;
    this->VertexText = TakeUniforms(this->FragmentText);
  }
  vtkShaderProgram* program = this->Quad.Ready(scene.Window, this->VertexText, this->FragmentText);
  if (program && outline)
  {
    SetOutline(scene, program);
    SetUnprojection(scene, program);
  }
  return program;
}

bool vtkPatternScreenPass::Draw(
  const Scene& scene, vtkPatternWindowResources& resources, vtkPatternCompositor& compositor)
{
  vtkShaderProgram* program = this->Prepare(scene, compositor);
  if (!program)
  {
    return false;
  }
  const std::pair<const char*, vtkTextureObject*> images[] = {
    { "hachureSurfaceColor", resources.GetImage(vtkPatternAttributes::COLOR) },
    { "hachureSurfaceTone", resources.GetImage(vtkPatternAttributes::TONE) },
    { "hachureSurfaceNormal", resources.GetImage(vtkPatternAttributes::NORMAL) },
    { "hachureSurfaceDepth", resources.SurfaceDepth },
    { "hachurePatchRecords", scene.PatchRecords },
    { "hachurePatchWeights", scene.PatchWeights },
    { "hachureSurfaceRun", resources.GetImage(vtkPatternAttributes::RUN) },
    { "hachureSurfacePatch", resources.GetImage(vtkPatternAttributes::PATCH) },
    { "hachureSurfacePoint", resources.GetImage(vtkPatternAttributes::POINT) },
    { "hachureSurfaceTexture", resources.GetImage(vtkPatternAttributes::TEXTURE) },
    { "hachureSurfaceTextureSlopes", resources.GetImage(vtkPatternAttributes::TEXTURE_SLOPES) },
  };
  for (const auto& image : images)
  {
    if (image.second &&
      program->IsUniformUsed(image.first)) // the normal, for example, serves the outline alone
    {
      image.second->Activate();
      program->SetUniformi(image.first, image.second->GetTextureUnit());
    }
  }
  compositor.Activate(scene.Frames);
  compositor.SetUniforms(
    program, scene.Style, scene.Viewport, scene.NanColor.data(), scene.Frames.front());
  if (program->IsUniformUsed("hachureDrawnRectangle"))
  {
    const std::array<int, 4>& area = scene.Rectangle;
    const float rectangle[4] = { static_cast<float>(area[0]), static_cast<float>(area[1]),
      static_cast<float>(area[0] + area[2] - 1), static_cast<float>(area[1] + area[3] - 1) };
    program->SetUniform4f("hachureDrawnRectangle", rectangle);
  }
  this->DrawLayers(scene, resources);
  compositor.Deactivate();
  for (const auto& image : images)
  {
    if (image.second && program->IsUniformUsed(image.first))
    {
      image.second->Deactivate();
    }
  }
  return this->Place(scene, resources);
}

namespace
{
// Draws a quad over a rectangle of the framebuffer; blends: over what is there, else instead.
void RenderWithin(vtkOpenGLState* state, const std::array<int, 4>& rectangle, vtkPatternQuad& quad,
  bool blends = false)
{
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglScissor scissor(state);
  state->SetEnumState(GL_BLEND, blends);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglDisable(GL_CULL_FACE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(rectangle[0], rectangle[1], rectangle[2], rectangle[3]);
  quad.Render();
}
} // namespace

// What the attribute stage did not cover fails the depth test: a shader that discards or writes
// depth would be run everywhere first.
void vtkPatternScreenPass::DrawLayers(const Scene& scene, vtkPatternWindowResources& resources)
{
  vtkOpenGLState* state = scene.Window->GetState();
  state->PushFramebufferBindings();
  resources.BeginLayers(scene.Window, scene.Rectangle);
  {
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglDepthMask depthMask(state);
    vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthMask(GL_FALSE);
    state->vtkglDepthFunc(GL_GREATER);
    RenderWithin(state, scene.Rectangle, this->Quad);
  }
  state->PopFramebufferBindings();
}

bool vtkPatternScreenPass::Place(const Scene& scene, vtkPatternWindowResources& resources)
{
  vtkShaderProgram* program = this->PlaceQuad.Ready(scene.Window, {}, PatternPlaceFS);
  if (!program)
  {
    return false;
  }
  resources.DrawnColor->Activate();
  resources.SurfaceDepth->Activate();
  program->SetUniformi("hachureDrawn", resources.DrawnColor->GetTextureUnit());
  program->SetUniformi("hachureSurfaceDepth", resources.SurfaceDepth->GetTextureUnit());
  vtkOpenGLState* state = scene.Window->GetState();
  program->SetUniformf("hachureMostLeftOut", 0.0f);
  if (scene.Style->GetPaperSource() == vtkPatternStyle::NO_PAPER)
  {
    // What is drawn later and lies behind is hidden by what covers most of a pixel: behind the rims
    // of marks one would see what was there before it.
    constexpr float half = 0.5f;
    vtkOpenGLState::ScopedglDepthMask depthMask(state);
    vtkOpenGLState::ScopedglColorMask colorMask(state);
    state->vtkglDepthMask(GL_FALSE);
    RenderWithin(state, scene.Rectangle, this->PlaceQuad, true);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    program->SetUniformf("hachureMostLeftOut", half);
    RenderWithin(state, scene.Rectangle, this->PlaceQuad);
  }
  else
  {
    RenderWithin(state, scene.Rectangle, this->PlaceQuad);
  }
  resources.SurfaceDepth->Deactivate();
  resources.DrawnColor->Deactivate();
  return true;
}

void vtkPatternScreenPass::SetOutline(const Scene& scene, vtkShaderProgram* program)
{
  vtkPatternStyle* style = scene.Style;
  const double* color = style->GetOutlineColor();
  const float ink[4] = { static_cast<float>(color[0]), static_cast<float>(color[1]),
    static_cast<float>(color[2]), 1.0f };
  program->SetUniform4f("hachureOutlineInk", ink);

  constexpr double radiansPerDegree = 3.14159265358979323846 / 180.0;
  // Steps in depth below this part of the object's size are relief, not contours.
  constexpr double slack = 0.004;
  const float shape[3] = { static_cast<float>(OutlineWidth(style, scene.Viewport)),
    static_cast<float>(std::cos(style->GetOutlineCreaseAngle() * radiansPerDegree)),
    static_cast<float>(slack * scene.Actor->GetLength()) };
  program->SetUniform3f("hachureOutlineShape", shape);
  const float kinds[3] = { style->GetOutlineSilhouette() ? 1.0f : 0.0f,
    style->GetOutlineCreases() ? 1.0f : 0.0f, style->GetOutlineBorders() ? 1.0f : 0.0f };
  program->SetUniform3f("hachureOutlineKinds", kinds);
}

void vtkPatternScreenPass::SetUnprojection(const Scene& scene, vtkShaderProgram* program)
{
  const glm::dmat4 projection = vtkPattern::DrawnProjection(scene.Renderer);
  const float depthToView[4] = { static_cast<float>(projection[3][2]),
    static_cast<float>(projection[3][3]), static_cast<float>(projection[2][3]),
    static_cast<float>(projection[2][2]) };
  program->SetUniform4f("hachureDepthToView", depthToView);

  const bool perspective = projection[2][3] != 0.0;
  const std::array<int, 4>& area = scene.Viewport.Drawn;
  float fragmentToView[4];
  for (int axis = 0; axis < 2; ++axis)
  {
    const double shift = perspective ? projection[2][axis] : -projection[3][axis];
    const double size = area[2 + axis];
    const double origin = area[axis];
    fragmentToView[axis] = static_cast<float>(2.0 / (size * projection[axis][axis]));
    fragmentToView[2 + axis] =
      static_cast<float>((-2.0 * origin / size - 1.0 + shift) / projection[axis][axis]);
  }
  program->SetUniform4f("hachureFragmentToView", fragmentToView);
  const float viewport[4] = { static_cast<float>(area[0]), static_cast<float>(area[1]),
    static_cast<float>(area[0] + area[2] - 1), static_cast<float>(area[1] + area[3] - 1) };
  program->SetUniform4f("hachureViewport", viewport);
}

void vtkPatternScreenPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Quad.ReleaseGraphicsResources(window);
  this->PlaceQuad.ReleaseGraphicsResources(window);
}
