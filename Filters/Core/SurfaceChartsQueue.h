// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceChartsQueue_h
#define hachure_SurfaceChartsQueue_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure
{

// Internal: vertices by what they cost, cheap ones first; about equal ones in the order they came
// in, so that they are taken evenly from all over the surface.
class VertexQueue
{
public:
  explicit VertexQueue(std::size_t vertices)
    : versions(vertices, 0)
  {
  }

  // Replaces what the vertex had.
  void push(std::int32_t vertex, double cost)
  {
    constexpr double perOctave = 6.0;
    constexpr int zero = 2 * count / 3; // the bin of cost 1
    const double bin = cost > 0.0 ? std::floor(perOctave * std::log2(cost)) + zero : 0.0;
    const auto place = static_cast<std::size_t>(std::clamp(bin, 0.0, count - 1.0));
    const std::int32_t version = ++this->versions[static_cast<std::size_t>(vertex)];
    this->bins[place].entries.push_back({ vertex, version });
    this->lowest = std::min(this->lowest, place);
  }

  // -1: empty.
  std::int32_t pop()
  {
    for (; this->lowest < count; ++this->lowest)
    {
      Bin& bin = this->bins[this->lowest];
      while (bin.first < bin.entries.size())
      {
        const Entry entry = bin.entries[bin.first++];
        if (this->versions[static_cast<std::size_t>(entry.vertex)] == entry.version)
        {
          return entry.vertex;
        }
      }
      bin = Bin();
    }
    return -1;
  }

  void clear()
  {
    this->bins.fill(Bin());
    this->lowest = count;
  }

private:
  static constexpr int count = 288;

  struct Entry
  {
    std::int32_t vertex;
    std::int32_t version;
  };
  struct Bin
  {
    std::vector<Entry> entries;
    std::size_t first = 0;
  };

  std::array<Bin, count> bins;
  std::size_t lowest = count;
  std::vector<std::int32_t> versions;
};

} // namespace hachure

#endif
