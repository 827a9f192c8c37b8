// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPatternMapper
 * @brief Draws polydata with a stack of 2D patterns that move with the surface.
 *
 * The mapper takes vtkPolyData or a composite of it and draws what VTK's own composite mapper
 * draws, with a vtkPatternStyle on its surfaces: scalar colouring, opacity, clipping planes, block
 * attributes, drawn edges, selection, stereo, tiled screenshots and split viewports keep working.
 * Lines and vertices are drawn as VTK draws them, and so is everything while the representation is
 * wireframe or points, while a hardware selector is at work, and without a style.
 *
 * Opaque surfaces are drawn in two stages. VTK's shader writes colour, tones and normals into
 * images of our own; then one pass over the object's rectangle evaluates the layers once per
 * visible pixel and writes colour and depth under the normal depth test. Translucent surfaces
 * evaluate the same layers in VTK's shader.
 *
 * Patterns move by the 2D similarity that fits the motion of samples on the surface best (Breslav
 * et al. 2007, Dynamic 2D Patterns for Shading 3D Scenes), separately in every renderer. In the
 * tracking mode ANCHORED of the style the picture is a pure function of surface, camera, style and
 * path; see SetCameraPath(). The patches of a surface move separately; see SetPatchArrayName().
 *
 * Samples, their weights and their visibility take some 250 bytes each (measured with software
 * rendering), 500 a patch by default; 99 of them are images of three frames, from which patterns
 * move. Weights by features take 8 more, by those of tone 40 more, and velocities 24 more. Where
 * there are patches, every vertex takes 4 bytes and every triangle on which several of them
 * meet 76.
 *
 * Errors, each reported once until something changes: a tone array that is missing or not numeric
 * or has too few components, an empty tone range, a light that the renderer lacks, more than four
 * different tones, a layer that cannot be drawn. What can be drawn still is; surface without data
 * is drawn in the lookup table's NaN colour (grey 0.75 without scalar colouring), without ink.
 * Without an input there are no bounds, so that renderers skip the actor; drawn all the same, the
 * mapper says so.
 */
#ifndef vtkPatternMapper_h
#define vtkPatternMapper_h

#include "HachureRenderingModule.h"
#include "vtkPatternCompositeMapper.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <string> // for the name of the patch array

#ifndef __VTK_WRAP__
#include <glm/fwd.hpp>

#include <array>
#include <memory>
#include <vector>

namespace hachure
{
struct PatternFrame;
struct TrackedSamples;
struct VectorDisc;
struct ViewProjection;
} // namespace hachure
#endif

class vtkCameraInterpolator;
class vtkDataObject;
class vtkMultiProcessController;
class vtkPatternShaderInjector;
class vtkPatternStyle;
struct vtkPatternAttributes;
class vtkPolyData;
class vtkShaderProgram;
class vtkTable;

class HACHURERENDERING_EXPORT vtkPatternMapper : public VTK_PATTERN_MAPPER_SUPERCLASS
{
public:
  static vtkPatternMapper* New();
  vtkTypeMacro(vtkPatternMapper, VTK_PATTERN_MAPPER_SUPERCLASS);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What is drawn on the surface. Several mappers may share a style. Null draws as VTK does.
   * Default: a style of its own, empty (paper without layers).
   */
  virtual void SetStyle(vtkPatternStyle* style);
  virtual vtkPatternStyle* GetStyle();
  ///@}

  ///@{
  /**
   * The mapper whose surface steers the patterns, where this one draws a stand-in of lower detail
   * for the same actor: it looks on and never moves the patterns. While that mapper has no surface
   * yet, the stand-in's own steers its pictures. Null (the default): its own. Not reference
   * counted.
   */
  virtual void SetTrackedMapper(vtkPatternMapper* mapper);
  virtual vtkPatternMapper* GetTrackedMapper();
  ///@}

