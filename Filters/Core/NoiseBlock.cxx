// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NoiseBlock.h"

#include "NoiseFieldLanes.h"

#include <glm/geometric.hpp>

namespace hachure
{

namespace
{

// A triangle seen edge-on crosses the whole range of depths within one pixel; it is no steeper.
constexpr float steepest = 1.0f;
constexpr float leastNumber = 1e-30f;

struct LaneVector
{
  FloatLanes x, y, z;
};

HACHURE_INLINED void loadVector(const NoiseBlock::Vectors& from, LaneVector& result)
{
  result.x = loadLanes(from.x.data());
  result.y = loadLanes(from.y.data());
  result.z = loadLanes(from.z.data());
}

HACHURE_INLINED FloatLanes dotLanes(const glm::vec3& row, const LaneVector& vector)
{
  return vector.x * row.x + vector.y * row.y + vector.z * row.z;
}

HACHURE_INLINED FloatLanes atLanes(const glm::vec4& row, const LaneVector& place)
{
  return place.x * row.x + place.y * row.y + (place.z * row.z + row.w);
}

HACHURE_INLINED FloatLanes alongLanes(const glm::vec4& row, const LaneVector& direction)
{
  return direction.x * row.x + direction.y * row.y + direction.z * row.z;
}

// Of places divided by w.
struct LaneClip
{
  FloatLanes x, y, z, inverse;
};

// Changes of the image along a direction in the surface, times w, in pixels.
HACHURE_INLINED void changeLanes(const NoiseBlockView& view, const LaneClip& clip,
  const LaneVector& direction, FloatLanes& x, FloatLanes& y)
{
  const FloatLanes w = alongLanes(view.rowW, direction);
  x = (alongLanes(view.rowX, direction) - clip.x * w) * view.size.x;
  y = (alongLanes(view.rowY, direction) - clip.y * w) * view.size.y;
}

// The angle of (x, y).
HACHURE_INLINED FloatLanes angleLanes(const FloatLanes& x, const FloatLanes& y)
{
  const FloatLanes angle = turnShareLanes(x, y) * glsl::screenPi;
  return chooseLanes(y, angle, 0.0f - angle);
}

// The rotation that is closest to the change of the image over the surface, both without units:
// that of its polar decomposition. facing: the sign of the image's area.
HACHURE_INLINED FloatLanes turnAngle(const NoiseBlockView& view, const NoiseBlock& block,
  const LaneClip& clip, const LaneVector& normal, const FloatLanes& facing)
{
  LaneVector tangent, across;
  loadVector(block.tangent, tangent);
  const FloatLanes square = normal.x * normal.x + normal.y * normal.y + normal.z * normal.z;
  const FloatLanes scale = 1.0f / (rootLanes(square) + leastNumber);
  across.x = (normal.y * tangent.z - normal.z * tangent.y) * scale;
  across.y = (normal.z * tangent.x - normal.x * tangent.z) * scale;
  across.z = (normal.x * tangent.y - normal.y * tangent.x) * scale;
  FloatLanes firstX, firstY, otherX, otherY;
  changeLanes(view, clip, tangent, firstX, firstY);
  changeLanes(view, clip, across, otherX, otherY);
  const FloatLanes sign = chooseLanes(facing, fillLanes(1.0f), fillLanes(-1.0f));
  return angleLanes(firstX + sign * otherY, firstY - sign * otherX);
}

// Squared distance from the viewport.
HACHURE_INLINED FloatLanes beyondLanes(
  const NoiseBlockView& view, const FloatLanes& x, const FloatLanes& y)
{
  const FloatLanes right = (x - view.origin.x) - limitLanes(x - view.origin.x, view.size.x);
  const FloatLanes up = (y - view.origin.y) - limitLanes(y - view.origin.y, view.size.y);
  return right * right + up * up;
}

// As noiseFadeWeight, for densities above the birth.
HACHURE_INLINED FloatLanes fadeLanes(
  const FloatLanes& density, const FloatLanes& birth, float inverseFade)
{
  const FloatLanes octaves = logarithmLanes(density / (birth + leastNumber));
  return limitLanes(octaves * inverseFade, 1.0f);
}

// Changes of depth per pixel, none steeper than the steepest. area: of the image.
HACHURE_INLINED void slopeLanes(const NoiseBlockView& view, const LaneClip& clip,
  const LaneVector& normal, const FloatLanes& area, FloatLanes& x, FloatLanes& y)
{
  const FloatLanes wz = dotLanes(view.wz, normal);
  const FloatLanes across =
    dotLanes(view.zy, normal) + clip.y * wz + clip.z * dotLanes(view.yw, normal);
  const FloatLanes up =
    dotLanes(view.xz, normal) + clip.z * dotLanes(view.wx, normal) - clip.x * wz;
  const FloatLanes inverse = 1.0f / area;
  x = across * inverse * (1.0f / view.size.x);
  y = up * inverse * (1.0f / view.size.y);
  const FloatLanes steepness = rootLanes(x * x + y * y);
  const FloatLanes scale =
    chooseLanes(steepest - steepness, fillLanes(1.0f), steepest / (steepness + leastNumber));
  x = x * scale;
  y = y * scale;
}

} // namespace

void NoiseBlock::place(
  int lane, const NoiseTriangle& at, const glm::dvec2& weights, const NoiseFrame& frame)
{
  const double side = glm::length(at.u);
  const auto set = [lane](Vectors& vectors, const glm::dvec3& value)
  {
    vectors.x[lane] = static_cast<float>(value.x);
    vectors.y[lane] = static_cast<float>(value.y);
    vectors.z[lane] = static_cast<float>(value.z);
  };
  set(
    this->offset, ((at.origin - frame.origin) + weights.x * at.u + weights.y * at.v) / frame.unit);
  set(this->normal, glm::cross(at.u, at.v) / (2.0 * at.area));
  set(this->tangent, side > 0.0 ? at.u / side : glm::dvec3(0.0));
}

HACHURE_WIDE_CLONES
void projectNoiseBlock(const NoiseBlockView& view, const NoiseBlock& block, NoiseImages& images)
{
  LaneVector place, normal;
  loadVector(block.offset, place);
  loadVector(block.normal, normal);
  const auto depthOffset = static_cast<float>(view.depthOffset);
  const FloatLanes w = atLanes(view.rowW, place);
  LaneClip clip;
  clip.inverse = 1.0f / w;
  clip.x = atLanes(view.rowX, place) * clip.inverse;
  clip.y = atLanes(view.rowY, place) * clip.inverse;
  clip.z = atLanes(view.rowZ, place) * clip.inverse;
  const FloatLanes x = (clip.x * 0.5f + 0.5f) * view.size.x + view.origin.x;
  const FloatLanes y = (clip.y * 0.5f + 0.5f) * view.size.y + view.origin.y;
  // The image of an area: see SampleProjection.
  const FloatLanes area = dotLanes(view.xy, normal) + clip.x * dotLanes(view.yw, normal) +
    clip.y * dotLanes(view.wx, normal);
  const FloatLanes density =
    magnitudeLanes(area) * (clip.inverse * clip.inverse) * view.densityFactor;
  const FloatLanes birth = loadLanes(block.birth.data());
  FloatLanes seen = eitherNegative(w - leastNumber, clip.z + (depthOffset + 1.0f));
  seen = eitherNegative(seen, view.reach * view.reach - beyondLanes(view, x, y));
  seen = eitherNegative(seen, magnitudeLanes(area) - leastNumber);
  FloatLanes slopeX, slopeY;
  slopeLanes(view, clip, normal, area, slopeX, slopeY);
  storeLanes(x, images.x.data());
  storeLanes(y, images.y.data());
  storeLanes(clip.z * 0.5f + (0.5f * depthOffset + 0.5f), images.depth.data());
  storeLanes(slopeX, images.slopeX.data());
  storeLanes(slopeY, images.slopeY.data());
  storeLanes(density, images.density.data());
  storeLanes(seen, images.seen.data());
  const FloatLanes alive = eitherNegative(seen, density * view.highestDensity - birth);
  storeLanes(keepWhere(alive, fadeLanes(density, birth, view.inverseFade)), images.weight.data());
  const FloatLanes turned =
    view.turning ? turnAngle(view, block, clip, normal, area) : FloatLanes{};
  storeLanes(turned, images.orientation.data());
}

} // namespace hachure
