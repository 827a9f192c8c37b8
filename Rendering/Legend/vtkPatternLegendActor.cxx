// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternLegendActor.h"

#include "PatternColor.h"
#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPatternLegendInternals.h"
#include "vtkPatternStyle.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTextProperty.h"

#include <cmath>
#include <exception>
#include <limits>

vtkStandardNewMacro(vtkPatternLegendActor);

vtkPatternLegendActor::vtkPatternLegendActor()
  : TitleTextProperty(vtkSmartPointer<vtkTextProperty>::New())
  , LabelTextProperty(vtkSmartPointer<vtkTextProperty>::New())
  , Internal(std::make_unique<Internals>())
{
  constexpr int titlePoints = 14;
  constexpr int labelPoints = 12;
  this->TitleTextProperty->SetFontSize(titlePoints);
  this->TitleTextProperty->BoldOn();
  this->LabelTextProperty->SetFontSize(labelPoints);
  this->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->SetPosition(0.82, 0.1);
  this->SetPosition2(0.16, 0.8);
}

vtkPatternLegendActor::~vtkPatternLegendActor() = default;

void vtkPatternLegendActor::SetSurface(vtkActor* surface)
{
  if (this->Surface != surface)
  {
    this->Surface = surface;
    this->Modified();
  }
}

vtkActor* vtkPatternLegendActor::GetSurface()
{
  return this->Surface;
}

void vtkPatternLegendActor::SetStyle(vtkPatternStyle* style)
{
  if (this->Style != style)
  {
    this->Style = style;
    this->Modified();
  }
}

vtkPatternStyle* vtkPatternLegendActor::GetStyle()
{
  return this->Style;
}

void vtkPatternLegendActor::SetLookupTable(vtkScalarsToColors* table)
{
  if (this->LookupTable != table)
  {
    this->LookupTable = table;
    this->Modified();
  }
}

vtkScalarsToColors* vtkPatternLegendActor::GetLookupTable()
{
  return this->LookupTable;
}

void vtkPatternLegendActor::SetSurfaceColor(double red, double green, double blue)
{
  const double color[3] = { red, green, blue };
  if (hachure::assignColor(this->SurfaceColor, color))
  {
    this->Modified();
  }
}

void vtkPatternLegendActor::AddCategory(double value, const std::string& name)
{
  this->Internal->Categories.push_back({ value, value, name });
  this->Modified();
}

void vtkPatternLegendActor::RemoveAllCategories()
{
  this->Internal->Categories.clear();
  this->Modified();
}

int vtkPatternLegendActor::GetNumberOfCategories()
{
  return static_cast<int>(this->Internal->Categories.size());
}

void vtkPatternLegendActor::SetTitleTextProperty(vtkTextProperty* property)
{
  if (property && this->TitleTextProperty != property)
  {
    this->TitleTextProperty = property;
    this->Modified();
  }
}

vtkTextProperty* vtkPatternLegendActor::GetTitleTextProperty()
{
  return this->TitleTextProperty;
}

void vtkPatternLegendActor::SetLabelTextProperty(vtkTextProperty* property)
{
  if (property && this->LabelTextProperty != property)
  {
    this->LabelTextProperty = property;
    this->Modified();
  }
}

vtkTextProperty* vtkPatternLegendActor::GetLabelTextProperty()
{
  return this->LabelTextProperty;
}

int vtkPatternLegendActor::GetNumberOfSwatches()
{
  return static_cast<int>(this->Internal->ShownPlaces.size());
}

bool vtkPatternLegendActor::GetSwatch(int index, double values[2], int rectangle[4])
{
  if (index < 0 || index >= this->GetNumberOfSwatches())
  {
    return false;
  }
  const auto i = static_cast<std::size_t>(index);
  values[0] = this->Internal->ShownSwatches[i].first;
  values[1] = this->Internal->ShownSwatches[i].last;
  std::copy(
    this->Internal->ShownPlaces[i].begin(), this->Internal->ShownPlaces[i].end(), rectangle);
  return true;
}

int vtkPatternLegendActor::GetNumberOfShownLabels()
{
  return static_cast<int>(this->Internal->ShownLabels.size());
}

std::string vtkPatternLegendActor::GetShownLabel(int index)
{
  const bool exists = index >= 0 && index < this->GetNumberOfShownLabels();
  return exists ? this->Internal->ShownLabels[static_cast<std::size_t>(index)].text : std::string();
}

double vtkPatternLegendActor::GetShownLabelPlace(int index)
{
  const bool exists = index >= 0 && index < this->GetNumberOfShownLabels();
  return exists ? this->Internal->ShownLabels[static_cast<std::size_t>(index)].place : 0.0;
}

double vtkPatternLegendActor::GetToneAt(double value)
{
  try
  {
    return hachure::PatternLegendKey(this->SurfaceToShow()).toneAt(value);
  }
  catch (const std::exception& problem)
  {
    vtkErrorMacro(<< problem.what());
    return -1.0;
  }
}

void vtkPatternLegendActor::Report(const std::string& error)
{
  if (!error.empty() && error != this->Internal->Reported)
  {
    vtkErrorMacro(<< error);
  }
  this->Internal->Reported = error;
}

hachure::LegendSurface vtkPatternLegendActor::SurfaceToShow()
{
  hachure::LegendSurface shown = hachure::legendSurfaceOf(this->Surface);
  shown.style = this->Style ? this->Style.Get() : shown.style;
  if (this->LookupTable)
  {
    shown.colors = this->LookupTable;
    shown.colorsAnyArray = true;
  }
  if (!this->Surface)
  {
    shown.color = { this->SurfaceColor[0], this->SurfaceColor[1], this->SurfaceColor[2] };
  }
  shown.layer = this->Layer;
  shown.range = { this->ValueRange[0], this->ValueRange[1] };
  return shown;
}

