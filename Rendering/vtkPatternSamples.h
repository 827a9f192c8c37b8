// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The samples of a mapper's input that steer its pattern, kept on the surface while it deforms.
 */
#ifndef vtkPatternSamples_h
#define vtkPatternSamples_h

#include "SampleProjection.h"
#include "vtkPatternGeometry.h"

#include <glm/vec3.hpp>

#include <array>

#include <cstdint>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkPolyData;

class vtkPatternSamples
{
public:
  struct Options
  {
    int SamplesPerPatch = 500;
    std::uint32_t Seed = 1;
    std::string PatchArrayName;  // empty: one patch
    std::uint64_t PatchHash = 0; // another number: other patches
    bool operator!=(const Options& other) const
    {
      return this->SamplesPerPatch != other.SamplesPerPatch || this->Seed != other.Seed ||
        this->PatchArrayName != other.PatchArrayName || this->PatchHash != other.PatchHash;
    }
  };

  /// Samples that were replaced, as they lay last.
  struct Surface
  {
    std::vector<glm::dvec3> Positions;
    std::vector<glm::dvec3> Normals;
    std::vector<std::int32_t> Patches;
    std::vector<double> PatchSpacing;
  };

  /// Values of an array at the samples, one after another.
  struct Values
  {
    std::vector<double> Numbers;
    std::uint64_t Stamp = 0; // of what they were read from
  };
  enum class Association
  {
    Points,
    PointsOrCells
  };

  /// Brings the samples up to date with polydata or a composite of polydata. New connectivity makes
  /// new samples, new coordinates only move them. Returns true where anything changed. Samples that
  /// are replaced go to `replaced`, where that is not null.
  bool Update(vtkDataObject* input, const Options& options, Surface* replaced = nullptr);

  /// The next update makes new samples if the surface has moved since these were made.
  void BeginAnew();

  /// Reads a named array of the blocks of the last update: interpolated between points, or that of
  /// the cell. Does nothing while neither samples nor array change. Throws std::invalid_argument
  /// that begins with `role` and names the array.
  void Read(const std::string& role, const std::string& name, int components, Association where,
    Values& values) const;

  hachure::TrackedSamples Tracked() const;
  std::size_t Count() const { return this->Positions.size(); }
  /// Rises with every new set of samples, and with every change of positions.
  std::uint64_t GetSetVersion() const { return this->SetVersion; }
  std::uint64_t GetPositionVersion() const { return this->PositionVersion; }
  const std::vector<glm::dvec3>& GetPositions() const { return this->Positions; }
  double Spacing(std::size_t sample) const;
  /// Middle of the samples' bounding box: coordinates about it keep their digits in float.
  glm::dvec3 GetCenter() const { return this->Center; }

private:
  void Sample(vtkDataObject* input, const Options& options);
  void Move();
  void ReadSample(std::size_t sample, vtkDataArray* array, bool ofPoints, double* numbers) const;

  vtkPatternGeometry Geometry;
  Options Current;
  std::vector<std::uint32_t> SampleBlock;              // index into the blocks
  std::vector<std::array<long long, 3>> SampleCorners; // point ids
  std::vector<long long> SampleCell;                   // cell ids
  std::vector<glm::dvec3> Barycentrics;
  std::vector<glm::dvec3> Positions;
  std::vector<glm::dvec3> Normals;
  std::vector<std::int32_t> Patches;
  std::vector<double> PatchSpacing;
  std::vector<signed char> Orientation; // -1 where the triangle's winding points inward
  glm::dvec3 Center{ 0.0 };
  std::uint64_t SetVersion = 0;
  std::uint64_t PositionVersion = 0;
  std::uint64_t FirstPositionVersion = 0; // of this set
  bool IsAnew = false;                    // asked for
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternSamples.h
