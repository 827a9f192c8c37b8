// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFrames.h"

#include "Parallel.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{
std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}

// Corners of triangles, 3 * triangle + corner, by a number that each of them has.
struct CornerLists
{
  std::vector<std::size_t> first;
  std::vector<std::size_t> corners;

  // numberOf(corner): -1 for none.
  template <class NumberOf>
  CornerLists(std::size_t triangles, std::size_t numbers, NumberOf&& numberOf)
    : first(numbers + 1, 0)
  {
    for (std::size_t corner = 0; corner < 3 * triangles; ++corner)
    {
      const std::int32_t number = numberOf(corner);
      this->first[number < 0 ? 0 : indexOf(number) + 1] += number < 0 ? 0 : 1;
    }
    std::partial_sum(this->first.begin(), this->first.end(), this->first.begin());
    this->corners.resize(this->first.back());
    std::vector<std::size_t> next(this->first);
    for (std::size_t corner = 0; corner < 3 * triangles; ++corner)
    {
      const std::int32_t number = numberOf(corner);
      if (number >= 0)
      {
        this->corners[next[indexOf(number)]++] = corner;
      }
    }
  }

  std::size_t count() const { return this->first.size() - 1; }
  Span<const std::size_t> of(std::size_t number) const
  {
    return Span<const std::size_t>(this->corners)
      .subspan(this->first[number], this->first[number + 1] - this->first[number]);
  }
};

// The point at a corner of a triangle, or `turn` corners further.
std::int32_t pointAt(const TriangleMesh& mesh, std::size_t corner, std::size_t turn = 0)
{
  return mesh.triangles[corner / 3][static_cast<int>((corner + turn) % 3)];
}

glm::dvec3 unitNormal(const TriangleMesh& mesh, std::size_t triangle)
{
  const glm::dvec3 normal = triangleAreaVector(mesh, static_cast<std::int64_t>(triangle));
  const double length = glm::length(normal);
  return length > 0.0 ? normal / length : glm::dvec3(0.0);
}

double angleAt(const TriangleMesh& mesh, std::size_t corner)
{
  const std::size_t start = corner / 3 * 3;
  const std::size_t turn = corner - start;
  const glm::dvec3& apex = mesh.points[indexOf(pointAt(mesh, start, turn))];
  const glm::dvec3 one = mesh.points[indexOf(pointAt(mesh, start, turn + 1))] - apex;
  const glm::dvec3 other = mesh.points[indexOf(pointAt(mesh, start, turn + 2))] - apex;
  return std::atan2(glm::length(glm::cross(one, other)), glm::dot(one, other));
}

std::vector<std::uint8_t> chartsFacingDown(const TriangleMesh& mesh, const SurfaceCells& cells)
{
  std::vector<double> up(cells.charts.size(), 0.0);
  for (std::size_t triangle = 0; triangle < cells.chartOfTriangle.size(); ++triangle)
  {
    if (cells.chartOfTriangle[triangle] >= 0)
    {
      up[indexOf(cells.chartOfTriangle[triangle])] +=
        triangleAreaVector(mesh, static_cast<std::int64_t>(triangle)).y;
    }
  }
  std::vector<std::uint8_t> isDown(up.size());
  std::transform(up.begin(), up.end(), isDown.begin(),
    [](double y) { return static_cast<std::uint8_t>(y < 0.0 ? 1 : 0); });
  return isDown;
}

// An edge of a triangle at a point, as it is seen from there.
struct Spoke
{
  std::int32_t end;
  std::size_t place; // of the triangle in a list

  bool operator<(const Spoke& other) const
  {
    return this->end != other.end ? this->end < other.end : this->place < other.place;
  }
};

std::size_t rootOf(std::vector<std::size_t>& parents, std::size_t place)
{
  while (parents[place] != place)
  {
    parents[place] = parents[parents[place]];
    place = parents[place];
  }
  return place;
}

