// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternSharedVisibility.h"

#include "Random.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkType.h"

namespace vtkPattern
{
void SharedVisibility::Add(const std::vector<std::uint32_t>& nearest, std::size_t count)
{
  this->Nearest.insert(this->Nearest.end(), nearest.begin(), nearest.end());
  this->Starts.push_back(this->Nearest.size());
  this->Layout = hachure::hashPair(hachure::hashPair(this->Layout, count), nearest.size());
}

bool SharedVisibility::AgreesWithOthers() const
{
  const auto layout = static_cast<long long>(this->Layout >> 1);
  const long long own[2] = { layout, -layout };
  long long most[2] = { 0, 0 };
  this->Controller->AllReduce(own, most, 2, vtkCommunicator::MAX_OP);
  return most[0] == -most[1];
}

bool SharedVisibility::Exchange()
{
  if (!this->AgreesWithOthers() || this->Nearest.empty())
  {
    return false;
  }
  std::vector<std::uint32_t> nearest(this->Nearest.size());
  const bool done = this->Controller->AllReduce(this->Nearest.data(), nearest.data(),
                      static_cast<vtkIdType>(nearest.size()), vtkCommunicator::MIN_OP) != 0;
  this->Nearest.swap(nearest);
  return done;
}

std::vector<std::uint8_t> SharedVisibility::Get(std::size_t object) const
{
  std::vector<std::uint8_t> bytes;
  bytes.reserve(this->Starts[object + 1] - this->Starts[object]);
  for (std::size_t i = this->Starts[object]; i < this->Starts[object + 1]; ++i)
  {
    bytes.push_back(static_cast<std::uint8_t>(this->Nearest[i] & 0xff));
  }
  return bytes;
}
} // namespace vtkPattern
