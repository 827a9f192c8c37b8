// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SimilaritySamples_h
#define hachure_SimilaritySamples_h

#include <vtkType.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

class vtkPolyData;

// Surface samples as vtkStratifiedSurfaceSampler writes them, read back and put on deformed meshes.
namespace hachure
{
using SampleCorners = std::array<vtkIdType, 3>;

// The samples as the input has them, patches numbered by row of the output.
struct TrackedSampleSet
{
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::vector<std::int32_t> patches;
  std::vector<int> patchIds;   // per row
  std::vector<double> spacing; // per row
  // Only with meshes.
  std::vector<SampleCorners> corners;
  std::vector<glm::dvec3> barycentrics;
};

// Positions and normals of the samples in one frame.
struct SampleGeometry
{
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
};

// Throws std::invalid_argument on missing or mis-typed arrays, and on patches without spacing. The
// corners are read only where asked for. No points give an empty set.
TrackedSampleSet readSamples(vtkPolyData* input, bool withCorners);

// The samples of two frames; a mesh that is null leaves the samples where they are. The order of a
// triangle's corners does not tell its front: the samples' normals do. Throws std::invalid_argument
// on corners that the meshes do not have and on meshes with different numbers of points.
void placeSamples(const TrackedSampleSet& samples, vtkPolyData* before, vtkPolyData* after,
  SampleGeometry& geometryBefore, SampleGeometry& geometryAfter);
} // namespace hachure

#endif
