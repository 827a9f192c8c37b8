// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleCells.h"

#include "ParallelSort.h"

namespace hachure
{

namespace
{

struct Named
{
  std::uint64_t name;
  std::int32_t member;

  bool operator<(const Named& other) const
  {
    return this->name != other.name ? this->name < other.name : this->member < other.member;
  }
};

} // namespace

StippleCells::StippleCells(const std::vector<std::uint64_t>& names)
{
  std::vector<Named> sorted(names.size());
  parallelFor(static_cast<std::int64_t>(names.size()),
    [&](std::int64_t i)
    {
      sorted[static_cast<std::size_t>(i)] = { names[static_cast<std::size_t>(i)],
        static_cast<std::int32_t>(i) };
    });
  parallelSort(sorted);
  this->members.reserve(sorted.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    if (i == 0 || sorted[i].name != sorted[i - 1].name)
    {
      this->cellNames.push_back(sorted[i].name);
      this->ranges.push_back({ static_cast<std::int32_t>(i), static_cast<std::int32_t>(i) });
    }
    ++this->ranges.back().end;
    this->members.push_back(sorted[i].member);
  }
  std::size_t slotCount = 2;
  for (this->shift = 63; slotCount < 2 * this->ranges.size(); slotCount *= 2)
  {
    --this->shift;
  }
  this->slots.assign(slotCount, -1);
  for (std::size_t i = 0; i < this->cellNames.size(); ++i)
  {
    std::size_t slot = this->slotOf(this->cellNames[i]);
    while (this->slots[slot] >= 0)
    {
      slot = (slot + 1) & (slotCount - 1);
    }
    this->slots[slot] = static_cast<std::int32_t>(i);
  }
}

} // namespace hachure
