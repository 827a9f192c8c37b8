// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// How vtkPatternLegendActor lays out and draws its parts.
#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternBlocks.h"
#include "vtkPatternLegendInternals.h"
#include "vtkPatternMapper.h"
#include "vtkPatternStyle.h"
#include "vtkPatternViewport.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkScalarsToColors.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
constexpr int frameWidth = 1; // logical pixels

// Name of the array that a mapper colours by; false where there is none.
bool coloringArray(vtkMapper* mapper, std::string& name)
{
  const int mode = mapper->GetScalarMode();
  const bool byName = mode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA ||
    mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA || mode == VTK_SCALAR_MODE_USE_FIELD_DATA;
  if (byName && mapper->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME)
  {
    name = mapper->GetArrayName() ? mapper->GetArrayName() : "";
    return !name.empty();
  }
  for (const vtkPattern::Block& block : vtkPattern::Blocks(mapper->GetInputDataObject(0, 0)))
  {
    int onCells = 0;
    vtkAbstractArray* found = vtkMapper::GetAbstractScalars(block.Data, mode,
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), onCells);
    if (found)
    {
      name = found->GetName() ? found->GetName() : "";
      return true;
    }
  }
  return false;
}

double luma(const double* color)
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

// Dots per inch that texts have in the whole picture. Tiles of larger pictures come with those of
// the window or, from ParaView, with as many more as they are larger.
int logicalResolution(vtkWindow* window)
{
  constexpr int pointsPerInch = 72; // the least that windows have
  const int* tileScale = window->GetTileScale();
  const int scale = std::max(tileScale[0], tileScale[1]);
  const int now = window->GetDPI();
  return now >= scale * pointsPerInch ? now / scale : now;
}

// How light the ground is that a renderer draws over.
double backgroundLuma(vtkRenderer* renderer)
{
  vtkRenderer* ground = renderer;
  vtkRendererCollection* all = renderer->GetRenderWindow()->GetRenderers();
  vtkCollectionSimpleIterator position;
  all->InitTraversal(position);
  while (vtkRenderer* other = all->GetNextRenderer(position))
  {
    const double* a = other->GetViewport();
    const double* b = renderer->GetViewport();
    const bool around = a[0] <= b[0] && a[1] <= b[1] && a[2] >= b[2] && a[3] >= b[3];
    ground = around && other->GetLayer() < ground->GetLayer() ? other : ground;
  }
  const double own = luma(ground->GetBackground());
  return ground->GetGradientBackground() ? 0.5 * (own + luma(ground->GetBackground2())) : own;
}

// Around a swatch; ends: also where it ends, unless the next one begins there.
void addFrame(std::vector<hachure::LegendRectangle>& lines, const hachure::LegendRectangle& swatch,
  bool vertical, bool ends)
{
  const int across = vertical ? 0 : 1;
  const int along = 1 - across;
  const int w = frameWidth;
  for (const int side : { 0, 1 })
  {
    hachure::LegendRectangle beside = swatch;
    beside[across] += side == 0 ? -w : swatch[across + 2];
    beside[across + 2] = w;
    lines.push_back(beside);
    hachure::LegendRectangle end = swatch;
    end[along] += side == 0 ? -w : swatch[along + 2];
    end[along + 2] = w;
    end[across] -= w;
    end[across + 2] += 2 * w;
    if (side == 0 || ends)
    {
      lines.push_back(end);
    }
  }
}

