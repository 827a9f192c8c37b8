// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ToneTableCache.h"

#include "TileChecks.h"

#include <algorithm>

namespace hachure
{

ToneTableCache::Table ToneTableCache::get(const Mips& mips, const ToneTableOptions& options)
{
  if (!mips)
  {
    check::fail("ToneTableCache::get", "mips", "none given");
  }
  const std::lock_guard<std::mutex> lock(this->mutex);
  this->entries.erase(
    std::remove_if(this->entries.begin(), this->entries.end(),
      [](const Entry& entry) { return entry.mips.expired() || entry.table.expired(); }),
    this->entries.end());
  for (const Entry& entry : this->entries)
  {
    Table table = entry.table.lock();
    if (table && entry.mips.lock() == mips && table->options == options)
    {
      return table;
    }
  }
  Table table = std::make_shared<const ToneTable>(buildToneTable(*mips, options));
  ++this->numberOfBuilds;
  this->entries.push_back({ mips, table });
  return table;
}

std::size_t ToneTableCache::builds() const
{
  const std::lock_guard<std::mutex> lock(this->mutex);
  return this->numberOfBuilds;
}

} // namespace hachure
