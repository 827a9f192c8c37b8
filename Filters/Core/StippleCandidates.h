// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleCandidates_h
#define hachure_StippleCandidates_h

#include "StippleSurface.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

// Places at which the next points of a hierarchy may be.
namespace hachure
{

class StippleNeighbourhood;

// Lengths as in StippleFrame.
struct StippleCandidate
{
  glm::vec3 place{ 0.0f };
  glm::vec3 normal{ 0.0f };
  float crowding = 0.0f;     // by all points near it, see StippleNeighbourhood
  std::int32_t triangle = 0; // or point
  float weights[2] = { 0.0f, 0.0f };
};

// Numbered candidates, as many as wanted, evenly spread over all there is.
class StippleSource
{
public:
  virtual ~StippleSource() = default;
  // Sets out to give about `wanted` in one octave of the search, and returns the number of those to
  // ask for.
  virtual std::int64_t prepare(std::int64_t wanted, std::uint32_t octave) = 0;
  // Appends those from begin to end that are not more crowded than the limit, and may leave out
  // others without a look at them. Returns the least crowding of those it has seen and left out, or
  // infinity. Called from several threads.
  virtual float make(std::int64_t begin, std::int64_t end, const StippleNeighbourhood& around,
    float mostCrowded, std::vector<StippleCandidate>& result) const = 0;
  // Whether every further octave has the same candidates.
  virtual bool isExhausted() const = 0;
};

// On a surface there are always others.
class StippleSurfaceSource : public StippleSource
{
public:
  StippleSurfaceSource(const StippleSurface& someSurface, std::uint32_t someSeed)
    : surface(someSurface)
    , seed(someSeed)
  {
  }
  std::int64_t prepare(std::int64_t wanted, std::uint32_t octave) override;
  float make(std::int64_t begin, std::int64_t end, const StippleNeighbourhood& around,
    float mostCrowded, std::vector<StippleCandidate>& result) const override;
  bool isExhausted() const override { return false; }

private:
  const StippleSurface& surface;
  std::uint32_t seed;
  std::uint32_t octaveSeed = 0;
  std::int64_t strata = 1;
};

// Given points.
class StipplePointSource : public StippleSource
{
public:
  StipplePointSource(Span<const glm::dvec3> somePoints, Span<const glm::dvec3> someNormals,
    const StippleFrame& aFrame, std::uint32_t someSeed)
    : points(somePoints)
    , normals(someNormals)
    , frame(aFrame)
    , seed(someSeed)
  {
  }
  std::int64_t prepare(std::int64_t wanted, std::uint32_t octave) override;
  float make(std::int64_t begin, std::int64_t end, const StippleNeighbourhood& around,
    float mostCrowded, std::vector<StippleCandidate>& result) const override;
  bool isExhausted() const override { return this->share >= 1.0; }

private:
  Span<const glm::dvec3> points, normals;
  StippleFrame frame;
  std::uint32_t seed;
  double share = 0.0; // of the points that take part
};

} // namespace hachure

#endif
