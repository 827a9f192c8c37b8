// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseTriangleOrder_h
#define hachure_NoiseTriangleOrder_h

#include "TriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <type_traits>

namespace hachure
{

// Memory without values; large blocks in large pages where the system has them, which is several
// times as fast to fill for the first time on a virtual machine. Freed by std::free.
void* allocateUninitialised(std::size_t bytes);

// An array whose elements have no values at first: memory is met by the threads that fill it, once.
template <class T>
class UninitialisedArray
{
public:
  explicit UninitialisedArray(std::size_t size = 0)
    : elements(static_cast<T*>(allocateUninitialised(size * sizeof(T))))
    , count(size)
  {
    static_assert(std::is_trivial_v<T>, "no constructor runs");
  }

  std::size_t size() const { return this->count; }
  T& operator[](std::size_t index) { return this->elements.get()[index]; }
  const T& operator[](std::size_t index) const { return this->elements.get()[index]; }

private:
  struct Free
  {
    void operator()(T* memory) const { std::free(memory); }
  };
  std::unique_ptr<T, Free> elements;
  std::size_t count;
};

// The triangles sorted by the coarse cells of a grid in which their first corners are, cells in
// Morton order; within a cell in the order of the mesh. Wrong corners are not met.
UninitialisedArray<std::int32_t> orderNoiseTriangles(const TriangleMesh& mesh);

} // namespace hachure

#endif
