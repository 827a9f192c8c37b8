// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_HemisphereTable_h
#define hachure_HemisphereTable_h

#include "Span.h"
#include "ViewTextureColors.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hachure
{

// The directions of a node's hemisphere, side * side of them row by row, and how what is stored in
// one node's frame is read in another one's.
class HemisphereTable
{
public:
  HemisphereTable(HemisphereMap map, int side);

  std::size_t size() const { return this->localDirections.size(); }
  // In the node's frame, of unit length.
  Span<const glm::vec3> directions() const { return this->localDirections; }
  // In model coordinates.
  void directionsIn(const glm::quat& turn, Span<glm::vec3> found) const;

  // Where the directions of one frame lie among those of another one.
  struct Taps
  {
    bool isSame = false; // one by one
    struct Tap
    {
      std::uint16_t first = 0; // of four: it, the next one, and both of the next row
      glm::vec2 share{ 0.0f }; // of the next one and of the next row
    };
    std::vector<Tap> taps;
  };
  // The taps keep their memory.
  void findTaps(const glm::quat& turn, const glm::quat& sourceTurn, Taps& taps) const;
  // Adds weight * source to the sums, read with four taps.
  void add(const Taps& taps, float weight, const glm::vec4* source, glm::vec4* sums) const;
  // Sets the flags whose nearest tap is set in the source.
  void join(const Taps& taps, const std::uint8_t* source, std::uint8_t* flags) const;

private:
  glm::vec2 squareOf(const glm::vec3& direction) const;

  HemisphereMap map;
  int side;
  std::vector<glm::vec3> localDirections;
};

} // namespace hachure

#endif
