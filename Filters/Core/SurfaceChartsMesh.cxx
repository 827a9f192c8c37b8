// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceChartsMesh.h"

#include "ParallelSort.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace hachure
{
namespace
{
std::size_t indexOf(std::int32_t number)
{
  return static_cast<std::size_t>(number);
}

// An edge of a triangle at the lower one of its two vertices.
struct MeshEdge
{
  std::int32_t end;    // the higher vertex
  std::int32_t corner; // opposite to it
  bool operator<(const MeshEdge& other) const
  {
    return this->end != other.end ? this->end < other.end : this->corner < other.corner;
  }
};

// A vertex set of a triangle, to find copies.
struct TriangleKey
{
  std::array<std::int32_t, 3> vertices;
  std::size_t triangle;
  bool operator<(const TriangleKey& other) const
  {
    return std::tie(this->vertices, this->triangle) < std::tie(other.vertices, other.triangle);
  }
};

class CornerMeshMaker
{
public:
  explicit CornerMeshMaker(const TriangleMesh& someMesh)
    : mesh(someMesh)
    , joined(joinedTriangles(someMesh))
    , original(someMesh.triangles.size())
  {
    std::iota(this->original.begin(), this->original.end(), std::size_t(0));
  }

  CornerMesh make()
  {
    this->keepTriangles();
    if (!this->matchEdges() && this->dropCopies())
    {
      this->keepTriangles();
      this->matchEdges();
    }
    this->orient();
    this->splitFans();
    this->tellSources();
    return std::move(this->result);
  }

private:
  // Those that have an area and are the first of their copies.
  void keepTriangles()
  {
    this->kept.clear();
    this->kept.reserve(this->mesh.triangles.size());
    this->result.vertices.clear();
    this->result.vertices.reserve(3 * this->mesh.triangles.size());
    for (std::size_t triangle = 0; triangle < this->mesh.triangles.size(); ++triangle)
    {
      const glm::ivec3& corners = this->joined[triangle];
      if (this->original[triangle] == triangle &&
        !isDegenerateTriangle(this->mesh.points[indexOf(corners.x)],
          this->mesh.points[indexOf(corners.y)], this->mesh.points[indexOf(corners.z)]))
      {
        this->kept.push_back(triangle);
        this->result.vertices.insert(
          this->result.vertices.end(), { corners.x, corners.y, corners.z });
      }
    }
  }

  // Two triangles of the same vertices.
  bool areCopies(const std::vector<MeshEdge>& edges, std::size_t run, std::size_t last) const
  {
    return last - run == 2 &&
      this->result.vertex(edges[run].corner) == this->result.vertex(edges[run + 1].corner);
  }

  // False where there may be copies: an edge has more than two triangles, or two with the same
  // vertices.
  bool matchEdges()
  {
    const std::vector<std::int32_t>& vertices = this->result.vertices;
    this->result.opposites.assign(vertices.size(), CornerMesh::border);
    std::vector<std::size_t> first(this->mesh.points.size() + 1, 0);
    const auto endsOf = [&](std::size_t corner)
    {
      const auto number = static_cast<std::int32_t>(corner);
      const std::int32_t from = vertices[indexOf(CornerMesh::next(number))];
      const std::int32_t to = vertices[indexOf(CornerMesh::previous(number))];
      return std::array<std::int32_t, 2>{ std::min(from, to), std::max(from, to) };
    };
    for (std::size_t corner = 0; corner < vertices.size(); ++corner)
    {
      ++first[indexOf(endsOf(corner)[0]) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<MeshEdge> edges(vertices.size());
    std::vector<std::size_t> slots = first;
    for (std::size_t corner = 0; corner < vertices.size(); ++corner)
    {
      const std::array<std::int32_t, 2> ends = endsOf(corner);
      edges[slots[indexOf(ends[0])]++] = { ends[1], static_cast<std::int32_t>(corner) };
    }
    bool isManifold = true;
    for (std::size_t vertex = 0; vertex + 1 < first.size(); ++vertex)
    {
      isManifold = this->matchAt(edges, first[vertex], first[vertex + 1]) && isManifold;
    }
    return isManifold;
  }

  bool matchAt(std::vector<MeshEdge>& edges, std::size_t begin, std::size_t end)
  {
    std::sort(edges.begin() + static_cast<std::ptrdiff_t>(begin),
      edges.begin() + static_cast<std::ptrdiff_t>(end));
    bool isManifold = true;
    for (std::size_t run = begin; run < end;)
    {
      std::size_t last = run + 1;
      while (last < end && edges[last].end == edges[run].end)
      {
        ++last;
      }
      for (std::size_t i = run; i < last && last - run > 1; ++i)
      {
        // Of two that of the other one.
        this->result.opposites[indexOf(edges[i].corner)] =
          last - run == 2 ? edges[run + last - 1 - i].corner : CornerMesh::cut;
      }
      isManifold = isManifold && last - run <= 2 && !this->areCopies(edges, run, last);
      run = last;
    }
    return isManifold;
  }

  // True if there are any.
  bool dropCopies()
  {
    std::vector<TriangleKey> keys;
    keys.reserve(this->kept.size());
    for (const std::size_t triangle : this->kept)
    {
      const glm::ivec3 vertices = this->joined[triangle];
      TriangleKey key = { { vertices.x, vertices.y, vertices.z }, triangle };
      std::sort(key.vertices.begin(), key.vertices.end());
      keys.push_back(key);
    }
    parallelSort(keys);
    bool isAny = false;
    for (std::size_t i = 1; i < keys.size(); ++i)
    {
      if (keys[i].vertices == keys[i - 1].vertices)
      {
        this->original[keys[i].triangle] = this->original[keys[i - 1].triangle];
        isAny = true;
      }
    }
    return isAny;
  }

  // Whether both triangles at an edge run the same way along it.
  bool isAlike(std::int32_t corner) const
  {
    const std::int32_t across = this->result.opposite(corner);
    return this->result.vertex(CornerMesh::next(corner)) ==
      this->result.vertex(CornerMesh::next(across));
  }

  void orient()
  {
    std::vector<char> isTurned(this->kept.size(), 0);
    this->findTurned(isTurned);
    for (std::size_t corner = 0; corner < this->result.opposites.size(); ++corner)
    {
      const std::int32_t across = this->result.opposites[corner];
      if (across >= 0 &&
        this->isAlike(static_cast<std::int32_t>(corner)) !=
          (isTurned[corner / 3] != isTurned[indexOf(across / 3)]))
      {
        this->result.opposites[corner] = CornerMesh::cut;
        this->result.opposites[indexOf(across)] = CornerMesh::cut;
      }
    }
    for (std::size_t triangle = 0; triangle < isTurned.size(); ++triangle)
    {
      if (isTurned[triangle] != 0)
      {
        this->turnOver(static_cast<std::int32_t>(triangle));
      }
    }
  }

  void findTurned(std::vector<char>& isTurned) const
  {
    std::vector<char> isKnown(isTurned.size(), 0);
    std::vector<std::int32_t> queue;
    for (std::size_t start = 0; start < isTurned.size(); ++start)
    {
      queue.assign(isKnown[start] == 0 ? 1 : 0, static_cast<std::int32_t>(start));
      isKnown[start] = 1;
      while (!queue.empty())
      {
        const std::int32_t triangle = queue.back();
        queue.pop_back();
        for (std::int32_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner)
        {
          const std::int32_t across = this->result.opposite(corner);
          if (across >= 0 && isKnown[indexOf(across / 3)] == 0)
          {
            isKnown[indexOf(across / 3)] = 1;
            isTurned[indexOf(across / 3)] =
              this->isAlike(corner) ? 1 - isTurned[indexOf(triangle)] : isTurned[indexOf(triangle)];
            queue.push_back(across / 3);
          }
        }
      }
    }
  }

  void turnOver(std::int32_t triangle)
  {
    const std::size_t second = 3 * indexOf(triangle) + 1;
    std::swap(this->result.vertices[second], this->result.vertices[second + 1]);
    std::swap(this->result.opposites[second], this->result.opposites[second + 1]);
    for (std::size_t corner = second; corner < second + 2; ++corner)
    {
      const std::int32_t across = this->result.opposites[corner];
      if (across >= 0)
      {
        this->result.opposites[indexOf(across)] = static_cast<std::int32_t>(corner);
      }
    }
  }

  // A vertex for every fan; they are numbered as points are, more ones follow.
  void splitFans()
  {
    CornerMesh& made = this->result;
    const std::size_t count = this->mesh.points.size();
    made.cornerAt.assign(count, -1);
    made.points.resize(count);
    std::iota(made.points.begin(), made.points.end(), 0);
    made.positions.assign(this->mesh.points.begin(), this->mesh.points.end());
    made.isFrozen.assign(count, 0);
    made.isBorder.assign(count, 0);
    std::vector<char> isKnown(made.vertices.size(), 0);
    for (std::size_t corner = 0; corner < made.vertices.size(); ++corner)
    {
      if (isKnown[corner] == 0)
      {
        this->addFan(made.firstCorner(static_cast<std::int32_t>(corner)), isKnown);
      }
    }
  }

  void addFan(std::int32_t first, std::vector<char>& isKnown)
  {
    CornerMesh& made = this->result;
    const std::int32_t point = made.vertex(first);
    std::int32_t vertex = point;
    if (made.cornerAt[indexOf(point)] >= 0)
    {
      vertex = static_cast<std::int32_t>(made.points.size());
      made.cornerAt.push_back(-1);
      made.points.push_back(point);
      made.positions.push_back(glm::dvec3(made.positions[indexOf(point)]));
      made.isFrozen.push_back(1);
      made.isBorder.push_back(0);
      made.isFrozen[indexOf(point)] = 1;
    }
    made.cornerAt[indexOf(vertex)] = first;
    bool isCut = made.before(first) == CornerMesh::cut;
    std::int32_t corner = first;
    do
    {
      isKnown[indexOf(corner)] = 1;
      made.vertices[indexOf(corner)] = vertex;
      corner = made.after(corner);
      isCut = isCut || corner == CornerMesh::cut;
    } while (corner >= 0 && corner != first);
    made.isBorder[indexOf(vertex)] = corner < 0 ? 1 : 0;
    made.isFrozen[indexOf(vertex)] = made.isFrozen[indexOf(vertex)] != 0 || isCut ? 1 : 0;
  }

  void tellSources()
  {
    this->result.fine.reserve(this->kept.size());
    for (std::size_t corner = 0; corner < this->result.vertices.size(); corner += 3)
    {
      this->result.fine.emplace_back(this->result.vertices[corner],
        this->result.vertices[corner + 1], this->result.vertices[corner + 2]);
    }
    this->result.sources.assign(this->mesh.triangles.size(), glm::ivec3(-1));
    for (std::size_t i = 0; i < this->kept.size(); ++i)
    {
      this->result.sources[this->kept[i]] = this->inOrderOf(this->kept[i], 3 * i);
    }
    for (std::size_t triangle = 0; triangle < this->original.size(); ++triangle)
    {
      const std::size_t first = this->original[triangle];
      const glm::ivec3 vertices = this->result.sources[first];
      for (int corner = 0; first != triangle && corner < 3; ++corner)
      {
        const glm::ivec3 wanted = this->joined[triangle];
        for (int other = 0; other < 3; ++other)
        {
          if (this->result.points[indexOf(vertices[other])] == wanted[corner])
          {
            this->result.sources[triangle][corner] = vertices[other];
          }
        }
      }
    }
  }

  // Vertices of a triangle of the result in the order of its source's corners.
  glm::ivec3 inOrderOf(std::size_t triangle, std::size_t corner) const
  {
    glm::ivec3 found(this->result.vertices[corner], this->result.vertices[corner + 1],
      this->result.vertices[corner + 2]);
    if (this->result.points[indexOf(found.y)] != this->joined[triangle].y)
    {
      std::swap(found.y, found.z); // it was turned over
    }
    return found;
  }

  const TriangleMesh& mesh;
  std::vector<glm::ivec3> joined;    // triangles
  std::vector<std::size_t> original; // of triangles: the first of their copies
  std::vector<std::size_t> kept;     // triangles of the mesh
  CornerMesh result;
};
} // namespace

std::int32_t CornerMesh::firstCorner(std::int32_t corner) const
{
  std::int32_t first = corner;
  for (std::int32_t other = this->before(first); other >= 0 && other != corner;
       other = this->before(first))
  {
    first = other;
  }
  return this->before(first) < 0 ? first : corner;
}

CornerMesh makeCornerMesh(const TriangleMesh& mesh)
{
  return CornerMeshMaker(mesh).make();
}

void VertexRing::find(const CornerMesh& mesh, std::int32_t vertex)
{
  this->corners.clear();
  this->ends.clear();
  const std::int32_t first = mesh.cornerAt[indexOf(vertex)];
  std::int32_t corner = first;
  do
  {
    this->corners.push_back(corner);
    this->ends.push_back(mesh.vertex(CornerMesh::next(corner)));
    corner = mesh.after(corner);
  } while (corner >= 0 && corner != first);
  this->isClosed = corner == first;
  if (!this->isClosed)
  {
    this->ends.push_back(mesh.vertex(CornerMesh::previous(this->corners.back())));
  }
}

} // namespace hachure
