// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Finds out with other processes, each of which draws a part of the scene, what samples are
 * visible.
 */
#ifndef vtkPatternSharedVisibility_h
#define vtkPatternSharedVisibility_h

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkMultiProcessController;

namespace vtkPattern
{
class SharedVisibility
{
public:
  explicit SharedVisibility(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  /// An object's samples, as vtkPatternVisibility::ReadNearest() gives them; none where they were
  /// not measured. count: how many there are. Every process adds the same objects.
  void Add(const std::vector<std::uint32_t>& nearest, std::size_t count);

  /// With all processes. False in all of them where nothing was measured, or not the same.
  bool Exchange();

  /// Visibility of an object's samples, in the order of Add(); none where they were not measured.
  std::vector<std::uint8_t> Get(std::size_t object) const;

private:
  bool AgreesWithOthers() const;

  vtkMultiProcessController* Controller;
  std::vector<std::uint32_t> Nearest; // of all objects
  std::vector<std::size_t> Starts = { 0 };
  std::uint64_t Layout = 0; // a hash
};
} // namespace vtkPattern

#endif
// VTK-HeaderTest-Exclude: vtkPatternSharedVisibility.h
