// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternMapper.h"

#include "vtkHachureCompatibility.h"

#include "AnchoredPatterns.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCameraInterpolator.h"
#include "vtkColorTransferFunction.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLookupTable.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPatternBlocks.h"
#include "vtkPatternMapperHelper.h"
#include "vtkPatternMapperInternals.h"
#include "vtkPatternNumberBuffer.h"
#include "vtkPatternStyle.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkShaderProgram.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <sstream>

vtkStandardNewMacro(vtkPatternMapper);

namespace
{
// Puts an injector into an actor's render passes as long as it lives; alone: in place of the
// others.
class ScopedInjector
{
public:
  ScopedInjector(vtkActor* actor, vtkPatternShaderInjector* injector, bool alone = false)
    : Actor(actor)
  {
    if (!actor->GetPropertyKeys())
    {
      vtkNew<vtkInformation> keys;
      actor->SetPropertyKeys(keys);
    }
    vtkInformation* keys = actor->GetPropertyKeys();
    auto* passes = vtkOpenGLRenderPass::RenderPasses();
    for (int i = 0; i < passes->Length(keys); ++i)
    {
      this->Others.emplace_back(passes->Get(keys, i));
    }
    if (alone)
    {
      keys->Remove(passes);
    }
    passes->Append(keys, injector);
  }
  ~ScopedInjector()
  {
    vtkInformation* keys = this->Actor->GetPropertyKeys();
    auto* passes = vtkOpenGLRenderPass::RenderPasses();
    keys->Remove(passes);
    for (vtkObjectBase* other : this->Others)
    {
      passes->Append(keys, other);
    }
  }
  ScopedInjector(const ScopedInjector&) = delete;
  ScopedInjector& operator=(const ScopedInjector&) = delete;

private:
  vtkActor* Actor;
  std::vector<vtkSmartPointer<vtkObjectBase>> Others;
};

vtkPatternLayerPainter::Scene PainterScene(vtkRenderer* renderer, vtkActor* actor,
  const vtkPatternViewport& viewport, vtkPatternStyle* style, const double bounds[6],
  const glm::dvec3& patchOrigin)
{
  const glm::dmat4 projection = vtkPattern::DrawnProjection(renderer);
  const glm::dmat4 modelToView = vtkPattern::ModelView(renderer, actor);
  vtkPatternLayerPainter::Scene scene;
  scene.PixelsPerLogical = viewport.PixelsPerLogical;
  scene.DotsPerInch = style->GetDotsPerInch();
  scene.FinalQuality = style->GetFinalQuality();
  scene.ModelToClip = projection * modelToView;
  scene.PixelsPerModelUnit = 0.5 * viewport.Drawn[3] * std::abs(projection[1][1]) *
    std::cbrt(std::abs(glm::determinant(glm::dmat3(modelToView))));
  const vtkBoundingBox box(bounds);
  scene.ModelDiagonal = box.IsValid() ? box.GetDiagonalLength() : 0.0;
  scene.PatchOrigin = patchOrigin;
  return scene;
}
} // namespace

vtkPatternMapper::vtkPatternMapper()
  : Style(vtkSmartPointer<vtkPatternStyle>::New())
  , PatchArrayName(vtkPatternPatches::DefaultArrayName())
  , Internal(std::make_unique<Internals>())
{
}

vtkPatternMapper::~vtkPatternMapper() = default;

void vtkPatternMapper::SetStyle(vtkPatternStyle* style)
{
  if (this->Style != style)
  {
    this->Style = style;
    this->Modified();
  }
}

vtkPatternStyle* vtkPatternMapper::GetStyle()
{
  return this->Style;
}

void vtkPatternMapper::SetTrackedMapper(vtkPatternMapper* mapper)
{
  if (this->TrackedMapper != mapper)
  {
    this->TrackedMapper = mapper == this ? nullptr : mapper;
    this->Modified();
  }
}

vtkPatternMapper* vtkPatternMapper::GetTrackedMapper()
{
  return this->TrackedMapper;
}

void vtkPatternMapper::SetCameraPath(vtkCameraInterpolator* path)
{
  if (this->CameraPath != path)
  {
    this->CameraPath = path;
    this->Modified();
  }
}

