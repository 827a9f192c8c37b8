// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_SurfaceChartsSmooth_h
#define hachure_SurfaceChartsSmooth_h

#include "SurfaceChartsCollapse.h"

namespace hachure
{

// Internal: moves the places of vertices on a base mesh, also over its rims, so that the areas of
// triangles change less from one to the next and fewer are turned over. Every vertex goes to the
// mean of its neighbours with mean-value weights (Floater 2003) if the worst of its triangles gets
// better there, or is good enough. Corners of the base mesh and vertices at borders stay. False if
// the progress function stopped it.
bool smoothHomes(BaseMesh& base, const ProgressFn& progress);

} // namespace hachure

#endif
