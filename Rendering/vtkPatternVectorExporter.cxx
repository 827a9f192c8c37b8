// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternVectorExporter.h"

#include "ContourLines.h"
#include "SurfaceTriangles.h"
#include "VectorPageFile.h"
#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPatternDrawnSurface.h"
#include "vtkPatternMapper.h"
#include "vtkPatternStyle.h"
#include "vtkPatternViewport.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <map>
#include <vector>

vtkStandardNewMacro(vtkPatternVectorExporter);

namespace
{
constexpr double MillimetresPerInch = 25.4;
constexpr double DefaultDotsPerInch = 96.0;
constexpr double DefaultWidth = 0.35; // millimetres, a common pen

// The part of the window that a renderer draws to, with its depth.
struct Region
{
  std::array<int, 4> Rectangle{}; // x, y, width, height
  vtkSmartPointer<vtkFloatArray> Depth;
};

// Reads the depth as soon as a renderer is finished: the next one may clear it.
class DepthReader : public vtkCommand
{
public:
  vtkTypeMacro(DepthReader, vtkCommand);
  static DepthReader* New() { return new DepthReader; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    if (auto* renderer = vtkRenderer::SafeDownCast(caller))
    {
      Region& region = this->Regions[renderer];
      int* box = region.Rectangle.data();
      renderer->GetTiledSizeAndOrigin(box + 2, box + 3, box, box + 1);
      if (box[2] > 0 && box[3] > 0)
      {
        region.Depth = vtkSmartPointer<vtkFloatArray>::New();
        renderer->GetRenderWindow()->GetZbufferData(
          box[0], box[1], box[0] + box[2] - 1, box[1] + box[3] - 1, region.Depth);
      }
    }
  }

  std::map<vtkRenderer*, Region> Regions;
};

std::vector<vtkRenderer*> RenderersOf(vtkRenderWindow* window, vtkRenderer* only)
{
  std::vector<vtkRenderer*> renderers;
  vtkCollectionSimpleIterator iterator;
  window->GetRenderers()->InitTraversal(iterator);
  while (vtkRenderer* renderer = window->GetRenderers()->GetNextRenderer(iterator))
  {
    if (renderer->GetDraw() && (!only || renderer == only))
    {
      renderers.push_back(renderer);
    }
  }
  return renderers;
}

// Calls body(actor, mapper) for all that is drawn with patterns.
template <class Body>
void ForEachPattern(vtkRenderer* renderer, Body&& body)
{
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator iterator;
  actors->InitTraversal(iterator);
  while (vtkActor* actor = actors->GetNextActor(iterator))
  {
    auto* mapper = vtkPatternMapper::SafeDownCast(actor->GetMapper());
    if (mapper && actor->GetVisibility() && mapper->GetInputAlgorithm())
    {
      body(actor, mapper);
    }
  }
}

void KeepStipples(const std::vector<vtkRenderer*>& renderers, bool keep)
{
  for (vtkRenderer* renderer : renderers)
  {
    ForEachPattern(
      renderer, [keep](vtkActor*, vtkPatternMapper* mapper) { mapper->KeepStipples(keep); });
  }
}

std::map<vtkRenderer*, Region> DrawAndReadDepth(
  vtkRenderWindow* window, const std::vector<vtkRenderer*>& renderers)
{
  vtkNew<DepthReader> reader;
  std::vector<unsigned long> tags;
  tags.reserve(renderers.size());
  for (vtkRenderer* renderer : renderers)
  {
    tags.push_back(renderer->AddObserver(vtkCommand::EndEvent, reader));
  }
  KeepStipples(renderers, true);
  window->Render();
  for (std::size_t i = 0; i < renderers.size(); ++i)
  {
    renderers[i]->RemoveObserver(tags[i]);
  }
  return reader->Regions;
}

double MillimetresPerPixelOf(const std::vector<vtkRenderer*>& renderers)
{
  double result = 0.0;
  for (vtkRenderer* renderer : renderers)
  {
    ForEachPattern(renderer,
      [&result](vtkActor*, vtkPatternMapper* mapper)
      {
        vtkPatternStyle* style = mapper->GetStyle();
        if (style && result == 0.0)
        {
          result = MillimetresPerInch / (style->GetDotsPerInch() * style->GetPixelScale());
        }
      });
  }
  return result > 0.0 ? result : MillimetresPerInch / DefaultDotsPerInch;
}

glm::vec3 ToColor(const double* color)
{
  return glm::vec3(
    static_cast<float>(color[0]), static_cast<float>(color[1]), static_cast<float>(color[2]));
}

hachure::ContourOptions OptionsOf(vtkPatternStyle* style, vtkActor* actor)
{
  hachure::ContourOptions options;
  options.smooth = actor->GetProperty()->GetInterpolation() != VTK_FLAT;
  if (style && style->GetOutline())
  {
    options.silhouettes = style->GetOutlineSilhouette();
    options.borders = style->GetOutlineBorders();
    options.creases = style->GetOutlineCreases();
    options.creaseAngle = style->GetOutlineCreaseAngle();
  }
  return options;
}

// Colour and width that all strokes of a surface have.
hachure::VectorStroke PenOf(vtkPatternStyle* style, double millimetresPerPixel)
{
  hachure::VectorStroke pen;
  pen.width = DefaultWidth / millimetresPerPixel;
  if (style && style->GetOutline())
  {
    pen.color = ToColor(style->GetOutlineColor());
    pen.width = style->GetOutlineWidthUnit() == vtkPatternLayer::MILLIMETRES
      ? style->GetOutlineWidth() / millimetresPerPixel
      : style->GetOutlineWidth() * style->GetPixelScale();
  }
  return pen;
}

// Fills a page with what one renderer has drawn.
class PageFiller
{
public:
  PageFiller(vtkRenderer* renderer, const Region& region, hachure::VectorPage& page)
    : Renderer(renderer)
    , Drawn(region)
    , Page(page)
    , Corner(region.Rectangle[0], region.Rectangle[1])
  {
  }

