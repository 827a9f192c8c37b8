// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The records of triangles on which patches overlap, of all helpers that draw one mapper's blocks,
 * in one list for the screen pass; and how shaders read them.
 */
#ifndef vtkPatternPatchRecords_h
#define vtkPatternPatchRecords_h

#include "TrianglePatches.h"
#include "vtkPatternNumberBuffer.h"

#include <algorithm>
#include <cstdint>
#include <vector>

struct vtkPatternPatchRecordBuffers
{
  vtkPatternNumberBuffer Shapes;
  vtkPatternNumberBuffer Weights;

  void Upload(vtkOpenGLRenderWindow* window, const hachure::PatchRecords& records)
  {
    this->Shapes.Upload(window, records.shapes, 4);
    this->Weights.Upload<glm::u8vec4, std::uint8_t>(window, records.weights, 4);
  }
  void Release(vtkWindow* window)
  {
    this->Shapes.Release(window);
    this->Weights.Release(window);
  }
};

class vtkPatternPatchRecords
{
public:
  using Owner = const void*;

  /// Replaces the records of one helper.
  void Store(Owner owner, hachure::PatchRecords records)
  {
    this->Find(owner).Records = std::move(records);
    ++this->Version;
  }

  void Forget(Owner owner)
  {
    const auto mine = [owner](const Part& part) { return part.Owner == owner; };
    this->Parts.erase(
      std::remove_if(this->Parts.begin(), this->Parts.end(), mine), this->Parts.end());
    ++this->Version;
  }

  /// Number of the first record of a helper in the list; remembered as the one that was drawn with.
  std::size_t Base(Owner owner)
  {
    Part& part = this->Find(owner);
    part.DrawnBase = this->CurrentBase(owner);
    return part.DrawnBase;
  }

  /// Whether a helper was drawn with a base that no longer holds, as another one before it in the
  /// list has changed since.
  bool IsDrawnWrong() const
  {
    return std::any_of(this->Parts.begin(), this->Parts.end(),
      [this](const Part& part) { return part.DrawnBase != this->CurrentBase(part.Owner); });
  }

  hachure::PatchRecords All() const
  {
    hachure::PatchRecords all;
    for (const Part& part : this->Parts)
    {
      const hachure::PatchRecords& own = part.Records;
      all.shapes.insert(all.shapes.end(), own.shapes.begin(), own.shapes.end());
      all.weights.insert(all.weights.end(), own.weights.begin(), own.weights.end());
    }
    return all;
  }

  unsigned long GetVersion() const { return this->Version; }

private:
  struct Part
  {
    vtkPatternPatchRecords::Owner Owner;
    hachure::PatchRecords Records;
    std::size_t DrawnBase = 0;
  };

  Part& Find(Owner owner)
  {
    for (Part& part : this->Parts)
    {
      if (part.Owner == owner)
      {
        return part;
      }
    }
    this->Parts.push_back({ owner, {}, 0 });
    return this->Parts.back();
  }

  std::size_t CurrentBase(Owner owner) const
  {
    std::size_t texels = 0;
    for (const Part& part : this->Parts)
    {
      if (part.Owner == owner)
      {
        break;
      }
      texels += part.Records.shapes.size();
    }
    return texels / hachure::recordShapes;
  }

  std::vector<Part> Parts; // in the order in which helpers came
  unsigned long Version = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternPatchRecords.h
