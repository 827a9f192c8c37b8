// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleRefinement_h
#define hachure_StippleRefinement_h

#include "StippleCube.h"
#include "StippleFilling.h"
#include "StippleNode.h"
#include "StippleShape.h"
#include "StippleTriangles.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <unordered_map>
#include <vector>

namespace hachure
{

// Makes further nodes of a tree. The points of a cube depend on those of coarser levels around it,
// and on the neighbours of its own level with a lower *colour*: there are eight, by whether the
// cell's three numbers are even or odd, so that no two neighbours have the same. Those that a cube
// depends on are made first. So what comes out does not depend on what was asked for.
class StippleRefinement
{
public:
  StippleRefinement(StippleTriangles someTriangles, std::uint32_t aSeed)
    : triangles(std::move(someTriangles))
    , seed(aSeed)
  {
  }

  // What is worked on.
  struct Work
  {
    std::vector<StippleNode>& nodes;
    const StippleShape& shape;
    const StippleLevels& levels;
    std::size_t room = 0;                 // bytes that there may be more
    std::function<bool(double)> progress; // of the level; false stops
  };

  const StippleTriangles& surface() const { return this->triangles; }
  void enterBase(const std::vector<StippleNode>& nodes);
  // Makes the children of nodes that have none. False if the room is not enough, or it was stopped.
  bool refine(Work& work, const std::vector<std::int32_t>& parents);
  void forget(std::size_t baseCount);

  std::size_t memory() const; // without the nodes

private:
  using Codes = std::set<std::uint64_t>;

  bool isMade(std::uint64_t code) const { return this->nodeOf.count(code) > 0; }
  bool meetsSurface(const StippleCube& cube, const StippleLevels& levels);
  // Adds a cube with all it depends on that is not made.
  void need(
    const StippleCube& cube, const StippleLevels& levels, std::map<std::int32_t, Codes>& needed);
  bool make(Work& work, const Codes& level);
  bool makeColour(Work& work, const std::vector<std::uint64_t>& codes);
  StippleNode fill(const Work& work, std::uint64_t code) const;
  void gather(const Work& work, StippleFilling& filling) const;
  void gatherFrom(
    const Work& work, const StippleCube& cube, double reach, StippleFilling& filling) const;
  void enter(Work& work, StippleNode&& node);
  void link(Work& work, const Codes& made);

  StippleTriangles triangles;
  std::uint32_t seed;
  std::unordered_map<std::uint64_t, std::int32_t> nodeOf; // by code
};

} // namespace hachure

#endif
