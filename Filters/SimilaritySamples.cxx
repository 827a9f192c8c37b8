// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SimilaritySamples.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
std::string quoted(const char* name)
{
  return "'" + std::string(name) + "'";
}

// The samples' array of that name, or an error that says what was expected.
vtkDataArray* requireArray(
  vtkFieldData* data, const char* where, const char* name, int components, bool integers)
{
  vtkDataArray* array = data->GetArray(name);
  const std::string expected = std::string(integers ? "integers" : "numbers") + " with " +
    std::to_string(components) + (components == 1 ? " component" : " components");
  if (array == nullptr)
  {
    throw std::invalid_argument("Samples: no " + std::string(where) + " array " + quoted(name) +
      ", expected " + expected + " as from vtkStratifiedSurfaceSampler");
  }
  const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  if (array->GetNumberOfComponents() != components || (integers && isReal))
  {
    throw std::invalid_argument("Samples: array " + quoted(name) + " has " +
      array->GetDataTypeAsString() + " with " + std::to_string(array->GetNumberOfComponents()) +
      " components, expected " + expected);
  }
  return array;
}

// The same for point data: one value per sample.
vtkDataArray* requirePointArray(vtkPolyData* input, const char* name, int components, bool integers)
{
  vtkDataArray* array = requireArray(input->GetPointData(), "point", name, components, integers);
  if (array->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    throw std::invalid_argument("Samples: array " + quoted(name) + " has " +
      std::to_string(array->GetNumberOfTuples()) + " tuples, expected " +
      std::to_string(input->GetNumberOfPoints()) + ", one per sample");
  }
  return array;
}

std::vector<glm::dvec3> readVectors(vtkDataArray* array)
{
  std::vector<glm::dvec3> result(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), &result[i].x);
  }
  return result;
}

void readPatches(vtkPolyData* input, TrackedSampleSet& samples)
{
  std::vector<int> ids(samples.positions.size(), 0);
  if (input->GetPointData()->HasArray("PatchId"))
  {
    vtkDataArray* array = requirePointArray(input, "PatchId", 1, true);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      ids[i] = static_cast<int>(array->GetComponent(static_cast<vtkIdType>(i), 0));
    }
  }
  samples.patchIds = ids;
  std::sort(samples.patchIds.begin(), samples.patchIds.end());
  samples.patchIds.erase(
    std::unique(samples.patchIds.begin(), samples.patchIds.end()), samples.patchIds.end());

  vtkDataArray* spacing = requireArray(input->GetFieldData(), "field", "PatchSpacing", 1, false);
  std::map<int, std::int32_t> rows;
  for (const int id : samples.patchIds)
  {
    if (id < 0 || id >= spacing->GetNumberOfTuples())
    {
      throw std::invalid_argument("Samples: PatchId " + std::to_string(id) + ", expected 0 to " +
        std::to_string(spacing->GetNumberOfTuples()) + " - 1, the size of 'PatchSpacing'");
    }
    rows.emplace(id, static_cast<std::int32_t>(rows.size()));
    samples.spacing.push_back(spacing->GetComponent(id, 0));
  }
  for (const int id : ids)
  {
    samples.patches.push_back(rows[id]);
  }
}

void readCorners(vtkPolyData* input, TrackedSampleSet& samples)
{
  vtkDataArray* ids = requirePointArray(input, "PointIds", 3, true);
  samples.barycentrics = readVectors(requirePointArray(input, "Barycentrics", 3, false));
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    SampleCorners corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[static_cast<std::size_t>(k)] = static_cast<vtkIdType>(ids->GetComponent(i, k));
    }
    samples.corners.push_back(corners);
  }
  vtkDataArray* blocks = input->GetPointData()->GetArray("BlockIndex");
  if (blocks != nullptr && blocks->GetNumberOfTuples() > 0 &&
    blocks->GetFiniteRange(0)[0] != blocks->GetFiniteRange(0)[1])
  {
    throw std::invalid_argument(
      "Samples: array 'BlockIndex' names several blocks, expected samples "
      "of the one mesh that is given");
  }
}

void checkMeshes(const TrackedSampleSet& samples, vtkPolyData* before, vtkPolyData* after)
{
  if (before != nullptr && after != nullptr &&
    before->GetNumberOfPoints() != after->GetNumberOfPoints())
  {
    throw std::invalid_argument("Meshes: " + std::to_string(before->GetNumberOfPoints()) +
      " points before and " + std::to_string(after->GetNumberOfPoints()) +
      " after, expected the same points");
  }
  const vtkIdType count = (before != nullptr ? before : after)->GetNumberOfPoints();
  for (std::size_t i = 0; i < samples.corners.size(); ++i)
  {
    for (const vtkIdType id : samples.corners[i])
    {
      if (id < 0 || id >= count)
      {
        throw std::invalid_argument("Samples: array 'PointIds' has " + std::to_string(id) +
          " at sample " + std::to_string(i) + ", expected 0 to " + std::to_string(count) +
          " - 1, the points of the mesh");
      }
    }
  }
}

// Where the samples lie on the mesh, with the normals of its triangles in their own orientation.
SampleGeometry placeOnMesh(const TrackedSampleSet& samples, vtkPolyData* mesh)
{
  SampleGeometry geometry;
  for (std::size_t i = 0; i < samples.corners.size(); ++i)
  {
    glm::dvec3 p[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      mesh->GetPoint(samples.corners[i][k], &p[k].x);
    }
    const glm::dvec3 weights = samples.barycentrics[i];
    geometry.positions.push_back(weights.x * p[0] + weights.y * p[1] + weights.z * p[2]);
    const glm::dvec3 area = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double length = glm::length(area);
    geometry.normals.push_back(length > 0.0 ? area / length : glm::dvec3(0.0));
  }
  return geometry;
}
} // namespace

TrackedSampleSet readSamples(vtkPolyData* input, bool withCorners)
{
  TrackedSampleSet samples;
  if (input->GetNumberOfPoints() == 0)
  {
    return samples;
  }
  samples.positions = readVectors(input->GetPoints()->GetData());
  samples.normals = readVectors(requirePointArray(input, "Normals", 3, false));
  readPatches(input, samples);
  if (withCorners)
  {
    readCorners(input, samples);
  }
  return samples;
}

void placeSamples(const TrackedSampleSet& samples, vtkPolyData* before, vtkPolyData* after,
  SampleGeometry& geometryBefore, SampleGeometry& geometryAfter)
{
  geometryBefore = geometryAfter = { samples.positions, samples.normals };
  if (before == nullptr && after == nullptr)
  {
    return;
  }
  checkMeshes(samples, before, after);
  if (before != nullptr)
  {
    geometryBefore = placeOnMesh(samples, before);
  }
  if (after != nullptr)
  {
    geometryAfter = placeOnMesh(samples, after);
  }
  const std::vector<glm::dvec3> reference =
    (before != nullptr ? geometryBefore : geometryAfter).normals;
  for (std::size_t i = 0; i < samples.corners.size(); ++i)
  {
    const double side = glm::dot(reference[i], samples.normals[i]) < 0.0 ? -1.0 : 1.0;
    geometryBefore.normals[i] *= before != nullptr ? side : 1.0;
    geometryAfter.normals[i] *= after != nullptr ? side : 1.0;
  }
}
} // namespace hachure