vtkCameraInterpolator* vtkPatternMapper::GetCameraPath()
{
  return this->CameraPath;
}

void vtkPatternMapper::AddKeyTime(double time)
{
  this->Internal->KeyTimes.push_back(time);
  this->Modified();
}

void vtkPatternMapper::RemoveAllKeyTimes()
{
  this->Internal->KeyTimes.clear();
  this->Modified();
}

void vtkPatternMapper::SetPatchArrayName(const std::string& name)
{
  if (this->PatchArrayName != name)
  {
    this->PatchArrayName = name;
    this->Modified();
  }
}

std::string vtkPatternMapper::GetPatchArrayName()
{
  return this->PatchArrayName;
}

void vtkPatternMapper::SetVelocityArrayName(const std::string& name)
{
  if (this->VelocityArrayName != name)
  {
    this->VelocityArrayName = name;
    this->Modified();
  }
}

std::string vtkPatternMapper::GetVelocityArrayName()
{
  return this->VelocityArrayName;
}

const vtkPatternPatches& vtkPatternMapper::GetPatches() const
{
  return this->Internal->Patches;
}

vtkPatternPatchRecords& vtkPatternMapper::GetPatchRecords()
{
  return this->Internal->PatchRecords;
}

glm::dvec3 vtkPatternMapper::GetPatchOrigin() const
{
  return this->Internal->PatchOrigin;
}

const vtkPatternToneChannels& vtkPatternMapper::GetToneChannels() const
{
  return this->Internal->Channels;
}

#ifdef VTK_PATTERN_MAPPER_HAS_DELEGATOR
vtkCompositePolyDataMapperDelegator* vtkPatternMapper::CreateADelegator()
{
  return vtkPatternMapperDelegator::New();
}
#else
vtkPatternHelperBase* vtkPatternMapper::CreateHelper()
{
  return vtkPatternMapperHelper::New();
}

void vtkPatternMapper::CopyMapperValuesToHelper(vtkPatternHelperBase* helper)
{
  this->Superclass::CopyMapperValuesToHelper(helper);
  if (helper->GetMTime() < this->Internal->ChannelTime.GetMTime())
  {
    helper->Modified(); // other tone arrays: other buffers and shaders
  }
}
#endif

std::vector<hachure::PatternFrame> vtkPatternMapper::AnchoredFrames(
  const hachure::TrackedSamples& samples, const hachure::ViewProjection& view,
  vtkRenderer* renderer)
{
  const hachure::TrackerOptions options = vtkPatternViewContext::OptionsOf(this->Style);
  if (!this->CameraPath || this->CameraPath->GetNumberOfCameras() == 0)
  {
    return hachure::anchoredFrames(samples, view, options);
  }
  // The path moves the camera; what the projection and the actor do is taken from this frame.
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(renderer->GetActiveCamera());
  const glm::dmat4 modelToWorld =
    glm::inverse(vtkPattern::ToGlm(renderer->GetActiveCamera()->GetModelViewTransformMatrix())) *
    view.modelToView;
  const double aspect = view.viewportSize.x / view.viewportSize.y;
  const auto path = [&](double time)
  {
    this->CameraPath->InterpolateCamera(time, camera);
    hachure::TrackedScene scene;
    scene.samples = samples;
    scene.view = view;
    scene.view.modelToView =
      vtkPattern::ToGlm(camera->GetModelViewTransformMatrix()) * modelToWorld;
    scene.view.viewToClip =
      vtkPattern::ToGlm(camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0));
    return scene;
  };
  return hachure::replayFrames(
    path, this->Internal->KeyTimes, this->AnimationTime, this->ReplayStep, options);
}

bool vtkPatternMapper::DrawsPatterns(vtkRenderer* renderer, vtkActor* actor)
{
  return this->Style && !renderer->GetSelector() &&
    actor->GetProperty()->GetRepresentation() == VTK_SURFACE &&
    vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) != nullptr;
}