int vtkPatternLegendActor::RenderOverlay(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(viewport->GetVTKWindow());
  const int* size = viewport->GetSize();
  if (!renderer || !window || renderer->GetSelector() || size[0] < 1 || size[1] < 1)
  {
    return 0;
  }
  this->Internal->ShownPlaces.clear();
  this->Internal->ShownLabels.clear();
  std::string error;
  int drawn = 0;
  try
  {
    Drawing drawing(renderer, window, this->Internal->PartOf(window), this->SurfaceToShow());
    if (!hachure::isNumberFormat(this->LabelFormat))
    {
      error = "label format '" + this->LabelFormat +
        "' takes no number; expected one as printf has it for a double, such as %.3g";
    }
    this->CollectSwatches(drawing);
    this->LayOut(drawing);
    this->CollectLabels(drawing);
    if (!drawing.Scene.layout.swatches.empty())
    {
      drawn = this->DrawSwatches(drawing) ? 1 : 0;
      error = drawn || !error.empty() ? error : "OpenGL cannot draw the picture of the swatches";
      this->DrawLines(drawing);
    }
    this->DrawTexts(drawing);
  }
  catch (const std::exception& problem)
  {
    error = problem.what();
  }
  this->Report(error);
  return drawn;
}

void vtkPatternLegendActor::CollectSwatches(Drawing& drawing)
{
  const hachure::PatternLegendKey& key = drawing.Key;
  const bool categories = !this->Internal->Categories.empty() || key.hasColorCategories();
  const std::vector<double> steps = key.toneSteps();
  drawing.Mode = this->Mode != AUTOMATIC ? this->Mode
    : categories                         ? CATEGORIES
    : !steps.empty()                     ? STEPS
                                         : CONTINUOUS;
  std::vector<hachure::LegendSwatch>& swatches = drawing.Scene.swatches;
  if (key.axis() == hachure::LegendAxis::Even || (drawing.Mode == CATEGORIES && !categories))
  {
    drawing.Mode = drawing.Mode == CATEGORIES ? CONTINUOUS : drawing.Mode;
  }
  if (drawing.Mode == CATEGORIES)
  {
    swatches =
      this->Internal->Categories.empty() ? key.colorCategories() : this->Internal->Categories;
  }
  else if (drawing.Mode == STEPS && this->NumberOfSteps == 0 && !steps.empty())
  {
    drawing.Borders = steps;
    for (std::size_t i = 0; i + 1 < steps.size(); ++i)
    {
      const double middle = 0.5 * (steps[i] + steps[i + 1]);
      swatches.push_back({ middle, middle, {} });
    }
  }
  else if (drawing.Mode == STEPS)
  {
    constexpr int usual = 5;
    const int count = this->NumberOfSteps > 0 ? this->NumberOfSteps : usual;
    for (const double value : hachure::evenValues(key.range(), count))
    {
      swatches.push_back({ value, value, {} });
    }
  }
  else
  {
    swatches.push_back({ key.range()[0], key.range()[1], {} });
  }
  drawing.Nan = this->DrawNanSwatch &&
    (key.axis() == hachure::LegendAxis::Array || key.axis() == hachure::LegendAxis::Color);
  if (drawing.Nan)
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    swatches.push_back({ nan, nan, this->NanLabel });
  }
}

void vtkPatternLegendActor::ReleaseGraphicsResources(vtkWindow* window)
{
  const auto found = this->Internal->Pictures.find(window);
  if (found != this->Internal->Pictures.end())
  {
    found->second->Sheet.releaseGraphicsResources(window);
    this->Internal->Pictures.erase(found);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkPatternLegendActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Surface: " << this->Surface.Get() << "\n";
  os << indent << "Style: " << this->Style.Get() << "\n";
  os << indent << "LookupTable: " << this->LookupTable.Get() << "\n";
  os << indent << "SurfaceColor: " << this->SurfaceColor[0] << ", " << this->SurfaceColor[1] << ", "
     << this->SurfaceColor[2] << "\n";
  os << indent << "Layer: " << this->Layer << "\n";
  os << indent << "Mode: " << this->Mode << "\n";
  os << indent << "NumberOfSteps: " << this->NumberOfSteps << "\n";
  os << indent << "ValueRange: " << this->ValueRange[0] << ", " << this->ValueRange[1] << "\n";
  os << indent << "NumberOfCategories: " << this->GetNumberOfCategories() << "\n";
  os << indent << "DrawNanSwatch: " << this->DrawNanSwatch << "\n";
  os << indent << "NanLabel: " << this->NanLabel << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "SwatchThickness: " << this->SwatchThickness << "\n";
  os << indent << "DrawFrame: " << this->DrawFrame << "\n";
  os << indent << "Title: " << this->Title << "\n";
  os << indent << "DrawTitle: " << this->DrawTitle << "\n";
  os << indent << "LowLabel: " << this->LowLabel << "\n";
  os << indent << "HighLabel: " << this->HighLabel << "\n";
  os << indent << "NumberOfLabels: " << this->NumberOfLabels << "\n";
  os << indent << "RoundLabels: " << this->RoundLabels << "\n";
  os << indent << "LabelFormat: " << this->LabelFormat << "\n";
  os << indent << "AutomaticColor: " << this->AutomaticColor << "\n";
}