  ///@{
  /**
   * The algorithm by which the input is known: a surface of the same origin as that of the last
   * frame is a later state of it, and where it has other cells, noise stays and fades (see
   * vtkNoiseLayer). Null, the default: the algorithm that the input is connected to. For pipelines
   * that hand over their data by another one every time, as ParaView's do.
   */
  virtual void SetInputOrigin(vtkAlgorithm* algorithm);
  virtual vtkAlgorithm* GetInputOrigin();
  ///@}

  ///@{
  /**
   * The surface that patterns are made of, where the input is the part of it that this process
   * draws: output 1 of vtkWholeSurface, with an input from vtkSurfacePart. Null, the default: the
   * input. Patterns then move and fade alike in all processes; Controller must be set too, unless
   * this process draws all of the surface.
   */
  virtual void SetWholeSurface(vtkDataObject* surface);
  virtual vtkDataObject* GetWholeSurface();
  ///@}

  ///@{
  /**
   * The processes that draw parts of one surface, each into its own picture of the same view, to be
   * put together by depth. With it, what is visible of the surface is found out together, once at
   * the start of every frame of a renderer: all processes must render the same frames. Null, the
   * default: this one alone.
   */
  virtual void SetController(vtkMultiProcessController* controller);
  virtual vtkMultiProcessController* GetController();
  ///@}

  ///@{
  /**
   * The recorded motion of the camera, for the tracking mode ANCHORED: the pattern at
   * AnimationTime is tracked along the path from the last key time at or before it, in steps of
   * ReplayStep, without visibility. Without a path (the default) the mode has a closed form: origin
   * at the projected centroid, scale by the projected size, angle by the projected axis.
   */
  virtual void SetCameraPath(vtkCameraInterpolator* path);
  virtual vtkCameraInterpolator* GetCameraPath();
  virtual void AddKeyTime(double time);
  virtual void RemoveAllKeyTimes();
  ///@}

  ///@{
  /**
   * Time on the camera path, in its unit, of velocities, and of transitions that take a time.
   * Default 0.
   */
  vtkSetMacro(AnimationTime, double);
  vtkGetMacro(AnimationTime, double);
  ///@}

  ///@{
  /**
   * Step of the replay, in the unit of the path, above 0. Default 1/24.
   */
  vtkSetClampMacro(ReplayStep, double, 1e-9, VTK_DOUBLE_MAX);
  vtkGetMacro(ReplayStep, double);
  ///@}

  ///@{
  /**
   * Cell array of whole numbers, 0 to 8191, that tells patches of the surface apart; each patch has
   * a pattern that moves by itself. With the point arrays of vtkPatchBlendWeights, patterns blend
   * near the borders of patches. Default "PatchId", which the input need not have; empty: one
   * patch. Any other array must be there.
   */
  virtual void SetPatchArrayName(const std::string& name);
  virtual std::string GetPatchArrayName();
  ///@}

  ///@{
  /**
   * Point array with three components: the velocity of the surface, in model units per unit of the
   * data's time, or of AnimationTime where the data have no time. Where the connectivity changes
   * between frames, as that of isosurfaces does, samples of the surface before are carried by it,
   * so that the patterns follow the surface. Otherwise the surface's points tell its motion, and
   * the array is not used. An error names an array that is missing or has other components; the
   * patterns then follow camera and actor alone, as by default: empty.
   */
  virtual void SetVelocityArrayName(const std::string& name);
  virtual std::string GetVelocityArrayName();
  ///@}

  /**
   * What sums up the kernels of noise layers (vtkNoiseLayer). CPU: the processors. GATHER: shaders
   * in which every pixel reads the kernels near it (OpenGL 3.2). COMPUTE: compute shaders, where
   * the window has OpenGL 4.3. SPLAT: a square per kernel, added up by blending; the reference.
   * They give the same picture but for rounding. AUTOMATIC: CPU, or GATHER or COMPUTE where one
   * takes less than half its time for a small noise, measured once for every graphics card. What
   * the window's OpenGL cannot do is a warning, and drawn as AUTOMATIC; a frame of more kernels
   * than it can hold is summed by the CPU. On translucent surfaces shaders always gather.
   */
  enum NoiseBackEndType
  {
    AUTOMATIC = 0,
    CPU = 1,
    GATHER = 2,
    COMPUTE = 3,
    SPLAT = 4
  };