// ParaView gives the tracked mapper its surface with the first picture of full detail.
vtkPatternMapper* vtkPatternMapper::GetSteeringMapper()
{
  if (!this->TrackedMapper)
  {
    return this;
  }
  const auto blocks = vtkPattern::Blocks(this->TrackedMapper->GetSurfaceData());
  const bool known = std::any_of(blocks.begin(), blocks.end(),
    [](const vtkPattern::Block& block)
    { return block.Data->GetNumberOfPolys() > 0 || block.Data->GetNumberOfStrips() > 0; });
  return known ? this->TrackedMapper.Get() : this;
}

void vtkPatternMapper::Report(const std::string& error, std::string& reported)
{
  if (!error.empty() && error != reported)
  {
    vtkErrorMacro(<< error);
  }
  reported = error;
}

void vtkPatternMapper::UpdateChannels()
{
  const vtkPatternToneChannels old = this->Internal->Channels;
  this->Internal->ChannelError.clear();
  this->Internal->Channels.Collect(
    this->Style, this->GetInputDataObject(0, 0), this->Internal->ChannelError);
  if (!(this->Internal->Channels == old))
  {
    this->Internal->ChannelTime.Modified();
    this->Modified();
  }
}

vtkPatternAttributes vtkPatternMapper::Attributes(const Drawing& drawing) const
{
  vtkPatternAttributes attributes = drawing.Part.Compositor.GetAttributes();
  attributes.Surroundings = this->GetHasSurroundings();
  return attributes;
}

void vtkPatternMapper::SetDrawsLegend(bool legend)
{
  this->Internal->Channels.SetStandIns(legend);
}

void vtkPatternMapper::UpdatePatches(std::string& error)
{
  const unsigned long before = this->Internal->Patches.GetVersion();
  this->Internal->Patches.Collect(this->GetSurfaceData(), this->PatchArrayName, error);
  if (this->Internal->Patches.GetVersion() != before || this->Internal->PatchesBeginAnew)
  {
    this->Internal->PatchesBeginAnew = false;
    double center[3] = { 0.0, 0.0, 0.0 };
    const vtkBoundingBox box(this->GetBounds());
    if (box.IsValid())
    {
      box.GetCenter(center);
    }
    this->Internal->PatchOrigin = { center[0], center[1], center[2] };
    this->Internal->ChannelTime.Modified();
    this->Modified();
  }
}

void vtkPatternMapper::UpdateTextureCoordinates(bool needed)
{
  if (needed && !this->Internal->UsesTextureCoordinates)
  {
    this->Internal->UsesTextureCoordinates = true;
    this->Internal->ChannelTime.Modified();
    this->Modified();
  }
}

bool vtkPatternMapper::GetUsesTextureCoordinates() const
{
  return this->Internal->UsesTextureCoordinates;
}

void vtkPatternMapper::SetInputOrigin(vtkAlgorithm* algorithm)
{
  if (algorithm != this->InputOrigin)
  {
    this->InputOrigin = algorithm;
    this->Modified();
  }
}

vtkAlgorithm* vtkPatternMapper::GetInputOrigin()
{
  return this->InputOrigin;
}