// Of every corner at a point: the first place in their list of those that it hangs together with
// smoothly.
std::vector<std::size_t> smoothParts(const TriangleMesh& mesh, Span<const std::size_t> corners,
  const std::vector<glm::dvec3>& normals, double leastCosine)
{
  std::vector<std::size_t> parts(corners.size());
  std::iota(parts.begin(), parts.end(), std::size_t(0));
  std::vector<Spoke> spokes;
  spokes.reserve(2 * corners.size());
  for (std::size_t place = 0; place < corners.size(); ++place)
  {
    const std::size_t start = corners[place] / 3 * 3;
    const std::size_t turn = corners[place] - start;
    spokes.push_back({ pointAt(mesh, start, turn + 1), place });
    spokes.push_back({ pointAt(mesh, start, turn + 2), place });
  }
  std::sort(spokes.begin(), spokes.end());
  for (std::size_t i = 1; i < spokes.size(); ++i)
  {
    const glm::dvec3& one = normals[corners[spokes[i - 1].place] / 3];
    const glm::dvec3& other = normals[corners[spokes[i].place] / 3];
    if (spokes[i - 1].end == spokes[i].end && glm::dot(one, other) >= leastCosine)
    {
      const std::size_t first = rootOf(parts, spokes[i - 1].place);
      const std::size_t second = rootOf(parts, spokes[i].place);
      parts[std::max(first, second)] = std::min(first, second);
    }
  }
  for (std::size_t place = 0; place < parts.size(); ++place)
  {
    parts[place] = rootOf(parts, place);
  }
  return parts;
}

// Of every corner of a triangle, 3 * triangle + corner: the first corner of its smooth part.
std::vector<std::size_t> smoothCorners(
  const TriangleMesh& mesh, const CornerLists& around, double featureAngle)
{
  std::vector<glm::dvec3> normals(mesh.triangles.size());
  parallelFor(static_cast<std::int64_t>(normals.size()),
    [&](std::int64_t i)
    {
      const auto triangle = static_cast<std::size_t>(i);
      normals[triangle] = unitNormal(mesh, triangle);
    });
  std::vector<std::size_t> heads(3 * mesh.triangles.size(), 0);
  parallelFor(static_cast<std::int64_t>(around.count()),
    [&](std::int64_t point)
    {
      const Span<const std::size_t> corners = around.of(static_cast<std::size_t>(point));
      const std::vector<std::size_t> parts =
        smoothParts(mesh, corners, normals, std::cos(featureAngle));
      for (std::size_t place = 0; place < corners.size(); ++place)
      {
        heads[corners[place]] = corners[parts[place]];
      }
    });
  return heads;
}

// Numbers sheets, and frames: a sheet has one for every way its charts face.
SurfaceFrames numberFrames(const TriangleMesh& mesh, const SurfaceCells& cells,
  const CornerLists& around, const std::vector<std::size_t>& heads,
  std::vector<std::uint8_t>& framesDown)
{
  constexpr glm::ivec2 none(-1);
  std::vector<glm::ivec2> framesOf(heads.size(), none); // of the first corner of a sheet
  std::vector<std::int32_t> sheetOf(heads.size(), -1);
  SurfaceFrames frames;
  frames.chartsDown = chartsFacingDown(mesh, cells);
  frames.corners.assign(mesh.triangles.size(), glm::ivec3(-1));
  frames.points.reserve(mesh.points.size());
  frames.sheets.reserve(mesh.points.size());
  std::int32_t sheets = 0;
  for (const std::size_t corner : around.corners)
  {
    const std::size_t head = heads[corner];
    sheets += sheetOf[head] < 0 ? 1 : 0;
    sheetOf[head] = sheetOf[head] < 0 ? sheets - 1 : sheetOf[head];
    const std::uint8_t down = frames.chartsDown[indexOf(cells.chartOfTriangle[corner / 3])];
    std::int32_t& frame = framesOf[head][down];
    if (frame < 0)
    {
      frame = static_cast<std::int32_t>(frames.points.size());
      frames.points.push_back(pointAt(mesh, corner));
      frames.sheets.push_back(sheetOf[head]);
      framesDown.push_back(down);
    }
    frames.corners[corner / 3][static_cast<int>(corner % 3)] = frame;
  }
  return frames;
}

