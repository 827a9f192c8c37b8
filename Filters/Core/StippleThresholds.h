// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleThresholds_h
#define hachure_StippleThresholds_h

#include "StippleHierarchy.h"
#include "TriangleMesh.h"

#include <vector>

namespace hachure
{

// The shortest edges of a classic hierarchy: so many of its stipples have all edges longer than a
// length. Where it has been split evenly, their number falls with the square of the length
// (stippleEdgeCrowd); what collapses of the mesh have ordered differs from that.
class StippleEdgeLengths
{
public:
  StippleEdgeLengths() = default;
  // On the reference mesh. Points and neighbours are checked.
  StippleEdgeLengths(const TriangleMesh& reference, const StippleHierarchy& hierarchy);

  struct Group
  {
    double length; // the shortest edge of about all of them
    double count;
  };
  // The longest first; without those that have no neighbours.
  const std::vector<Group>& groups() const { return this->all; }
  double alwaysDrawn() const { return this->without; } // number of those without neighbours
  double area() const { return this->wholeArea; }
  // Stipples with longer edges are spread evenly. Shorter ones are there in some places only.
  double least() const { return this->leastLength; }

private:
  std::vector<Group> all;
  double without = 0.0;
  double wholeArea = 0.0;
  double leastLength = 0.0;
};

// Which shortest edge makes a density, of stipples that grow with their shortest edge.
class StippleThresholds
{
public:
  // growth: stipples are grown where their shortest edge is by this share longer than the
  // threshold; 0: everywhere.
  StippleThresholds(const StippleEdgeLengths& lengths, double growth);

  double growth() const { return this->ownGrowth; }
  // Densities are numbers of grown discs per area of the reference mesh: those that grow count with
  // their share of the area. The threshold of the highest density is the shortest.
  double highest() const { return this->densities.empty() ? 0.0 : this->densities.back(); }
  // Falls as the density rises; not below that of the highest. density: > 0.
  double threshold(double density) const;

private:
  double ownGrowth;
  std::vector<double> densities; // rising
  std::vector<double> lengths;   // falling
};

} // namespace hachure

#endif
