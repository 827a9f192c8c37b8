// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StippleParticles.h"

#include <algorithm>
#include <utility>

namespace hachure
{

namespace
{

int cornerOf(const glm::ivec3& triangle, std::int32_t vertex)
{
  return triangle.x == vertex ? 0 : triangle.y == vertex ? 1 : 2;
}

bool hasCorner(const glm::ivec3& triangle, std::int32_t vertex)
{
  return triangle.x == vertex || triangle.y == vertex || triangle.z == vertex;
}

} // namespace

StippleParticles::StippleParticles(
  std::vector<glm::dvec3> somePlaces, std::vector<glm::ivec3> someTriangles)
  : places(std::move(somePlaces))
  , triangles(std::move(someTriangles))
  , first(this->places.size(), -1)
  , next(3 * this->triangles.size(), -1)
{
  for (std::size_t i = 0; i < this->triangles.size(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      this->link(static_cast<std::int32_t>(i), corner);
    }
  }
}

void StippleParticles::link(std::int32_t triangle, int corner)
{
  const std::int32_t vertex = this->triangles[static_cast<std::size_t>(triangle)][corner];
  this->next[3 * static_cast<std::size_t>(triangle) + static_cast<std::size_t>(corner)] =
    this->first[static_cast<std::size_t>(vertex)];
  this->first[static_cast<std::size_t>(vertex)] = 3 * triangle + corner;
}

void StippleParticles::unlink(std::int32_t triangle, int corner)
{
  const std::int32_t vertex = this->triangles[static_cast<std::size_t>(triangle)][corner];
  std::int32_t* link = &this->first[static_cast<std::size_t>(vertex)];
  while (*link != 3 * triangle + corner)
  {
    link = &this->next[static_cast<std::size_t>(*link)];
  }
  *link = this->next[static_cast<std::size_t>(*link)];
}

void StippleParticles::neighbours(std::int32_t vertex, std::vector<std::int32_t>& result) const
{
  result.clear();
  this->visitTriangles(vertex,
    [&](std::int32_t index)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        if (this->triangle(index)[corner] != vertex)
        {
          result.push_back(this->triangle(index)[corner]);
        }
      }
    });
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
}

void StippleParticles::trianglesAt(
  std::int32_t a, std::int32_t b, std::vector<std::int32_t>& result) const
{
  result.clear();
  this->visitTriangles(a,
    [&](std::int32_t index)
    {
      if (hasCorner(this->triangle(index), b))
      {
        result.push_back(index);
      }
    });
  std::sort(result.begin(), result.end());
}

std::int32_t StippleParticles::split(std::int32_t a, std::int32_t b, const glm::dvec3& place)
{
  const auto vertex = static_cast<std::int32_t>(this->places.size());
  this->places.push_back(place);
  this->first.push_back(-1);
  this->trianglesAt(a, b, this->found);
  for (const std::int32_t index : this->found)
  {
    glm::ivec3& near = this->triangles[static_cast<std::size_t>(index)];
    glm::ivec3 far = near;
    far[cornerOf(near, a)] = vertex;
    const int corner = cornerOf(near, b);
    this->unlink(index, corner);
    near[corner] = vertex;
    this->link(index, corner);
    this->triangles.push_back(far);
    this->next.resize(this->next.size() + 3, -1);
    for (int i = 0; i < 3; ++i)
    {
      this->link(static_cast<std::int32_t>(this->triangles.size()) - 1, i);
    }
  }
  return vertex;
}

void StippleParticles::collapse(std::int32_t gone, std::int32_t kept)
{
  this->found.clear();
  this->visitTriangles(gone, [&](std::int32_t index) { this->found.push_back(index); });
  for (const std::int32_t index : this->found)
  {
    glm::ivec3& corners = this->triangles[static_cast<std::size_t>(index)];
    if (hasCorner(corners, kept))
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        this->unlink(index, corner);
      }
      corners = glm::ivec3(-1);
    }
    else
    {
      const int corner = cornerOf(corners, gone);
      this->unlink(index, corner);
      corners[corner] = kept;
      this->link(index, corner);
    }
  }
}

} // namespace hachure