  ///@{
  /**
   * One of NoiseBackEndType; default AUTOMATIC.
   */
  vtkSetClampMacro(NoiseBackEnd, int, AUTOMATIC, SPLAT);
  vtkGetMacro(NoiseBackEnd, int);
  ///@}

  ///@{
  /**
   * Forgets how the patterns have moved in a renderer, or in all of them: the next frame is drawn
   * as if it were the first one, whatever was drawn before. So is, by itself, a frame where time
   * has come back from a later one to that of the first one or before it, so that an animation that
   * is played again is the same again. Time is that of the data where it has moved since the last
   * frame, else AnimationTime. Who goes back from the first frame on is followed, but not in the
   * tracking mode ANCHORED, where marks are then made anew, too.
   */
  virtual void Reanchor(vtkRenderer* renderer);
  virtual void Reanchor();
  ///@}

  ///@{
  /**
   * Where the pattern lies in a renderer: origin x, y, then the image vectors u and v of the
   * pattern's axes (Breslav et al. 2007, section 3.3), in logical pixels, y up. Drawn: in the last
   * picture. Committed: after that picture's own visibility was measured, which is known from the
   * next frame on. Returns false before the first frame.
   */
  virtual bool GetDrawnFrame(vtkRenderer* renderer, double frame[6]);
  virtual bool GetDrawnFrame(vtkRenderer* renderer, int patch, double frame[6]);
  virtual bool GetCommittedFrame(vtkRenderer* renderer, double frame[6]);
  ///@}

  /**
   * Mean distance in logical pixels by which the pattern slid over the surface in the last step,
   * weighted by the visible area; negative before the first frame.
   */
  virtual double GetResidual(vtkRenderer* renderer);

  /**
   * The same for every patch, over the samples whose n.v is at least minimumFacing in the last
   * picture; -1 (all samples) to 1. Fills a table with the columns PatchId, Residual (logical
   * pixels, 0 where no sample counts) and Weight (of the samples that count: square pixels of the
   * discs that they stand for, or a number of samples if unweighted). Returns false, with an empty
   * table, before the first frame, where the surface was replaced since, and in the tracking mode
   * ANCHORED.
   */
  virtual bool GetPatchResiduals(vtkRenderer* renderer, double minimumFacing, vtkTable* residuals);

  void Render(vtkRenderer* renderer, vtkActor* actor) override;
  /** Of the whole surface, where there is one. */
  using Superclass::GetBounds;
  double* GetBounds() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

#ifndef __VTK_WRAP__
  /// What patterns are made of: the whole surface, or else the input; internal.
  vtkDataObject* GetSurfaceData();
  /// What the helpers of this mapper draw now; internal.
  enum class DrawStage{ Stock, Surfaces, Remainder };
  DrawStage GetDrawStage() const
  {
    return this->Stage;
  }
  const class vtkPatternToneChannels& GetToneChannels() const;
  const class vtkPatternPatches& GetPatches() const;
  class vtkPatternPatchRecords& GetPatchRecords();
  /// Near the surface: coordinates about it keep their digits in float.
  glm::dvec3 GetPatchOrigin() const;
  /// Whether the vertex buffers hold texture coordinates for the style.
  bool GetUsesTextureCoordinates() const;
  /// Whether there are buffers of what tells blocks and triangles apart.
  bool GetUsesPrimitiveIds() const;
  /// See vtkPatternSurface.
  void AppendPrimitiveIds(
    vtkPolyData* block, const std::vector<vtkIdType>& cells, std::vector<float>& ids);
  /// Whether there are blocks that other processes draw.
  bool GetHasSurroundings() const;
  /// Whether there are buffers of the triangles that end at a vertex; see vtkPatternSurface.
  bool GetUsesRuns() const;
  void AppendRuns(vtkPolyData* block, std::vector<float>& records);
  std::vector<hachure::PatternFrame> AnchoredFrames(const hachure::TrackedSamples& samples,
    const hachure::ViewProjection& view, vtkRenderer* renderer);
  /// Another number after every Reanchor() in all renderers.
  unsigned long GetAnchorVersion() const;
  /// The surface as it is now is where marks are made; internal.
  void AnchorSurface();
  /// Draws a legend's patch, whose arrays stand in for light, see vtkPatternToneChannels.
  void SetDrawsLegend(bool legend);
  /// Whether the stipples of pictures are kept for CollectStipples. Switched off they are
  /// forgotten.
  void KeepStipples(bool keep);
  /// Appends the stipples of the last picture as they were drawn, in framebuffer pixels of the
  /// renderer's viewport, y up, from its lower left corner; and of each the window depth of what
  /// would hide it.
  void CollectStipples(vtkRenderer* renderer, vtkActor* actor,
    std::vector<hachure::VectorDisc>& discs, std::vector<float>& depths);
#endif

protected:
  vtkPatternMapper();
  ~vtkPatternMapper() override;