  void AddContours(vtkActor* actor, vtkPatternMapper* mapper)
  {
    const hachure::SurfaceTriangles surface =
      hachure::extractSurfaceTriangles(vtkPattern::DrawnSurface(mapper, actor));
    hachure::ViewProjection view;
    view.modelToView = vtkPattern::ModelView(this->Renderer, actor);
    view.viewToClip = vtkPattern::DrawnProjection(this->Renderer);
    const int width = this->Drawn.Rectangle[2];
    const int height = this->Drawn.Rectangle[3];
    view.viewportSize = glm::dvec2(width, height);
    const hachure::ContourDepth depth{ { 0, 0, width, height },
      { this->Drawn.Depth->GetPointer(0),
        static_cast<std::size_t>(this->Drawn.Depth->GetNumberOfValues()) } };
    hachure::VectorStroke stroke = PenOf(mapper->GetStyle(), this->Page.millimetresPerPixel);
    for (const hachure::ContourLine& line :
      hachure::contourLines(surface.mesh(), view, depth, OptionsOf(mapper->GetStyle(), actor)))
    {
      stroke.points = line.points;
      stroke.closed = line.closed;
      for (glm::dvec2& point : stroke.points)
      {
        point += this->Corner;
      }
      this->Page.strokes.push_back(stroke);
    }
  }

  // Those that something else hides are left out.
  void AddDiscs(vtkActor* actor, vtkPatternMapper* mapper)
  {
    std::vector<hachure::VectorDisc> discs;
    std::vector<float> depths;
    mapper->CollectStipples(this->Renderer, actor, discs, depths);
    for (std::size_t i = 0; i < discs.size(); ++i)
    {
      if (this->DepthAt(discs[i].center) >= depths[i])
      {
        discs[i].center += this->Corner;
        this->Page.discs.push_back(discs[i]);
      }
    }
  }

private:
  // Of the pixel, or the nearest one.
  float DepthAt(const glm::dvec2& place) const
  {
    const int width = this->Drawn.Rectangle[2];
    const int column = std::clamp(static_cast<int>(std::floor(place.x)), 0, width - 1);
    const int row =
      std::clamp(static_cast<int>(std::floor(place.y)), 0, this->Drawn.Rectangle[3] - 1);
    return this->Drawn.Depth->GetValue(static_cast<vtkIdType>(row) * width + column);
  }

  vtkRenderer* Renderer;
  const Region& Drawn;
  hachure::VectorPage& Page;
  glm::dvec2 Corner;
};
} // namespace

vtkPatternVectorExporter::vtkPatternVectorExporter() = default;

vtkPatternVectorExporter::~vtkPatternVectorExporter()
{
  delete[] this->FileName;
}

void vtkPatternVectorExporter::WriteData()
{
  if (!this->FileName || !*this->FileName)
  {
    vtkErrorMacro("FileName: none is set; expected a name that ends with .svg or .pdf");
    return;
  }
  const std::vector<vtkRenderer*> renderers = RenderersOf(this->RenderWindow, this->ActiveRenderer);
  const std::map<vtkRenderer*, Region> regions = DrawAndReadDepth(this->RenderWindow, renderers);
  try
  {
    hachure::VectorPage page;
    const int* size = this->RenderWindow->GetSize();
    page.size = glm::dvec2(size[0], size[1]);
    page.millimetresPerPixel = this->MillimetresPerPixel > 0.0 ? this->MillimetresPerPixel
                                                               : MillimetresPerPixelOf(renderers);
    page.paintsBackground = this->Background && !renderers.empty();
    page.background = page.paintsBackground ? ToColor(renderers[0]->GetBackground()) : glm::vec3(1);
    for (vtkRenderer* renderer : renderers)
    {
      const auto region = regions.find(renderer);
      if (region != regions.end() && region->second.Depth)
      {
        PageFiller filler(renderer, region->second, page);
        ForEachPattern(renderer,
          [&](vtkActor* actor, vtkPatternMapper* mapper)
          {
            if (this->Stipples)
            {
              filler.AddDiscs(actor, mapper);
            }
            if (this->Silhouettes)
            {
              filler.AddContours(actor, mapper);
            }
          });
      }
    }
    hachure::writeVectorPage(page, this->FileName);
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
  KeepStipples(renderers, false);
}

void vtkPatternVectorExporter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "MillimetresPerPixel: " << this->MillimetresPerPixel << "\n";
  os << indent << "Silhouettes: " << this->Silhouettes << "\n";
  os << indent << "Stipples: " << this->Stipples << "\n";
  os << indent << "Background: " << this->Background << "\n";
}
