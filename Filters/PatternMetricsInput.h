// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PatternMetricsInput_h
#define PatternMetricsInput_h

#include "Core/PatternMetrics.h"
#include "Core/PatternMetricsTone.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;

// Images and points of vtkPatternMetrics as the core reads them. All of these throw
// std::invalid_argument with `name`, which says what was read, such as "frame 3".
namespace hachure
{

// Components of the scalars of a flat image, one after the other, in floats of its own.
struct MetricPlanes
{
  int width = 0;
  int height = 0;
  std::vector<std::vector<float>> planes;

  ImageView view() const { return { this->width, this->height, this->planes.front() }; }
};

// At least `fewest` and at most `most` components are read; fewer are an error, and so are more
// than one where one is wanted.
MetricPlanes readPlanes(
  vtkImageData* image, const std::string& name, int fewest, int most, const char* expected);

// Components: u, v, visible, and where there are so many, facing and distance.
MotionView motionOf(const MetricPlanes& planes);

struct MetricLabels
{
  int width = 0;
  int height = 0;
  std::vector<std::int32_t> values;
};
MetricLabels readLabels(vtkImageData* image, const std::string& name);

// The points without their z.
std::vector<glm::dvec2> readPlanePoints(vtkPolyData* polyData);

} // namespace hachure

#endif
