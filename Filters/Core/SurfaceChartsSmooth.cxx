// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceChartsSmooth.h"

#include "SurfaceChartsPlaces.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace hachure
{
namespace
{
std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}

// A triangle at a vertex: the vertices after it, and their part of its mean-value weights.
struct Wedge
{
  std::int32_t next;
  std::int32_t last;
  float nextWeight;
  float lastWeight;
  float area; // of the triangle in space
};

Wedge wedgeOf(const CornerMesh& mesh, const glm::ivec3& vertices, int corner)
{
  Wedge wedge = { vertices[(corner + 1) % 3], vertices[(corner + 2) % 3], 0.0f, 0.0f, 0.0f };
  const glm::dvec3& apex = mesh.position(vertices[corner]);
  const glm::dvec3 one = mesh.position(wedge.next) - apex;
  const glm::dvec3 other = mesh.position(wedge.last) - apex;
  const double lengthOne = glm::length(one);
  const double lengthOther = glm::length(other);
  const double area = glm::length(glm::cross(one, other));
  // The tangent of half the angle; nearly straight ones count no more than others.
  constexpr double most = 10.0;
  const double tangent =
    std::min(most, area / std::max(lengthOne * lengthOther + glm::dot(one, other), 1e-300));
  wedge.nextWeight = static_cast<float>(tangent / lengthOne);
  wedge.lastWeight = static_cast<float>(tangent / lengthOther);
  wedge.area = static_cast<float>(area);
  return wedge;
}

class Smoother
{
public:
  explicit Smoother(BaseMesh& aBase)
    : base(aBase)
    , first(aBase.mesh.positions.size() + 1, 0)
  {
    const std::vector<glm::ivec3>& triangles = this->base.mesh.fine;
    for (const glm::ivec3& triangle : triangles)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        ++this->first[indexOf(triangle[corner]) + 1];
      }
    }
    std::partial_sum(this->first.begin(), this->first.end(), this->first.begin());
    this->wedges.resize(this->first.back());
    std::vector<std::size_t> slots = this->first;
    for (const glm::ivec3& triangle : triangles)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        this->wedges[slots[indexOf(triangle[corner])]++] =
          wedgeOf(this->base.mesh, triangle, corner);
      }
    }
  }

  bool run(const ProgressFn& progress)
  {
    constexpr int rounds = 4; // later ones change little
    for (int round = 0; round < rounds; ++round)
    {
      if (progress && !progress(static_cast<double>(round) / rounds))
      {
        return false;
      }
      for (std::size_t vertex = 0; vertex + 1 < this->first.size(); ++vertex)
      {
        if (this->base.homes[vertex].triangle >= 0 && this->base.mesh.isBorder[vertex] == 0)
        {
          this->move(vertex);
        }
      }
    }
    return true;
  }

private:
  struct Side
  {
    glm::dvec2 next;
    glm::dvec2 last;
    double inverse; // of the area in space
  };

  // How the triangles around a vertex would lie.
  struct Fit
  {
    int flipped = 0;
    double worst = std::numeric_limits<double>::max(); // area in the plane against that in space

    bool operator<(const Fit& other) const
    {
      return this->flipped != other.flipped ? this->flipped > other.flipped
                                            : this->worst < other.worst;
    }
  };

  void move(std::size_t vertex)
  {
    const VertexHome home = this->base.homes[vertex];
    const glm::dvec3 own(1.0 - home.weights.x - home.weights.y, home.weights);
    this->sides.clear();
    glm::dvec2 sum(0.0);
    double weights = 0.0;
    for (std::size_t i = this->first[vertex]; i < this->first[vertex + 1]; ++i)
    {
      const Wedge& wedge = this->wedges[i];
      const auto next = vertexWeightsIn(this->base, wedge.next, home.triangle, own);
      const auto last = vertexWeightsIn(this->base, wedge.last, home.triangle, own);
      if (!next || !last)
      {
        return;
      }
      const Side side = { { next->y, next->z }, { last->y, last->z },
        1.0 / std::max(static_cast<double>(wedge.area), 1e-30) };
      this->sides.push_back(side);
      const double nextWeight = wedge.nextWeight;
      const double lastWeight = wedge.lastWeight;
      sum += nextWeight * side.next + lastWeight * side.last;
      weights += nextWeight + lastWeight;
    }
    glm::dvec2 mean = sum / weights;
    const Fit now = this->fitAt(home.weights);
    Fit then = this->fitAt(mean);
    if (now.flipped > 0 && then.flipped > 0)
    {
      this->improve(mean, then);
    }
    // Against the mean over the base triangle, whose area in the plane is 1/2.
    constexpr double goodEnough = 0.4;
    const double enough = goodEnough * 0.5 / this->base.areas[indexOf(home.triangle)];
    if (std::isfinite(mean.x + mean.y) && (now < then || then.worst > enough))
    {
      this->settle(vertex, home.triangle, glm::dvec3(1.0 - mean.x - mean.y, mean));
    }
  }

  // A better place between the mean and the neighbours, while triangles are turned over.
  void improve(glm::dvec2& place, Fit& fit) const
  {
    constexpr double steps[] = { 0.25, 0.5, 0.75, 0.9 };
    const glm::dvec2 mean = place;
    for (const Side& side : this->sides)
    {
      for (const double step : steps)
      {
        const glm::dvec2 tried = mean + step * (side.next - mean);
        const Fit found = this->fitAt(tried);
        if (fit < found)
        {
          place = tried;
          fit = found;
        }
      }
    }
  }

  Fit fitAt(const glm::dvec2& place) const
  {
    Fit fit;
    for (const Side& side : this->sides)
    {
      const glm::dvec2 one = side.next - place;
      const glm::dvec2 other = side.last - place;
      const double ratio = (one.x * other.y - one.y * other.x) * side.inverse;
      fit.flipped += ratio > 0.0 ? 0 : 1;
      fit.worst = std::min(fit.worst, ratio);
    }
    return fit;
  }

  // Over rims as far as it takes; at a border on it.
  void settle(std::size_t vertex, std::int32_t start, glm::dvec3 weights)
  {
    constexpr int mostRims = 4;
    std::int32_t triangle = start;
    for (int step = 0; step < mostRims; ++step)
    {
      const int edge =
        weights.x <= weights.y && weights.x <= weights.z ? 0 : (weights.y <= weights.z ? 1 : 2);
      const std::int32_t corner = 3 * triangle + edge;
      if (weights[edge] >= 0.0 || this->base.mesh.opposite(corner) < 0)
      {
        break;
      }
      weights = weightsBeyond(this->base, weights, corner);
      triangle = this->base.mesh.opposite(corner) / 3;
    }
    weights = glm::max(weights, glm::dvec3(0.0));
    weights /= weights.x + weights.y + weights.z;
    this->base.homes[vertex] = { triangle, glm::dvec2(weights.y, weights.z) };
  }

  BaseMesh& base;
  std::vector<std::size_t> first; // of every vertex
  std::vector<Wedge> wedges;
  std::vector<Side> sides;
};
} // namespace

bool smoothHomes(BaseMesh& base, const ProgressFn& progress)
{
  return Smoother(base).run(progress);
}

} // namespace hachure
