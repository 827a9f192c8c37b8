// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A mapper's surface, and the points on it that marks are attached to: they stay there while it
 * deforms. Where its cells change, vtkPatternNoiseHistory carries those of noises to the new
 * surface.
 */
#ifndef vtkPatternSurface_h
#define vtkPatternSurface_h

#include "NoiseSurface.h"
#include "StippleEdges.h"
#include "StippleLife.h"
#include "StippleTree.h"
#include "SurfaceCells.h"
#include "SurfaceFrames.h"
#include "SurfaceTriangles.h"
#include "TriangleRuns.h"
#include "vtkPatternGeometry.h"
#include "vtkPatternSurfaceArray.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataObject;
class vtkPolyData;

class vtkPatternSurface
{
public:
  /// What else a surface is known by.
  struct Source
  {
    vtkAlgorithm* Algorithm; // that makes the input
    int Port;
    double DataTime; // of the input, not a number where it has none
    double AnimationTime;
  };

  /// Brings the surface up to date with polydata or a composite of polydata. Other cells are
  /// another surface, other coordinates only move it.
  void Update(vtkDataObject* input, const Source& source);

  /// What stipples are made with.
  struct StippleKey
  {
    hachure::StippleOrder Order;
    std::uint32_t Seed;
    std::int64_t Count;
    int Life; // changes of cells over which they come and go; 0: each surface has its own
    bool operator<(const StippleKey& other) const
    {
      return std::tie(this->Order, this->Seed, this->Count, this->Life) <
        std::tie(other.Order, other.Seed, other.Count, other.Life);
    }
  };
  struct StippleSet
  {
    hachure::LivingStipples Living;
    hachure::StippleTree Tree;
    hachure::StippleTree Leaving; // those of surfaces before; by their index in Living
    void Move(const hachure::TriangleMesh& mesh);
  };

  /// What the cells of view-dependent textures are made with.
  struct CellKey
  {
    int BaseCells;
    int FinestLevel;
    std::int64_t MostNodes;
    bool operator<(const CellKey& other) const
    {
      return std::tie(this->BaseCells, this->FinestLevel, this->MostNodes) <
        std::tie(other.BaseCells, other.FinestLevel, other.MostNodes);
    }
  };
  struct CellSet
  {
    hachure::SurfaceCells Cells;
    hachure::SurfaceFrames First; // where the surface was first
    hachure::SurfaceFrames Frames;
    void Move(const hachure::TriangleMesh& first, hachure::Span<const glm::dvec3> positions);
  };

  /// A surface as long as it has the same cells. Who holds one keeps it as it was last.
  struct State
  {
    hachure::SurfaceTriangles Surface; // as it was first
    std::vector<glm::dvec3> Positions; // now
    std::vector<std::uint64_t> Ids;    // from global ids of cells; empty where there are none
    std::vector<double> Areas; // with ids: those of the first surface that had such a triangle
    std::map<std::uint32_t, hachure::NoiseSurface> Seeds;
    std::map<StippleKey, StippleSet> Stipples;
    std::map<StippleKey, hachure::StippleEdges> ClassicStipples;
    std::map<CellKey, CellSet> Cells;
    std::vector<glm::ivec3> Outward; // triangles, those of closed blocks facing out; or empty
    std::shared_ptr<State> Before;   // surface that this one replaced, until it is replaced
    unsigned long Lineage = 0;       // the same for surfaces that come from one another
    double DataTime = std::numeric_limits<double>::quiet_NaN();
    double AnimationTime = 0.0;

    /// Whether it is a later surface of the same origin.
    bool Follows(const State& before) const;
  };
  const std::shared_ptr<State>& GetState() const { return this->Current; }

  /// The points of this seed, where the surface is now. Owns the state.
  std::shared_ptr<hachure::NoiseSurface> Points(std::uint32_t seed);

  /// Stipples, where the surface is now; their normals point outward where it is closed. Owns the
  /// state.
  std::shared_ptr<StippleSet> Stipples(const StippleKey& key);
  /// The same of those in the order Classic, with the edges to their relevant neighbours.
  std::shared_ptr<hachure::StippleEdges> ClassicStipples(const StippleKey& key);

  /// The cells of the surface as it was first, and frames where it is now. Owns the state.
  std::shared_ptr<CellSet> Cells(const CellKey& key);
  /// The surface as it was first; points of no triangle are finite.
  std::vector<glm::dvec3> FirstPositions() const;

  /// The next update finds a surface without a past: marks are made where it is then.
  void BeginAnew();

  hachure::TriangleMesh Mesh() const
  {
    return { this->Current->Positions, this->Current->Surface.triangles, {} };
  }
  const std::vector<std::uint64_t>& TriangleIds() const { return this->Current->Ids; }
  /// Block of each triangle.
  const std::vector<std::int32_t>& Objects() const { return this->Current->Surface.blockIndices; }
  /// For every triangle the one that stands for it where VTK draws the surface: itself, or the
  /// first one of its cell where VTK may cut the cell another way, which are polygons of five
  /// corners or more and those that are bent in.
  const std::vector<std::int32_t>& Facets();
  /// Block and facet, or -1, for the primitives that VTK draws a block with; `cells`: of each. The
  /// block is one of the surface's, or a part of one (see vtkSurfacePart); so below.
  /// Those of one cell follow each other.
  void AppendPrimitiveIds(
    vtkPolyData* block, hachure::Span<const vtkIdType> cells, std::vector<float>& ids);
  /// Triangles by the vertices that VTK tells them by.
  const hachure::TriangleRuns& Runs();
  /// First records of a block's points.
  void AppendRuns(vtkPolyData* block, std::vector<float>& records);
  /// Throws std::invalid_argument as vtkPatternSurfaceArray does. Until the next update.
  const vtkPatternSurfaceArray& Array(const std::string& name, int components);
  /// Another one whenever the surface or its data has changed.
  unsigned long GetVersion() const { return this->Version; }
  /// Another one whenever its cells are others.
  unsigned long GetCellVersion() const { return this->CellVersion; }
  bool HasSeveralBlocks() const { return this->Current->Surface.blocks.size() > 1; }

private:
  struct Part
  {
    std::size_t Block;
    vtkDataArray* Cells; // of the block, for every cell of the part; null: those of the same number
  };
  Part FindPart(vtkPolyData* drawn) const;
  void Replace(vtkDataObject* input, bool related);
  bool HasMoved() const;
  void ForgetStipples();
  void Identify(vtkDataObject* input);
  const std::vector<glm::ivec3>& Outward();
  StippleSet MakeStipples(const StippleKey& key);
  void Move();

  vtkPatternGeometry Geometry;
  std::shared_ptr<State> Current = std::make_shared<State>();
  vtkWeakPointer<vtkAlgorithm> Algorithm; // of the last update
  int Port = 0;
  vtkDataObject* Input = nullptr;
  std::uint64_t InputTime = 0;
  unsigned long Version = 0;
  unsigned long CellVersion = 0;
  bool IsAnew = false;                       // asked for
  std::vector<std::int32_t> FacetOfTriangle; // empty: not asked for yet
  hachure::TriangleRuns RunsOfPoints;        // the same
  std::map<std::pair<std::string, int>, vtkPatternSurfaceArray> Arrays;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternSurface.h
