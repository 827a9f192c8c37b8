// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceCharts_h
#define hachure_SurfaceCharts_h

#include "SurfaceCells.h"
#include "SurfaceSampling.h"

namespace hachure
{

// Cells for any mesh: charts of many triangles where these are smaller than the cells of level 0
// that are wanted, else trianglesAsCells(). Points in one place are joined.
//
// Charts have about the area of a cell of level 0, as far as the surface's parts are that large.
// A part smaller than a cell of the finest level is one chart, on all of which is one colour.
// Charts do not continue over borders, edges of more than two triangles and such where the
// orientation cannot be the same on both sides. All triangles have a chart but those without area;
// they are oriented as it is, unless they lie the other way than their neighbours.
//
// Linear in time but for a logarithm, the same for any number of threads. progress: of 0 to 1; if
// it returns false, there are no charts. Throws std::invalid_argument as trianglesAsCells() does.
SurfaceCells surfaceCells(const TriangleMesh& mesh, const SurfaceCellOptions& options = {},
  const ProgressFn& progress = {});

} // namespace hachure

#endif