// Corners of triangles by the sheet of their frames.
CornerLists sheetCorners(const SurfaceFrames& frames)
{
  const std::size_t count = frames.sheets.empty()
    ? 0
    : indexOf(*std::max_element(frames.sheets.begin(), frames.sheets.end())) + 1;
  return { frames.corners.size(), count,
    [&](std::size_t corner)
    {
      const std::int32_t frame = frames.corners[corner / 3][static_cast<int>(corner % 3)];
      return frame < 0 ? -1 : frames.sheets[indexOf(frame)];
    } };
}

// Of every sheet, of unit length; 0 where its triangles have no area or cancel each other.
std::vector<glm::dvec3> sheetNormals(const TriangleMesh& mesh, const CornerLists& sheets)
{
  std::vector<glm::dvec3> normals(sheets.count());
  parallelFor(static_cast<std::int64_t>(normals.size()),
    [&](std::int64_t i)
    {
      const auto sheet = static_cast<std::size_t>(i);
      glm::dvec3 sum(0.0);
      for (const std::size_t corner : sheets.of(sheet))
      {
        sum += angleAt(mesh, corner) * unitNormal(mesh, corner / 3);
      }
      const double length = glm::length(sum);
      constexpr double least = 1e-9; // radians: below is rounding
      normals[sheet] = length > least ? sum / length : glm::dvec3(0.0);
    });
  return normals;
}

// The shortest turn of +Y, or of -Y after half a turn about X, to a unit vector.
glm::quat frameOf(const glm::dvec3& normal, bool isDown)
{
  const double sign = isDown ? -1.0 : 1.0;
  const double twice = 1.0 + sign * normal.y; // the cosine of half the angle, squared and doubled
  constexpr double least = 1e-12;
  // To the opposite there are many; one is as good as the others.
  const glm::dquat turn = twice > least
    ? glm::normalize(glm::dquat(twice, sign * normal.z, 0.0, -sign * normal.x))
    : glm::dquat(0.0, 1.0, 0.0, 0.0);
  return glm::quat(isDown ? turn * glm::dquat(0.0, 1.0, 0.0, 0.0) : turn);
}

// Two edges and the normal, whose length grows with them.
glm::dmat3 withNormal(const TriangleMesh& mesh, std::size_t triangle)
{
  const glm::ivec3& corners = mesh.triangles[triangle];
  const glm::dvec3& first = mesh.points[indexOf(corners.x)];
  const glm::dvec3 one = mesh.points[indexOf(corners.y)] - first;
  const glm::dvec3 other = mesh.points[indexOf(corners.z)] - first;
  const glm::dvec3 across = glm::cross(one, other);
  const double length = glm::length(across);
  return { one, other, length > 0.0 ? across / std::sqrt(length) : across };
}

// How the surroundings of every sheet are deformed: the mean over its corners by their angles.
std::vector<glm::dmat3> sheetDeformations(
  const TriangleMesh& reference, const TriangleMesh& moved, const CornerLists& sheets)
{
  std::vector<glm::dmat3> deformations(sheets.count());
  parallelFor(static_cast<std::int64_t>(deformations.size()),
    [&](std::int64_t i)
    {
      const auto sheet = static_cast<std::size_t>(i);
      glm::dmat3 sum(0.0);
      for (const std::size_t corner : sheets.of(sheet))
      {
        sum += angleAt(reference, corner) * withNormal(moved, corner / 3) *
          glm::inverse(withNormal(reference, corner / 3));
      }
      deformations[sheet] = sum;
    });
  return deformations;
}

