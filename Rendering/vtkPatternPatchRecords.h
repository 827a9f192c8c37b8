// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The records of triangles on which patches overlap, of all helpers that draw one mapper's blocks,
 * in one list for the screen pass.
 */
#ifndef vtkPatternPatchRecords_h
#define vtkPatternPatchRecords_h

#include "TrianglePatches.h"

#include <algorithm>
#include <vector>

class vtkPatternPatchRecords
{
public:
  using Owner = const void*;

  /// Replaces the records of one helper.
  void Store(Owner owner, std::vector<glm::vec4> records)
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

  std::vector<glm::vec4> All() const
  {
    std::vector<glm::vec4> all;
    for (const Part& part : this->Parts)
    {
      all.insert(all.end(), part.Records.begin(), part.Records.end());
    }
    return all;
  }

  unsigned long GetVersion() const { return this->Version; }

private:
  struct Part
  {
    vtkPatternPatchRecords::Owner Owner;
    std::vector<glm::vec4> Records;
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
      texels += part.Records.size();
    }
    return texels / hachure::patchRecordTexels;
  }

  std::vector<Part> Parts; // in the order in which helpers came
  unsigned long Version = 0;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternPatchRecords.h
