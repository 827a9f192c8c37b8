// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How a layer is drawn: its shader text, textures and uniforms in one window.
 *
 * Layers hold parameters only; each type of layer has one painter, made by New().
 */
#ifndef vtkPatternLayerPainter_h
#define vtkPatternLayerPainter_h

#include "PatternTracker.h"
#include "TimedOctave.h"
#include "VectorPage.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkPatternLayer;
class vtkPatternNoiseHistory;
class vtkPatternStippleHistory;
class vtkPatternSurface;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkPatternLayerPainter
{
public:
  virtual ~vtkPatternLayerPainter() = default;

  /// The painter for this type of layer. The one list of layer types in the rendering code.
  static std::unique_ptr<vtkPatternLayerPainter> New(vtkPatternLayer* layer);

  /// What a draw knows besides the layer.
  struct Scene
  {
    double PixelsPerLogical = 1.0;
    double DotsPerInch = 96.0;
    bool FinalQuality = false;
    glm::dmat4 ModelToClip = glm::dmat4(1.0);
    double PixelsPerModelUnit = 1.0;          // of the framebuffer, where clip w is 1
    double ModelDiagonal = 1.0;               // of the input's bounds; 0 where there are none
    glm::dvec3 PatchOrigin = glm::dvec3(0.0); // that records of patches are stored about
  };

  /// Brings textures and tables up to date. Returns false, with the reason in `error`, where the
  /// layer cannot be drawn.
  virtual bool Update(vtkOpenGLRenderWindow* window, const Scene& scene, std::string& error) = 0;

  /// What the user should know about a layer that is drawn all the same; empty where all is well.
  virtual std::string GetNote() const { return {}; }

  /// What the layer must know of the surface, beyond where it lies in the picture.
  enum SurfaceNeed
  {
    NOTHING,
    POINT,
    POINT_AND_TEXTURE // coordinates, where the surface has them
  };
  virtual SurfaceNeed GetSurfaceNeed() const { return NOTHING; }

  /// Whether the field lies differently on every patch.
  virtual bool FollowsPatches() const { return false; }

  /// Whether the shader of a translucent surface must know block and triangle, hachureIdsHere.
  virtual bool NeedsPrimitiveIds() const { return false; }

  /// Whether the layer knows more of triangles than patches: its text then finds hachureRun, the
  /// first record of those that it may be on (TriangleRuns.h), and hachureRunPoint.
  virtual bool NeedsRuns() const { return false; }

  /// Linear colour of the ink at `position`, a vec3 of the shader, where it depends on more than
  /// the layer's colour source; `coverage` is known.
  virtual std::string GetInkColor() const { return {}; }
  /// Whether hachureUniformScreen() is called.
  virtual bool UsesResponses() const { return false; }

  /// What is seen of the surface, for layers whose field is made for the pixels that show it.
  struct FieldScene
  {
    vtkPatternSurface* Surface;
    vtkPatternSurface* Steering; // whose stipples are drawn: itself, or what it is a stand-in of
    bool CarriesStipples;        // from one surface to the next
    vtkPatternNoiseHistory* History;          // of it in this renderer; null: nothing is remembered
    vtkPatternStippleHistory* StippleHistory; // the same
    bool LookOn;                              // what is remembered stays
    bool SecondEye;                           // of one picture
    glm::dmat4 ModelToClip;
    std::array<int, 4> Viewport;  // x, y, width, height in the framebuffer
    std::array<int, 4> Rectangle; // that is drawn
    float DepthPerPixel;          // change of the window depth by moving away by a pixel's size
    int NoiseBackEnd;             // as vtkNoiseBackEnd takes it
    unsigned long Frame;          // of the renderer: until it changes nothing else does
    vtkTextureObject* DepthImage; // window depth of the framebuffer, 1 where nothing is seen
    std::function<const std::vector<float>&()> LookAtDepth; // the same in the rectangle, read back
    struct Seen
    {
      std::vector<std::int32_t> Triangles; // in the rectangle, -1 where none is seen
      std::vector<std::int32_t> Objects;   // their blocks
    };
    std::function<const Seen&()> LookAtTriangles; // draws the surface once more
    struct ToneImage
    {
      std::vector<std::uint8_t> Tones; // of four channels in the rectangle, 0 to 255
      std::vector<float> Depth;        // window depth, 1 where nothing is; empty: not asked for
    };
    /// Of what is seen; of a translucent surface its layers from the front, with their depth.
    std::function<const std::vector<ToneImage>&()> LookAtTones;
    /// Display-referred colours of what is seen in the rectangle, four bytes a pixel; of an opaque
    /// surface, where the layers' text uses hachureSurfaceHere.
    std::function<const std::vector<std::uint8_t>&()> LookAtColors;
  };
  /// Whether DrawField must be called between the surface's drawing and that of the layers.
  virtual bool NeedsField() const { return false; }
  /// channel: of the layer's tone, -1 where it has none. Returns what is wrong with the data, empty
  /// where all is well; a field is drawn all the same.
  virtual std::string DrawField(const FieldScene&, int) { return {}; }
  /// The same before a translucent surface is drawn, of which nothing was seen yet: its scene has
  /// neither depth nor triangles. Until the next Update, the layer is drawn with the declarations
  /// of GetForwardDeclarations.
  virtual std::string DrawForwardField(const FieldScene&, int) { return {}; }

  /// A mark that was drawn, in pixels of the framebuffer.
  struct Disc
  {
    hachure::VectorDisc Shape;
    float Depth; // window depth of what would hide it
  };
  /// Appends what DrawField has drawn, where that are discs.
  virtual void CollectDiscs(std::vector<Disc>&) const {}

  /// Declarations with '@' for the layer's number; they define
  /// float hachureCoverage@(vec2 position, float tone). patches: where there are several patches.
  virtual std::string GetDeclarations(bool patches) const = 0;
  /// The same in the shader of a translucent surface, which knows the fragment's own depth.
  virtual std::string GetForwardDeclarations(bool patches) const
  {
    return this->GetDeclarations(patches);
  }
  /// Rows of 256 thresholds for the table that all layers share, and a version of their content.
  virtual const std::vector<float>& GetTableRows() const = 0;
  virtual unsigned long GetTableVersion() const = 0;

  /// Where a layer's rows are in the table that all layers share.
  struct TablePart
  {
    std::size_t First;
    std::size_t RowsOfAll;
  };

  /// Values for one draw; `frame` is where the pattern lies now, in logical pixels, `octave` the
  /// octave of it that is drawn, null where that goes by the scale.
  virtual void SetUniforms(vtkShaderProgram* program, const std::string& number,
    const hachure::PatternFrame& frame, const hachure::TimedOctave* octave,
    const TablePart& rows) = 0;

  /// What a shader must know of a pattern that lies there; see HachurePlacement in
  /// PatternCompose.glsl.
  virtual std::array<glm::vec4, 2> GetPlacement(const hachure::PatternFrame& frame,
    const hachure::TimedOctave* octave, const TablePart& rows) const = 0;

  virtual void Activate() = 0;
  virtual void Deactivate() = 0;
  virtual void ReleaseGraphicsResources(vtkWindow* window) = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternLayerPainter.h