std::string pictureKey(const hachure::LegendSurface& surface, const hachure::PatternLegendKey& key,
  const hachure::LegendPictureScene& scene)
{
  std::ostringstream text;
  text.precision(17);
  text << surface.style << ' ' << surface.style->GetMTime() << ' ' << surface.colors << ' '
       << (surface.colors ? surface.colors->GetMTime() : 0) << ' ' << surface.colorArray << ' '
       << surface.color[0] << ' ' << surface.color[1] << ' ' << surface.color[2] << ' '
       << static_cast<int>(key.axis()) << ' ' << key.arrayName() << ' ' << surface.layer << ' '
       << scene.vertical << ' ' << scene.pixelsPerLogical;
  for (std::size_t i = 0; i < scene.layout.swatches.size(); ++i)
  {
    text << ' ' << scene.swatches[i].first << ' ' << scene.swatches[i].last;
    for (const int number : scene.layout.swatches[i])
    {
      text << ' ' << number;
    }
  }
  return text.str();
}
} // namespace

namespace hachure
{
LegendSurface legendSurfaceOf(vtkActor* actor)
{
  LegendSurface surface;
  auto* mapper = vtkPatternMapper::SafeDownCast(actor ? actor->GetMapper() : nullptr);
  if (!mapper)
  {
    return surface;
  }
  surface.style = mapper->GetStyle();
  std::copy_n(actor->GetProperty()->GetColor(), 3, surface.color.begin());
  if (mapper->GetScalarVisibility() && coloringArray(mapper, surface.colorArray))
  {
    surface.colors = mapper->GetLookupTable();
    surface.colorsAnyArray = false;
  }
  return surface;
}
} // namespace hachure

vtkPatternLegendActor::Drawing::Drawing(vtkRenderer* renderer, vtkOpenGLRenderWindow* window,
  Internals::WindowPart& part, const hachure::LegendSurface& surface)
  : Renderer(renderer)
  , Window(window)
  , Part(part)
  , Surface(surface)
  , Key(surface)
  , Resolution(logicalResolution(window))
{
  const double pixelScale = surface.style->GetPixelScale();
  this->Scene.pixelsPerLogical = vtkPatternViewport(renderer, pixelScale).PixelsPerLogical;
}

hachure::LegendRectangle vtkPatternLegendActor::Drawing::InPixels(
  const hachure::LegendRectangle& logical) const
{
  const std::array<int, 2> lower = this->InPixels(logical[0], logical[1]);
  const std::array<int, 2> upper = this->InPixels(logical[0] + logical[2], logical[1] + logical[3]);
  return { lower[0], lower[1], upper[0] - lower[0], upper[1] - lower[1] };
}

std::array<int, 2> vtkPatternLegendActor::Drawing::InPixels(double x, double y) const
{
  const double scale = this->Scene.pixelsPerLogical;
  return { static_cast<int>(std::lround(scale * (this->Corner[0] + x))),
    static_cast<int>(std::lround(scale * (this->Corner[1] + y))) };
}

// Of the size alone, so that a larger screenshot is laid out in the same way.
int vtkPatternLegendActor::Drawing::LineHeight(vtkTextProperty* font) const
{
  constexpr double pointsPerInch = 72.0;
  constexpr double lineHeight = 1.25; // of the font's size
  return static_cast<int>(
    std::ceil(lineHeight * font->GetFontSize() * this->Resolution / pointsPerInch));
}

int vtkPatternLegendActor::Drawing::TextWidth(vtkTextProperty* font, const std::string& text) const
{
  constexpr double widthOfLetter = 0.5; // of a line's height, generously
  return static_cast<int>(
    std::ceil(widthOfLetter * this->LineHeight(font) * static_cast<double>(text.size())));
}

std::string vtkPatternLegendActor::Number(double value)
{
  const bool usable = hachure::isNumberFormat(this->LabelFormat);
  return hachure::numberText(usable ? this->LabelFormat : "%.4g", value);
}

std::string vtkPatternLegendActor::TitleText(const Drawing& drawing)
{
  if (!this->DrawTitle)
  {
    return {};
  }
  return this->Title.empty() ? drawing.Key.arrayName() : this->Title;
}