glm::quat movedFrame(const glm::quat& turn, const glm::dmat3& deformation, const glm::dvec3& normal)
{
  const glm::dvec3 axis = deformation * (glm::dquat(turn) * glm::dvec3(1.0, 0.0, 0.0));
  const glm::dvec3 along = axis - glm::dot(axis, normal) * normal;
  const double length = glm::length(along);
  if (!(length > 1e-12 * glm::length(axis)) || normal == glm::dvec3(0.0))
  {
    return turn;
  }
  const glm::dvec3 x = along / length;
  return glm::quat(glm::normalize(glm::quat_cast(glm::dmat3(x, normal, glm::cross(x, normal)))));
}

void checkMoved(
  const SurfaceFrames& frames, const TriangleMesh& reference, Span<const glm::dvec3> moved)
{
  checkTriangleMesh(reference);
  if (moved.size() != reference.points.size())
  {
    throw std::invalid_argument("moved: " + std::to_string(moved.size()) + " points for the " +
      std::to_string(reference.points.size()) + " of the reference");
  }
  checkTriangleMesh({ moved, reference.triangles, {} });
  if (frames.corners.size() != reference.triangles.size())
  {
    throw std::invalid_argument("frames.corners: " + std::to_string(frames.corners.size()) +
      " for " + std::to_string(reference.triangles.size()) + " triangles");
  }
}
} // namespace

SurfaceFrames surfaceFrames(
  const TriangleMesh& mesh, const SurfaceCells& cells, double featureAngle)
{
  checkTriangleMesh(mesh);
  checkSurfaceCells(mesh, cells);
  constexpr double pi = 3.14159265358979323846;
  if (!(featureAngle >= 0.0 && featureAngle <= pi))
  {
    throw std::invalid_argument(
      "featureAngle is " + std::to_string(featureAngle) + "; expected 0 to pi");
  }
  const CornerLists around(mesh.triangles.size(), mesh.points.size(),
    [&](std::size_t corner)
    { return cells.chartOfTriangle[corner / 3] < 0 ? -1 : pointAt(mesh, corner); });
  std::vector<std::uint8_t> isDown;
  isDown.reserve(mesh.points.size());
  SurfaceFrames frames =
    numberFrames(mesh, cells, around, smoothCorners(mesh, around, featureAngle), isDown);
  const CornerLists sheets = sheetCorners(frames);
  const std::vector<glm::dvec3> normals = sheetNormals(mesh, sheets);
  frames.turns.resize(frames.points.size());
  frames.otherTurns.resize(frames.points.size());
  for (std::size_t frame = 0; frame < frames.turns.size(); ++frame)
  {
    const std::size_t sheet = indexOf(frames.sheets[frame]);
    const glm::dvec3 normal = normals[sheet] != glm::dvec3(0.0)
      ? normals[sheet]
      : unitNormal(mesh, sheets.of(sheet)[0] / 3);
    frames.turns[frame] = frameOf(normal, isDown[frame] != 0);
    frames.otherTurns[frame] = frameOf(normal, isDown[frame] == 0);
  }
  return frames;
}

void moveFrames(SurfaceFrames& frames, const TriangleMesh& reference, Span<const glm::dvec3> moved)
{
  checkMoved(frames, reference, moved);
  const TriangleMesh after = { moved, reference.triangles, {} };
  const CornerLists sheets = sheetCorners(frames);
  const std::vector<glm::dvec3> normals = sheetNormals(after, sheets);
  const std::vector<glm::dmat3> deformations = sheetDeformations(reference, after, sheets);
  parallelFor(static_cast<std::int64_t>(frames.turns.size()),
    [&](std::int64_t i)
    {
      const auto frame = static_cast<std::size_t>(i);
      const std::size_t sheet = indexOf(frames.sheets[frame]);
      for (std::vector<glm::quat>* turns : { &frames.turns, &frames.otherTurns })
      {
        (*turns)[frame] = movedFrame((*turns)[frame], deformations[sheet], normals[sheet]);
      }
    });
}

} // namespace hachure