  /**
   * How far from what is drawn the surface must be known, in diagonals of the bounds: what the
   * layers of the style reach in the picture, in the middle of the surface. At most 1.
   */
  double GetReach(vtkRenderer* renderer, vtkActor* actor);

#ifdef VTK_PATTERN_MAPPER_HAS_DELEGATOR
  vtkCompositePolyDataMapperDelegator* CreateADelegator() override;
#else
  vtkPatternHelperBase* CreateHelper() override;
  void CopyMapperValuesToHelper(vtkPatternHelperBase* helper) override;
#endif

private:
  vtkPatternMapper(const vtkPatternMapper&) = delete;
  void operator=(const vtkPatternMapper&) = delete;

  struct Internals;
  struct WindowPart;
  struct Drawing;
  bool DrawsPatterns(vtkRenderer* renderer, vtkActor* actor);
  vtkPatternMapper* GetSteeringMapper();
  void UpdateChannels();
  void UpdateSurroundings();
  void ShowSurroundings(bool shown);
  const double* DrawnBounds();
  std::array<int, 4> Covered(const Drawing& drawing, const double bounds[6], int margin) const;
  vtkPatternAttributes Attributes(const Drawing& drawing) const;
  void UpdatePatches(std::string& error);
  void UpdateTextureCoordinates(bool needed);
  void UpdatePrimitiveIds(bool needed);
  void UpdateRuns(bool needed);
  void TryUpdateSurface();
  void Report(const std::string& error, std::string& reported);
  void RenderOpaque(Drawing& drawing);
  void RenderForward(Drawing& drawing);
  void DrawScreen(Drawing& drawing, const glm::dmat4& modelToClip);
  void DrawAttributes(Drawing& drawing, vtkPatternShaderInjector* injector);
  void PeelTones(Drawing& drawing);
  void UploadPatchRecords(Drawing& drawing);
  class vtkPatternNoiseHistory* NoiseHistory(Drawing& drawing);
  class vtkPatternStippleHistory* StippleHistory(Drawing& drawing);
  void UpdateSurface();
  bool DrawFields(Drawing& drawing, const glm::dmat4& modelToClip, bool forward);
  void StoreStipples(Drawing& drawing);
  bool HasRemainder(vtkActor* actor);
  std::array<double, 3> GetNanColor();

  vtkSmartPointer<vtkPatternStyle> Style;
  vtkWeakPointer<vtkPatternMapper> TrackedMapper;
  vtkWeakPointer<vtkAlgorithm> InputOrigin;
  vtkSmartPointer<vtkDataObject> WholeSurface;
  vtkSmartPointer<vtkMultiProcessController> Controller;
  vtkSmartPointer<vtkCameraInterpolator> CameraPath;
  double AnimationTime = 0.0;
  double ReplayStep = 1.0 / 24.0;
  std::string PatchArrayName;
  std::string VelocityArrayName;
  int NoiseBackEnd = AUTOMATIC;
  DrawStage Stage = DrawStage::Stock;
  std::unique_ptr<Internals> Internal;
};

#endif
