// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_CellBlocks_h
#define hachure_CellBlocks_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure
{

// As many values for each of some cells: most cells have nothing that is seen from some directions
// only.
template <class T>
class CellBlocks
{
public:
  CellBlocks(std::int32_t cells, std::size_t blockSize)
    : places(static_cast<std::size_t>(cells), -1)
    , size(blockSize)
  {
  }
  bool has(std::int32_t cell) const { return this->places[static_cast<std::size_t>(cell)] >= 0; }
  T* of(std::int32_t cell)
  {
    const std::int64_t place = this->places[static_cast<std::size_t>(cell)];
    return place < 0 ? nullptr : &this->values[static_cast<std::size_t>(place) * this->size];
  }
  const T* of(std::int32_t cell) const { return const_cast<CellBlocks*>(this)->of(cell); }
  // Gives those cells that have none a block of zeros.
  void add(const std::vector<std::int32_t>& cells)
  {
    auto count = static_cast<std::int32_t>(this->values.size() / this->size);
    for (const std::int32_t cell : cells)
    {
      if (!this->has(cell))
      {
        this->places[static_cast<std::size_t>(cell)] = count++;
      }
    }
    this->values.resize(static_cast<std::size_t>(count) * this->size, T(0));
  }

private:
  std::vector<std::int32_t> places;
  std::vector<T> values;
  std::size_t size;
};

} // namespace hachure

#endif