void vtkPatternLegendActor::LayOut(Drawing& drawing)
{
  hachure::LegendLayoutOptions options;
  const double* value = this->PositionCoordinate->GetComputedDoubleViewportValue(drawing.Renderer);
  const std::array<double, 2> lower = { value[0], value[1] };
  value = this->Position2Coordinate->GetComputedDoubleViewportValue(drawing.Renderer);
  const double scale = drawing.Scene.pixelsPerLogical;
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    // Whole logical pixels, so that larger screenshots are the same.
    drawing.Corner[axis] = static_cast<int>(std::lround(lower[axis] / scale));
    options.size[axis] =
      std::max(0, static_cast<int>(std::lround((value[axis] - lower[axis]) / scale)));
  }
  options.vertical = this->Orientation == VERTICAL;
  options.thickness = this->SwatchThickness;
  options.nan = drawing.Nan;
  options.swatches = static_cast<int>(drawing.Scene.swatches.size()) - (drawing.Nan ? 1 : 0);
  options.apart = drawing.Mode == CATEGORIES;
  options.labelHeight = drawing.LineHeight(this->LabelTextProperty);
  const std::string title = this->TitleText(drawing);
  if (!title.empty())
  {
    const auto lines = 1 + static_cast<int>(std::count(title.begin(), title.end(), '\n'));
    options.titleHeight = lines * drawing.LineHeight(this->TitleTextProperty);
  }
  for (const hachure::LegendSwatch& swatch : drawing.Scene.swatches)
  {
    const int width = drawing.TextWidth(this->LabelTextProperty, swatch.name);
    options.longest = options.vertical ? 0 : std::max(options.longest, width);
  }
  drawing.Scene.vertical = options.vertical;
  drawing.Scene.layout = hachure::legendLayout(options);
}

// Beside a row in which values go evenly from the first to the last; as many as there is room for.
void vtkPatternLegendActor::LabelValues(Drawing& drawing)
{
  const bool vertical = drawing.Scene.vertical;
  const std::array<double, 2>& range = drawing.Key.range();
  const double room = drawing.Scene.layout.row[vertical ? 3 : 2];
  drawing.Ticks = true;
  for (int count = this->NumberOfLabels; count > 0; --count)
  {
    drawing.Labels.clear();
    int needed = drawing.LineHeight(this->LabelTextProperty);
    for (const double value :
      this->RoundLabels ? hachure::roundValues(range, count) : hachure::evenValues(range, count))
    {
      const std::string text = this->Number(value);
      drawing.Labels.push_back({ (value - range[0]) / (range[1] - range[0]), text });
      const int width = drawing.TextWidth(this->LabelTextProperty, text);
      needed = vertical ? needed : std::max(needed, width);
    }
    const double apart =
      drawing.Labels.size() > 1 ? room * (drawing.Labels[1].place - drawing.Labels[0].place) : room;
    if (apart >= needed)
    {
      return;
    }
  }
  drawing.Labels.clear();
}

void vtkPatternLegendActor::LabelEnds(Drawing& drawing)
{
  const bool shines = drawing.Key.axis() == hachure::LegendAxis::Highlight;
  const std::string low = !this->LowLabel.empty() ? this->LowLabel : shines ? "dull" : "light";
  const std::string high = !this->HighLabel.empty() ? this->HighLabel : shines ? "shining" : "dark";
  const auto total = static_cast<double>(drawing.Scene.swatches.size());
  const double inside = drawing.Mode == STEPS ? 0.5 / total : 0.0; // the middle of a swatch
  drawing.Labels = { { inside, low }, { 1.0 - inside, high } };
}

