// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleLife.h"

#include "StippleTransfer.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

// Lays those that shrink away onto the next surface.
class LeavingStipples
{
public:
  LeavingStipples(LivingStipples& target, float step)
    : result(target)
    , change(step)
  {
  }

  void add(const StipplePoint& moved, double density, float share)
  {
    const float left = share - this->change;
    // Less than a thousandth is rounding.
    if (moved.triangle >= 0 && left > 1e-3f)
    {
      this->result.leaving.push_back(moved);
      this->result.leavingDensities.push_back(density);
      this->result.leavingShares.push_back(left);
    }
  }

private:
  LivingStipples& result;
  float change;
};

float shareOf(const LivingStipples& stipples, std::size_t index)
{
  return stipples.shares.empty() ? 1.0f : stipples.shares[index];
}

// The stipples of the surface before, and after them those that were leaving it.
std::vector<CarriedStipple> allOf(const TriangleMesh& mesh, const LivingStipples& before)
{
  std::vector<CarriedStipple> all = carriedStipples(mesh, before.hierarchy);
  all.reserve(all.size() + before.leaving.size());
  for (const StipplePoint& point : before.leaving)
  {
    all.push_back(
      { stipplePosition(mesh, point), triangleAreaVector(mesh, point.triangle), point.spacing });
  }
  return all;
}

} // namespace

LivingStipples carryLiving(const TriangleMesh& mesh, const LivingStipples& before,
  const TriangleMesh& nextMesh, int life, const StippleOptions& options, double reach)
{
  if (life < 1)
  {
    throw std::invalid_argument("life: " + std::to_string(life) + ", expected 1 or more");
  }
  checkTriangleMesh(mesh);
  const std::size_t count = before.hierarchy.points.size();
  const std::vector<CarriedStipple> old = allOf(mesh, before);
  const double area = before.hierarchy.area;
  LivingStipples result;
  std::vector<std::int32_t> origins;
  std::vector<StipplePoint> moved;
  result.hierarchy = carryStipples(nextMesh, old, area, options, origins, reach, &moved);
  const float step = 1.0f / static_cast<float>(life);
  std::vector<char> isKept(old.size(), 0);
  result.shares.reserve(origins.size());
  for (const std::int32_t origin : origins)
  {
    float share = 0.0f;
    if (origin >= 0)
    {
      const auto index = static_cast<std::size_t>(origin);
      share = index < count ? shareOf(before, index) : before.leavingShares[index - count];
      isKept[index] = 1;
    }
    // Where there was nothing before, nothing has to be waited for.
    result.shares.push_back(count == 0 ? 1.0f : std::min(1.0f, share + step));
  }
  LeavingStipples leaving(result, step);
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    if (isKept[i] != 0)
    {
      continue;
    }
    const bool isPresent = i < count;
    leaving.add(moved[i],
      isPresent ? static_cast<double>(i + 1) / area : before.leavingDensities[i - count],
      isPresent ? shareOf(before, i) : before.leavingShares[i - count]);
  }
  return result;
}

} // namespace hachure