void vtkPatternMapper::Render(vtkRenderer* renderer, vtkActor* actor)
{
  if (!this->GetInputAlgorithm())
  {
    this->Report("input: none is connected; expected polydata or a composite of polydata",
      this->Internal->ReportedStyle);
    return;
  }
  if (this->GetInputDataObject(0, 0))
  {
    this->UpdateSurroundings();
  }
  if (!this->DrawsPatterns(renderer, actor))
  {
    this->Superclass::Render(renderer, actor);
    return;
  }
  if (!this->Static)
  {
    this->GetInputAlgorithm()->Update();
  }
  vtkPatternViewport viewport(renderer, this->Style->GetPixelScale());
  if (!this->GetInputDataObject(0, 0) || viewport.Drawn[2] < 1 || viewport.Drawn[3] < 1)
  {
    this->Superclass::Render(renderer, actor);
    return;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (!this->TrackedMapper && !viewport.IsTile)
  {
    vtkPatternViewContext::Get(renderer)->BeginFrame(this, actor);
  }
  this->UpdateChannels();
  this->UpdateSurroundings();
  std::string error = this->Internal->ChannelError;
  this->UpdatePatches(error);
  WindowPart& part = this->Internal->Windows[window];
  part.Resources = vtkPatternWindowResources::Get(window);
  double bounds[6];
  this->GetBounds(bounds);
  part.Compositor.Update(this->Style, this->Internal->Channels, this->Internal->Patches, window,
    PainterScene(renderer, actor, viewport, this->Style, bounds, this->Internal->PatchOrigin),
    error);
  this->UpdateTextureCoordinates(
    part.Compositor.GetAttributes().Has(vtkPatternAttributes::TEXTURE));
  this->UpdateRuns(part.Compositor.GetAttributes().Runs);
  this->Report(error, this->Internal->ReportedStyle);
  this->Internal->Lights.Collect(renderer);
  this->Report(
    this->Internal->Channels.MissingLight(static_cast<int>(this->Internal->Lights.GetCount())),
    this->Internal->ReportedLights[renderer]);

  const bool lowDetail = this->TrackedMapper != nullptr;
  vtkPatternMapper* steering = this->GetSteeringMapper();
  auto* track =
    vtkPatternViewContext::Get(renderer)->Advance(steering, actor, viewport, steering != this);
  this->Report(track->Problem, this->Internal->ReportedProblem);
  part.Compositor.SetOctaves(track->Octaves);
  // One eye's picture tells nothing new of a view that was measured already.
  const bool otherEye =
    window->GetStereoRender() && (!renderer->GetActiveCamera()->GetLeftEye() || !track->Moved);
  Drawing drawing{ renderer, actor, window, part, viewport, track,
    !lowDetail && !otherEye && !viewport.IsTile };
  if (actor->IsRenderingTranslucentPolygonalGeometry())
  {
    this->RenderForward(drawing);
  }
  else
  {
    this->RenderOpaque(drawing);
  }
  // Some are known only when all is drawn. A view that comes and goes is told of once.
  const std::string note = part.Compositor.GetNote();
  if (!note.empty() && note != this->Internal->ReportedNote)
  {
    vtkWarningMacro(<< note);
    this->Internal->ReportedNote = note;
  }
}

void vtkPatternMapper::RenderForward(Drawing& drawing)
{
  // VTK draws translucent surfaces into images of the viewport alone.
  int viewport[4];
  glGetIntegerv(GL_VIEWPORT, viewport);
  drawing.Viewport.MoveTo(viewport[0], viewport[1]);
  const std::array<double, 3> nanColor = this->GetNanColor();
  const glm::dmat4 modelToClip = vtkPattern::DrawnProjection(drawing.Renderer) *
    vtkPattern::ModelView(drawing.Renderer, drawing.Actor);
  drawing.Rectangle = this->Covered(drawing, this->DrawnBounds(), 2);
  drawing.Whole = drawing.Rectangle;
  if (!this->DrawFields(drawing, modelToClip, true))
  {
    this->Superclass::Render(drawing.Renderer, drawing.Actor);
    return;
  }
  this->StoreStipples(drawing);
  this->UpdatePrimitiveIds(drawing.Part.Compositor.GetAttributes().PrimitiveIds);
  vtkPatternShaderInjector* injector = this->Internal->ForwardInjector;
  injector->Configure(vtkPatternShaderInjector::FORWARD, this->Internal->Channels,
    this->Internal->Lights.GetCount(), this->Style->GetPaperSource() == vtkPatternStyle::FLAT,
    this->Attributes(drawing), drawing.Part.Compositor.GetShaderText(true));
  injector->UniformSetter = [&](vtkShaderProgram* program)
  {
    this->Internal->Lights.SetUniforms(program, this->Internal->Channels);
    drawing.Part.Compositor.SetUniforms(
      program, this->Style, drawing.Viewport, nanColor.data(), drawing.Track->Frames[0]);
  };
  drawing.Part.Compositor.Activate(drawing.Track->Frames);
  {
    const ScopedInjector scoped(drawing.Actor, injector);
    this->Superclass::Render(drawing.Renderer, drawing.Actor);
  }
  drawing.Part.Compositor.Deactivate();
  injector->UniformSetter = nullptr;
}

void vtkPatternMapper::RenderOpaque(Drawing& drawing)
{
  vtkPatternWindowResources& resources = *drawing.Part.Resources;
  if (!resources.Prepare(drawing.Window, drawing.Part.Compositor.GetAttributes()))
  {
    this->Report("the window's OpenGL cannot draw to the attribute images; expected floating "
                 "point colour attachments (OpenGL 3.2)",
      this->Internal->ReportedDevice);
    this->Superclass::Render(drawing.Renderer, drawing.Actor);
    return;
  }
  const glm::dmat4 modelToClip = vtkPattern::DrawnProjection(drawing.Renderer) *
    vtkPattern::ModelView(drawing.Renderer, drawing.Actor);
  // Outlines look as far around a pixel as they are wide.
  const double outline = vtkPatternScreenPass::OutlineWidth(this->Style, drawing.Viewport);
  const int margin = 2 + static_cast<int>(std::ceil(1.5 * outline));
  drawing.Rectangle = this->Covered(drawing, this->DrawnBounds(), margin);
  drawing.Whole = this->Covered(drawing, this->GetBounds(), margin);
  if (drawing.Whole[2] > 0 && drawing.Whole[3] > 0)
  {
    vtkPatternShaderInjector* injector = this->Internal->AttributeInjector;
    injector->Configure(vtkPatternShaderInjector::ATTRIBUTES, this->Internal->Channels,
      this->Internal->Lights.GetCount(), this->Style->GetPaperSource() == vtkPatternStyle::FLAT,
      this->Attributes(drawing), std::string());
    injector->UniformSetter = [this](vtkShaderProgram* program)
    { this->Internal->Lights.SetUniforms(program, this->Internal->Channels); };
    this->DrawAttributes(drawing, injector);
    if (this->Internal->PatchRecords.IsDrawnWrong())
    {
      this->DrawAttributes(drawing, injector);
    }
    this->UploadPatchRecords(drawing);
    this->DrawScreen(drawing, modelToClip);
    if (drawing.Measures)
    {
      drawing.Track->Rectangle = drawing.Whole;
      drawing.Track->Visibility.SetShared(this->Controller != nullptr);
      drawing.Track->Visibility.MeasureOwn(drawing.Window, drawing.Track->Samples, modelToClip,
        drawing.Viewport.Drawn, resources.SurfaceDepth);
    }
  }
  if (this->HasRemainder(drawing.Actor))
  {
    this->Stage = DrawStage::Remainder;
    this->Superclass::Render(drawing.Renderer, drawing.Actor);
    this->Stage = DrawStage::Stock;
  }
}

// All that is drawn by pixels, where this process draws some of them.
void vtkPatternMapper::DrawScreen(Drawing& drawing, const glm::dmat4& modelToClip)
{
  if (drawing.Rectangle[2] < 1 || drawing.Rectangle[3] < 1)
  {
    return;
  }
  this->DrawFields(drawing, modelToClip, false);
  this->StoreStipples(drawing);
  const vtkPatternScreenPass::Scene scene = { drawing.Renderer, drawing.Actor, drawing.Window,
    this->Style, drawing.Viewport, drawing.Rectangle, drawing.Track->Frames, this->GetNanColor(),
    drawing.Part.PatchRecords.Shapes.Texture, drawing.Part.PatchRecords.Weights.Texture };
  if (!drawing.Part.ScreenPass.Draw(scene, *drawing.Part.Resources, drawing.Part.Compositor))
  {
    this->Report(
      "the shader of the style does not compile on this OpenGL", this->Internal->ReportedDevice);
  }
}

void vtkPatternMapper::UploadPatchRecords(Drawing& drawing)
{
  const vtkPatternPatchRecords& records = this->Internal->PatchRecords;
  const bool patches = drawing.Part.Compositor.GetAttributes().Patches;
  if (patches && drawing.Part.PatchVersion != records.GetVersion())
  {
    drawing.Part.PatchRecords.Upload(drawing.Window, records.All());
    drawing.Part.PatchVersion = records.GetVersion();
  }
}

// With the depth test and no blending, whatever the pass does in which this happens.
void vtkPatternMapper::DrawAttributes(Drawing& drawing, vtkPatternShaderInjector* injector)
{
  vtkOpenGLState* state = drawing.Window->GetState();
  state->PushFramebufferBindings();
  {
    vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
    vtkOpenGLState::ScopedglScissor scissor(state);
    vtkOpenGLState::ScopedglClearColor clearColor(state);
    vtkOpenGLState::ScopedglDepthMask depthMask(state);
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglDepthFunc depthFunction(state);
    vtkOpenGLState::ScopedglColorMask colorMask(state);
    drawing.Part.Resources->BeginAttributes();
    state->vtkglEnable(GL_SCISSOR_TEST);
    state->vtkglScissor(drawing.Whole[0], drawing.Whole[1], drawing.Whole[2], drawing.Whole[3]);
    state->vtkglDisable(GL_BLEND);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClearDepth(1.0);
    state->vtkglClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    // Depth peeling has a pass of its own there.
    const ScopedInjector scoped(
      drawing.Actor, injector, drawing.Actor->IsRenderingTranslucentPolygonalGeometry());
    this->Stage = DrawStage::Surfaces;
    this->ShowSurroundings(true);
    this->Superclass::Render(drawing.Renderer, drawing.Actor);
    this->ShowSurroundings(false);
    this->Stage = DrawStage::Stock;
  }
  state->PopFramebufferBindings();
}

bool vtkPatternMapper::HasRemainder(vtkActor* actor)
{
  if (actor->GetProperty()->GetVertexVisibility() ||
    (this->GetSelection() && this->GetSelection()->GetNumberOfNodes() > 0))
  {
    return true;
  }
  const auto blocks = vtkPattern::Blocks(this->GetInputDataObject(0, 0));
  return std::any_of(blocks.begin(), blocks.end(),
    [](const vtkPattern::Block& block)
    { return block.Data->GetNumberOfVerts() > 0 || block.Data->GetNumberOfLines() > 0; });
}

std::array<double, 3> vtkPatternMapper::GetNanColor()
{
  constexpr double grey = 0.75;
  double rgba[4] = { grey, grey, grey, 1.0 };
  auto* table = vtkLookupTable::SafeDownCast(this->LookupTable);
  auto* function = vtkColorTransferFunction::SafeDownCast(this->LookupTable);
  if (this->ScalarVisibility && table)
  {
    table->GetNanColor(rgba);
  }
  else if (this->ScalarVisibility && function)
  {
    function->GetNanColor(rgba);
  }
  return { rgba[0], rgba[1], rgba[2] };
}

void vtkPatternMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  auto found = this->Internal->Windows.find(window);
  if (found != this->Internal->Windows.end())
  {
    WindowPart& part = found->second;
    part.Compositor.ReleaseGraphicsResources(window);
    part.ScreenPass.ReleaseGraphicsResources(window);
    part.TonePeel.ReleaseGraphicsResources(window);
    part.PatchRecords.Release(window);
    if (part.Resources)
    {
      part.Resources->ReleaseGraphicsResources(window);
    }
    this->Internal->Windows.erase(found);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkPatternMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Style: " << this->Style.Get() << "\n";
  os << indent << "TrackedMapper: " << this->TrackedMapper.Get() << "\n";
  os << indent << "CameraPath: " << this->CameraPath.Get() << "\n";
  os << indent << "WholeSurface: " << this->WholeSurface.Get() << "\n";
  os << indent << "Controller: " << this->Controller.Get() << "\n";
  os << indent << "InputOrigin: " << this->GetInputOrigin() << "\n";
  os << indent << "AnimationTime: " << this->AnimationTime << "\n";
  os << indent << "PatchArrayName: " << this->PatchArrayName << "\n";
  os << indent << "VelocityArrayName: " << this->VelocityArrayName << "\n";
  os << indent << "NoiseBackEnd: " << this->NoiseBackEnd << "\n";
  os << indent << "ReplayStep: " << this->ReplayStep << "\n";
}