// At the middle of each, or where two meet.
void vtkPatternLegendActor::LabelSwatches(Drawing& drawing)
{
  const bool vertical = drawing.Scene.vertical;
  const std::size_t along = vertical ? 1 : 0;
  const hachure::LegendRectangle& row = drawing.Scene.layout.row;
  const std::size_t count = drawing.Scene.layout.swatches.size() - (drawing.Nan ? 1 : 0);
  int needed = drawing.LineHeight(this->LabelTextProperty);
  drawing.Ticks = !drawing.Borders.empty();
  for (std::size_t i = 0; i < std::max(count, drawing.Borders.size()); ++i)
  {
    const bool borders = drawing.Ticks;
    const auto& swatch = drawing.Scene.swatches[std::min(i, count - 1)];
    const auto& place = drawing.Scene.layout.swatches[std::min(i, count - 1)];
    const double begin = place[along] - row[along];
    const double at =
      borders ? begin + (i == count ? place[along + 2] : 0) : begin + 0.5 * place[along + 2];
    const std::string text = drawing.Mode == CATEGORIES
      ? swatch.name
      : this->Number(borders ? drawing.Borders[i] : swatch.first);
    drawing.Labels.push_back({ at / row[along + 2], text });
    needed = vertical ? needed : std::max(needed, drawing.TextWidth(this->LabelTextProperty, text));
  }
  const double apart = static_cast<double>(row[along + 2]) / static_cast<double>(count);
  const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(needed / apart)));
  if (drawing.Mode == STEPS && stride > 1)
  {
    std::vector<hachure::LegendLabel> kept;
    for (std::size_t i = 0; i < drawing.Labels.size(); i += stride)
    {
      kept.push_back(drawing.Labels[i]);
    }
    drawing.Labels = kept;
  }
}

void vtkPatternLegendActor::CollectLabels(Drawing& drawing)
{
  const hachure::LegendLayout& layout = drawing.Scene.layout;
  if (layout.swatches.empty())
  {
    return;
  }
  const hachure::LegendAxis axis = drawing.Key.axis();
  const bool light = axis == hachure::LegendAxis::Light || axis == hachure::LegendAxis::Highlight;
  const bool numbers = !light && axis != hachure::LegendAxis::Even;
  if (drawing.Mode == CATEGORIES || (numbers && drawing.Mode == STEPS))
  {
    this->LabelSwatches(drawing);
  }
  else if (light)
  {
    this->LabelEnds(drawing);
  }
  else if (numbers)
  {
    this->LabelValues(drawing);
  }
  this->Internal->ShownLabels = drawing.Labels;
}

bool vtkPatternLegendActor::DrawSwatches(Drawing& drawing)
{
  Internals::WindowPart* const part = &drawing.Part;
  const std::string key = pictureKey(drawing.Surface, drawing.Key, drawing.Scene);
  auto found = std::find_if(part->Drawn.begin(), part->Drawn.end(),
    [&key](const auto& drawn) { return drawn.first == key; });
  if (found == part->Drawn.end())
  {
    constexpr std::size_t kept = 4;
    const auto picture =
      part->Painter.draw(drawing.Window, drawing.Surface.style, drawing.Key, drawing.Scene);
    if (!picture)
    {
      return false;
    }
    if (part->Drawn.size() == kept)
    {
      part->Drawn.erase(part->Drawn.begin());
    }
    part->Drawn.emplace_back(key, picture);
    found = part->Drawn.end() - 1;
  }
  const std::array<int, 4> area = hachure::legendArea(drawing.Scene.layout);
  const std::array<int, 2> corner = drawing.InPixels(area[0], area[1]);
  std::vector<hachure::LegendPiece> pieces;
  for (const hachure::LegendRectangle& swatch : drawing.Scene.layout.swatches)
  {
    const hachure::LegendRectangle to = drawing.InPixels(swatch);
    pieces.push_back({ { to[0] - corner[0], to[1] - corner[1], to[2], to[3] }, { to[0], to[1] } });
    this->Internal->ShownPlaces.push_back(to);
  }
  this->Internal->ShownSwatches = drawing.Scene.swatches;
  drawing.Part.Sheet.drawPicture(drawing.Renderer, found->second, pieces);
  return true;
}

