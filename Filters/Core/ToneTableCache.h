// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ToneTableCache_h
#define hachure_ToneTableCache_h

#include "ToneTable.h"

#include <memory>
#include <mutex>
#include <vector>

namespace hachure
{

// Tone tables for as long as somebody holds them: a table that is equal in all that it depends on,
// the tile and the options, is measured once for all who ask. Safe to use from several threads.
class ToneTableCache
{
public:
  using Mips = std::shared_ptr<const std::vector<PatternTile>>;
  using Table = std::shared_ptr<const ToneTable>;

  // Tiles are told apart by their address, so `mips` must not change.
  Table get(const Mips& mips, const ToneTableOptions& options);

  // Tables measured so far.
  std::size_t builds() const;

private:
  struct Entry
  {
    std::weak_ptr<const std::vector<PatternTile>> mips;
    std::weak_ptr<const ToneTable> table;
  };
  mutable std::mutex mutex;
  std::vector<Entry> entries;
  std::size_t numberOfBuilds = 0;
};

} // namespace hachure

#endif
