// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleTreeScene_h
#define hachure_StippleTreeScene_h

#include "StippleScene.h"
#include "StippleTree.h"

#include <glm/vector_relational.hpp>

#include <map>
#include <vector>

// Trees of stipples for tests, and the walk that a drawing does.
namespace hachure
{

inline StippleHierarchy baseOf(
  const Surface& surface, std::int64_t count, StippleOrder order = StippleOrder::Progressive)
{
  StippleOptions options;
  options.count = count;
  options.order = order;
  return stippleSurface(surface.mesh(), options);
}

inline glm::dvec3 placeOf(const StippleNode& node, std::int32_t i)
{
  return node.origin + glm::dvec3(node.place(0)[i], node.place(1)[i], node.place(2)[i]);
}

inline glm::vec3 directionOf(const StippleNode& node, std::int32_t i)
{
  return { node.normal(0)[i], node.normal(1)[i], node.normal(2)[i] };
}

struct Box
{
  glm::dvec3 low{ -1e300 }, high{ 1e300 };

  bool meets(const StippleBounds& bounds) const
  {
    return glm::all(glm::lessThanEqual(this->low, bounds.high)) &&
      glm::all(glm::greaterThanEqual(this->high, bounds.low));
  }
  bool holds(const glm::dvec3& place) const
  {
    return glm::all(glm::lessThanEqual(this->low, place)) &&
      glm::all(glm::lessThan(place, this->high));
  }
};

inline Box boxAround(const glm::dvec3& middle, const glm::dvec3& size)
{
  return { middle - 0.5 * size, middle + 0.5 * size };
}

// Calls visit(node, index of the node) for all that are reached from the root.
template <class Visit>
void visitNodes(const StippleTree& tree, const Box& box, Visit&& visit)
{
  std::vector<std::int32_t> open;
  if (!tree.nodes().empty())
  {
    open.push_back(0);
  }
  while (!open.empty())
  {
    const std::int32_t index = open.back();
    const StippleNode& node = tree.node(index);
    open.pop_back();
    if (box.meets(node.bounds))
    {
      visit(node, index);
      open.insert(open.end(), node.children.begin(), node.children.begin() + node.childCount);
    }
  }
}

// Asks for all that is missing in a box until nothing is.
inline bool refineIn(StippleTree& tree, const Box& box, double density)
{
  while (true)
  {
    std::vector<StippleRequest> requests;
    visitNodes(tree, box,
      [&](const StippleNode& node, std::int32_t index)
      {
        if (node.childCount == 0 && density > node.heldDensity)
        {
          requests.push_back({ index, density });
        }
      });
    if (requests.empty() || !tree.refine(requests))
    {
      return requests.empty();
    }
  }
}

// Places of all points in a box up to a density.
inline std::vector<glm::dvec3> pointsIn(const StippleTree& tree, const Box& box, double density)
{
  std::vector<glm::dvec3> points;
  visitNodes(tree, box,
    [&](const StippleNode& node, std::int32_t)
    {
      for (std::int32_t i = 0; i < node.count; ++i)
      {
        if (static_cast<double>(node.density()[i]) <= density && box.holds(placeOf(node, i)))
        {
          points.push_back(placeOf(node, i));
        }
      }
    });
  return points;
}

// What must be the same in two trees, by name.
struct NamedPoint
{
  glm::dvec3 place;
  float density;

  bool operator==(const NamedPoint& other) const
  {
    return this->place == other.place && this->density == other.density;
  }
};

inline std::map<std::uint64_t, NamedPoint> namedPoints(const StippleTree& tree)
{
  std::map<std::uint64_t, NamedPoint> result;
  visitNodes(tree, Box(),
    [&](const StippleNode& node, std::int32_t index)
    {
      for (std::int32_t i = 0; i < node.count; ++i)
      {
        result[tree.identity(index, i)] = { placeOf(node, i), node.density()[i] };
      }
    });
  return result;
}

} // namespace hachure

#endif
