// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternTileImage.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{

void addPointArray(
  vtkImageData* image, const char* name, const std::vector<float>& values, int components = 1)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  image->GetPointData()->AddArray(array);
}

void addNumber(vtkImageData* image, const char* name, int value)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  image->GetFieldData()->AddArray(array);
}

void addLayer(vtkImageData* image, const std::string& prefix, const DabLayer& layer)
{
  addPointArray(image, (prefix + "Offset").c_str(), layer.offset, 2);
  addPointArray(image, (prefix + "Alpha").c_str(), layer.alpha);
  vtkNew<vtkIntArray> index;
  index->SetName((prefix + "Index").c_str());
  index->SetNumberOfTuples(static_cast<vtkIdType>(layer.dab.size()));
  std::copy(layer.dab.begin(), layer.dab.end(), index->GetPointer(0));
  image->GetPointData()->AddArray(index);
}

std::vector<float> pointArray(vtkImageData* image, const char* name, double low, double high)
{
  vtkDataArray* array = image->GetPointData()->GetArray(name);
  const std::string quoted = "point array '" + std::string(name) + "'";
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument(
      "The input image has no " + quoted + " with one component; expected a pattern image.");
  }
  std::vector<float> values(static_cast<std::size_t>(image->GetNumberOfPoints()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!(value >= low && value <= high))
    {
      throw std::invalid_argument("Value " + std::to_string(value) + " of " + quoted +
        " at point " + std::to_string(i) + " is outside " + std::to_string(low) + " to " +
        std::to_string(high) + ".");
    }
    values[i] = static_cast<float>(value);
  }
  return values;
}

} // namespace

void writeTile(const PatternTile& tile, vtkImageData* image)
{
  image->Initialize();
  image->SetDimensions(tile.width, tile.height, 1);
  addPointArray(image, "Screen", tile.screen);
  addPointArray(image, "Gradient", tile.gradient);
  image->GetPointData()->SetActiveScalars("Screen");
  addNumber(image, "Periods", tile.periods);
  addNumber(image, "Levels", tile.levels);
}

void writePaint(const PaintTile& tile, vtkImageData* image)
{
  writeTile(tile.pattern, image);
  addLayer(image, "Dab", tile.top);
  addLayer(image, "LowerDab", tile.below);
  addPointArray(image, "PaintHeight", tile.height);
}

PatternTile readTile(vtkImageData* image, bool& periodsKnown)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  if (image->GetNumberOfPoints() < 1 || dimensions[2] != 1)
  {
    throw std::invalid_argument("The input image has " + std::to_string(dimensions[0]) + " x " +
      std::to_string(dimensions[1]) + " x " + std::to_string(dimensions[2]) +
      " points, expected one slice along z that is not empty.");
  }
  PatternTile tile;
  tile.width = dimensions[0];
  tile.height = dimensions[1];
  tile.screen = pointArray(image, "Screen", 0.0, 1.0);
  // A change of the screen per texel: sqrt(2) from corner to corner.
  tile.gradient = pointArray(image, "Gradient", 0.0, 1.5);
  vtkDataArray* periods = image->GetFieldData()->GetArray("Periods");
  periodsKnown = periods && periods->GetNumberOfValues() > 0 && periods->GetComponent(0, 0) >= 1.0;
  tile.periods = periodsKnown ? static_cast<int>(periods->GetComponent(0, 0)) : 1;
  return tile;
}

} // namespace hachure
