// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The patches of a mapper's input: which cell array numbers them, and whether they overlap.
 */
#ifndef vtkPatternPatches_h
#define vtkPatternPatches_h

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkPolyData;
namespace hachure
{
struct TrianglePatches;
}

class vtkPatternPatches
{
public:
  /// Reads which patches the input has. An array that cannot be used is named in `error`, and the
  /// input counts as one patch; so it does, silently, where no block has the default array.
  void Collect(vtkDataObject* input, const std::string& arrayName, std::string& error);

  /// Whether there is anything to tell patches apart for.
  bool IsActive() const { return this->Count > 1; }
  int GetCount() const { return this->Count; }
  const std::string& GetArrayName() const { return this->ArrayName; }
  /// Of the patches of all cells: equal patches in another array have an equal one.
  std::uint64_t GetHash() const { return this->Hash; }
  /// Rises with every change of what the shaders read.
  unsigned long GetVersion() const { return this->Version; }

  /// Appends the patches of all triangles that VTK draws of a block, in their order. `cells` is the
  /// cell of each; `firstVertex` counts the vertices of other blocks before its own; corners are
  /// stored about `origin`.
  void Append(vtkPolyData* block, const std::vector<vtkIdType>& cells, std::uint32_t firstVertex,
    const glm::dvec3& origin, hachure::TrianglePatches& all) const;

  /// Name of the array where none is set.
  static const char* DefaultArrayName() { return "PatchId"; }

private:
  using State = std::vector<std::pair<vtkDataArray*, unsigned long>>;
  void Read(vtkDataObject* input, std::string& error);

  std::string ArrayName;
  std::string Error;
  int Count = 1;
  bool Blended = false; // they overlap, by the weights of vtkPatchBlendWeights
  std::uint64_t Hash = 0;
  unsigned long Version = 0;
  State Arrays; // those of the last reading
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternPatches.h
