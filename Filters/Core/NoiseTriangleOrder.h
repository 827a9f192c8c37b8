// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseTriangleOrder_h
#define hachure_NoiseTriangleOrder_h

#include "TriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace hachure
{

// An array whose elements have no values at first: memory is met by the threads that fill it, once.
template <class T>
class UninitialisedArray
{
public:
  explicit UninitialisedArray(std::size_t size = 0)
    : elements(new T[size])
    , count(size)
  {
  }

  std::size_t size() const { return this->count; }
  T& operator[](std::size_t index) { return this->elements[index]; }
  const T& operator[](std::size_t index) const { return this->elements[index]; }

private:
  std::unique_ptr<T[]> elements;
  std::size_t count;
};

// The triangles sorted by the coarse cells of a grid in which their first corners are, cells in
// Morton order; within a cell in the order of the mesh. Wrong corners are not met.
UninitialisedArray<std::int32_t> orderNoiseTriangles(const TriangleMesh& mesh);

} // namespace hachure

#endif
