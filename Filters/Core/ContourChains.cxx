// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourSegments.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>

namespace hachure
{
namespace
{

// One end of a piece at a node.
struct SegmentEnd
{
  std::int64_t node = 0;
  std::int32_t segment = 0;
  bool second = false; // which end of the piece

  bool operator<(const SegmentEnd& other) const
  {
    return this->node != other.node    ? this->node < other.node
      : this->segment != other.segment ? this->segment < other.segment
                                       : this->second < other.second;
  }
};

class Chainer
{
public:
  explicit Chainer(const std::vector<ContourSegment>& segments)
    : next(2 * segments.size(), none)
    , isTaken(segments.size(), 0)
  {
    std::vector<SegmentEnd> ends;
    ends.reserve(2 * segments.size());
    for (std::size_t i = 0; i < segments.size(); ++i)
    {
      const auto segment = static_cast<std::int32_t>(i);
      ends.push_back({ segments[i].nodes[0], segment, false });
      ends.push_back({ segments[i].nodes[1], segment, true });
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t begin = 0; begin < ends.size();)
    {
      std::size_t end = begin + 1;
      while (end < ends.size() && ends[end].node == ends[begin].node)
      {
        ++end;
      }
      if (end - begin == 2)
      {
        this->join(ends[begin], ends[begin + 1]);
      }
      else if (end - begin <= mostAtNode)
      {
        this->joinStraight(segments, { &ends[begin], end - begin });
      }
      begin = end;
    }
  }

  std::vector<ContourChain> chains()
  {
    std::vector<ContourChain> result;
    for (std::int32_t end = 0; end < static_cast<std::int32_t>(this->next.size()); ++end)
    {
      if (this->next[end] == none && !this->isTaken[end / 2])
      {
        result.push_back(this->follow(end));
      }
    }
    for (std::int32_t end = 0; end < static_cast<std::int32_t>(this->next.size()); end += 2)
    {
      if (!this->isTaken[end / 2])
      {
        result.push_back(this->follow(end));
        result.back().closed = true;
      }
    }
    return result;
  }

private:
  static constexpr std::int32_t none = -1;
  // Where more pieces meet, as at the pole of a globe, none goes on.
  static constexpr std::size_t mostAtNode = 8;
  // Cosine of the sharpest turn of a line where it crosses others.
  static constexpr double sharpestTurn = 0.5;

  static std::int32_t indexOf(const SegmentEnd& end)
  {
    return 2 * end.segment + (end.second ? 1 : 0);
  }

  void join(const SegmentEnd& a, const SegmentEnd& b)
  {
    this->next[indexOf(a)] = indexOf(b);
    this->next[indexOf(b)] = indexOf(a);
  }

  // Of lines that cross, those go on into each other which turn least.
  void joinStraight(const std::vector<ContourSegment>& segments, Span<const SegmentEnd> ends)
  {
    struct Turn
    {
      double cosine;
      std::size_t a, b;
    };
    std::vector<Turn> turns;
    turns.reserve(ends.size() * ends.size() / 2);
    for (std::size_t a = 0; a < ends.size(); ++a)
    {
      for (std::size_t b = a + 1; b < ends.size(); ++b)
      {
        const double cosine =
          -glm::dot(directionFrom(segments, ends[a]), directionFrom(segments, ends[b]));
        if (cosine > sharpestTurn)
        {
          turns.push_back({ cosine, a, b });
        }
      }
    }
    std::stable_sort(turns.begin(), turns.end(),
      [](const Turn& first, const Turn& second) { return first.cosine > second.cosine; });
    for (const Turn& turn : turns)
    {
      if (this->next[indexOf(ends[turn.a])] == none && this->next[indexOf(ends[turn.b])] == none)
      {
        this->join(ends[turn.a], ends[turn.b]);
      }
    }
  }

  static glm::dvec3 directionFrom(
    const std::vector<ContourSegment>& segments, const SegmentEnd& end)
  {
    const ContourSegment& segment = segments[end.segment];
    const glm::dvec3 direction = (segment.ends[1] - segment.ends[0]) * (end.second ? -1.0 : 1.0);
    const double length = glm::length(direction);
    return length > 0.0 ? direction / length : glm::dvec3(0.0);
  }

  // From an end of a piece through it and on, as far as the way is not taken.
  ContourChain follow(std::int32_t end)
  {
    ContourChain chain;
    while (end != none && !this->isTaken[end / 2])
    {
      this->isTaken[end / 2] = 1;
      chain.links.push_back({ end / 2, end % 2 == 1 });
      end = this->next[end ^ 1];
    }
    return chain;
  }

  std::vector<std::int32_t> next; // per end, 2 * segment + which: the end it meets alone
  std::vector<char> isTaken;      // per segment
};

} // namespace

std::vector<ContourChain> chainContours(const std::vector<ContourSegment>& segments)
{
  return Chainer(segments).chains();
}

} // namespace hachure
