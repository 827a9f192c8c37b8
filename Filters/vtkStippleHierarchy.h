// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkStippleHierarchy
 * @brief   points on a surface in an order of which every beginning is spread evenly
 *
 * Stipples for the surfaces of a vtkPolyData, or of all vtkPolyData blocks of a composite data set:
 * a light tone is the first of them, and a darker one only adds others (Meruvia Pastor and
 * Strothotte 2002). The index of a point is its rank. The points follow the surface, not its
 * triangulation, and are tied to it by barycentric coordinates, so that they stay where they are
 * while it deforms. The result is a function of the input and the properties alone, whatever the
 * number of threads.
 *
 * Progressive order is blue noise on the surface, nested: each point is in the widest gap that
 * those before it leave. Sheets that face opposite ways do not matter to each other. Classic order
 * is that of the paper: vertices are moved a little and projected back onto the surface, edge
 * collapses order them, and splits of the longest edge add further ones.
 *
 * Without polygons and strips in the input, its points take part, all of them, with their normals
 * if they have some; Progressive only.
 *
 * The first output has one vertex cell per stipple, and as point data:
 * - Normals: unit normal of the triangle, outward on a (nearly) closed block that is inside out.
 * - StippleCell: the input cell, within its block; -1 where the input has points only.
 * - StippleWeights: barycentric, of the second and third point of the triangle.
 * - StipplePointIds: the three input points of the triangle, within the block. Only where
 *   GeneratePointIds is on and where the input has points only: those of a triangle cell are known.
 * - StippleSpacing: the relevance. Progressive: all points up to this rank are at least so far
 *   apart. Classic: length of the shortest edge to a relevant neighbour.
 * - BlockIndex: flat index of the block; only for composite input.
 *
 * Its field data has StippleArea, the area over which points are spread. Classic: also the relevant
 * neighbours as ranks, StippleNeighbours from StippleNeighbourOffsets[i] to
 * StippleNeighbourOffsets[i + 1], excluded; a stipple is drawn where the edges to all of them are
 * longer in the picture than a threshold.
 *
 * The second output is the particle mesh of the classic order, between the points of the first, if
 * GenerateParticleMesh is on; it is empty otherwise.
 *
 * Without options, a stipple takes 48 bytes, and about 68 in classic order.
 *
 * Ghost cells and cells without area take no points. Cells with a coordinate that is not finite are
 * left out with one warning.
 */

#ifndef vtkStippleHierarchy_h
#define vtkStippleHierarchy_h

#include "HachureFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class HACHUREFILTERS_EXPORT vtkStippleHierarchy : public vtkPolyDataAlgorithm
{
public:
  static vtkStippleHierarchy* New();
  vtkTypeMacro(vtkStippleHierarchy, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OrderType
  {
    PROGRESSIVE,
    CLASSIC
  };

  ///@{
  /**
   * Number of points wanted. Range 0 to 134217728, default 100000.
   */
  vtkSetClampMacro(NumberOfPoints, int, 0, 134217728);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /**
   * PROGRESSIVE, the default, or CLASSIC.
   */
  vtkSetClampMacro(Order, int, PROGRESSIVE, CLASSIC);
  vtkGetMacro(Order, int);
  void SetOrderToProgressive() { this->SetOrder(PROGRESSIVE); }
  void SetOrderToClassic() { this->SetOrder(CLASSIC); }
  ///@}

  ///@{
  /**
   * Seed of all random choices. Any value, default 1.
   */
  vtkSetMacro(Seed, unsigned int);
  vtkGetMacro(Seed, unsigned int);
  ///@}

  ///@{
  /**
   * Classic order: how far a vertex is moved at least and at most, as shares of the edges of a
   * triangle. Range 0 to 0.5, default 0.125 and 0.25 (section 2.4.1 of the paper). 0 and 0: no
   * vertex is moved. The least must not be above the most.
   */
  vtkSetClampMacro(LeastMove, double, 0.0, 0.5);
  vtkGetMacro(LeastMove, double);
  vtkSetClampMacro(MostMove, double, 0.0, 0.5);
  vtkGetMacro(MostMove, double);
  ///@}

  ///@{
  /**
   * Whether the input's point arrays are interpolated at the stipples, and its cell arrays copied.
   * Composite input has none of them. Default off.
   */
  vtkSetMacro(InterpolateData, bool);
  vtkGetMacro(InterpolateData, bool);
  vtkBooleanMacro(InterpolateData, bool);
  ///@}

  ///@{
  /**
   * Whether stipples come with the points of their triangles: to place them again on a surface of
   * polygons or strips, of which the cell does not tell the triangle. 12 bytes per stipple. Default
   * off.
   */
  vtkSetMacro(GeneratePointIds, bool);
  vtkGetMacro(GeneratePointIds, bool);
  vtkBooleanMacro(GeneratePointIds, bool);
  ///@}

  ///@{
  /**
   * Classic order: whether the second output has the particle mesh. 32 bytes per stipple. Default
   * off.
   */
  vtkSetMacro(GenerateParticleMesh, bool);
  vtkGetMacro(GenerateParticleMesh, bool);
  vtkBooleanMacro(GenerateParticleMesh, bool);
  ///@}

protected:
  vtkStippleHierarchy();
  ~vtkStippleHierarchy() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int NumberOfPoints = 100000;
  int Order = PROGRESSIVE;
  unsigned int Seed = 1;
  double LeastMove = 0.125;
  double MostMove = 0.25;
  bool InterpolateData = false;
  bool GeneratePointIds = false;
  bool GenerateParticleMesh = false;

private:
  vtkStippleHierarchy(const vtkStippleHierarchy&) = delete;
  void operator=(const vtkStippleHierarchy&) = delete;
};

#endif