// Frames, borders of steps and ticks.
void vtkPatternLegendActor::DrawLines(Drawing& drawing)
{
  const bool vertical = drawing.Scene.vertical;
  const hachure::LegendLayout& layout = drawing.Scene.layout;
  std::vector<hachure::LegendRectangle> lines;
  const std::size_t count = layout.swatches.size();
  for (std::size_t i = 0; this->DrawFrame && i < count; ++i)
  {
    const bool joined = drawing.Mode == STEPS && i + 1 < count - (drawing.Nan ? 1 : 0);
    addFrame(lines, layout.swatches[i], vertical, !joined);
  }
  for (const hachure::LegendLabel& label : drawing.Labels)
  {
    const int length = drawing.Ticks ? hachure::legendTick : 0;
    const hachure::LegendRectangle& row = layout.row;
    const auto along = [&label](int begin, int extent)
    {
      const auto last = static_cast<double>(extent - frameWidth);
      return begin + static_cast<int>(std::lround(label.place * last));
    };
    if (length > 0 && vertical)
    {
      lines.push_back({ row[0] + row[2] + frameWidth, along(row[1], row[3]), length, frameWidth });
    }
    else if (length > 0)
    {
      lines.push_back({ along(row[0], row[2]), row[1] - frameWidth - length, frameWidth, length });
    }
  }
  std::transform(lines.begin(), lines.end(), lines.begin(),
    [&drawing](const hachure::LegendRectangle& line) { return drawing.InPixels(line); });
  std::array<double, 3> color{};
  std::copy_n(this->LabelTextProperty->GetColor(), 3, color.begin());
  if (this->AutomaticColor)
  {
    color.fill(backgroundLuma(drawing.Renderer) < 0.5 ? 1.0 : 0.0);
  }
  drawing.Part.Sheet.drawRectangles(drawing.Renderer, lines, color);
}

void vtkPatternLegendActor::DrawTexts(Drawing& drawing)
{
  const double grey = backgroundLuma(drawing.Renderer) < 0.5 ? 1.0 : 0.0;
  const auto resolution =
    static_cast<int>(std::lround(drawing.Scene.pixelsPerLogical * drawing.Resolution));
  std::size_t index = 0;
  const auto write =
    [&](const std::string& text, vtkTextProperty* like, double x, double y, int across, int upwards)
  {
    vtkNew<vtkTextProperty> font;
    font->ShallowCopy(like);
    font->SetJustification(across);
    font->SetVerticalJustification(upwards);
    if (this->AutomaticColor)
    {
      font->SetColor(grey, grey, grey);
    }
    drawing.Part.Sheet.drawText(
      drawing.Renderer, index++, text, font, drawing.InPixels(x, y), resolution);
  };
  const hachure::LegendLayout& layout = drawing.Scene.layout;
  const std::string title = this->TitleText(drawing);
  if (!title.empty())
  {
    write(title, this->TitleTextProperty, layout.title[0], layout.title[1], VTK_TEXT_LEFT,
      VTK_TEXT_TOP);
  }
  const auto label =
    [&](const std::string& text, const hachure::LegendRectangle& beside, double place)
  {
    const int apart = frameWidth + (drawing.Ticks ? hachure::legendTick : 0) + hachure::legendGap;
    if (drawing.Scene.vertical)
    {
      write(text, this->LabelTextProperty, beside[0] + beside[2] + apart,
        beside[1] + place * beside[3], VTK_TEXT_LEFT, VTK_TEXT_CENTERED);
    }
    else
    {
      write(text, this->LabelTextProperty, beside[0] + place * beside[2],
        beside[1] - apart + 0.5 * hachure::legendGap, VTK_TEXT_CENTERED, VTK_TEXT_TOP);
    }
  };
  for (const hachure::LegendLabel& shown : drawing.Labels)
  {
    label(shown.text, layout.row, shown.place);
  }
  if (drawing.Nan && !layout.swatches.empty())
  {
    label(this->NanLabel, layout.swatches.back(), 0.5);
  }
}
