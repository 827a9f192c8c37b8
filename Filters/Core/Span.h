// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_Span_h
#define hachure_Span_h

#include <cassert>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace hachure
{

// A pointer and a number of elements that someone else owns, as std::span has them from C++20 on.
// Span<const T> only reads. A span never outlives the vector or array it was made from.
template <class T>
class Span
{
public:
  using value_type = std::remove_cv_t<T>;
  using iterator = T*;

  constexpr Span() = default;
  constexpr Span(T* data, std::size_t size)
    : first(data)
    , count(size)
  {
  }
  Span(std::vector<value_type>& values)
    : first(values.data())
    , count(values.size())
  {
  }
  template <class U = T, class = std::enable_if_t<std::is_const_v<U>>>
  Span(const std::vector<value_type>& values)
    : first(values.data())
    , count(values.size())
  {
  }
  template <std::size_t N>
  constexpr Span(T (&values)[N])
    : first(values)
    , count(N)
  {
  }
  template <class U, class = std::enable_if_t<std::is_same_v<const U, T>>>
  constexpr Span(Span<U> other)
    : first(other.data())
    , count(other.size())
  {
  }

  constexpr T* data() const { return this->first; }
  constexpr std::size_t size() const { return this->count; }
  constexpr bool empty() const { return this->count == 0; }
  constexpr T* begin() const { return this->first; }
  constexpr T* end() const { return this->first + this->count; }
  constexpr T& front() const { return (*this)[0]; }
  constexpr T& back() const { return (*this)[this->count - 1]; }
  constexpr T& operator[](std::size_t index) const
  {
    assert(index < this->count);
    return this->first[index];
  }
  // The `size` elements from `offset` on; both must lie inside.
  constexpr Span subspan(std::size_t offset, std::size_t size) const
  {
    assert(offset <= this->count && size <= this->count - offset);
    return Span(this->first + offset, size);
  }

private:
  T* first = nullptr;
  std::size_t count = 0;
};

} // namespace hachure

#endif
