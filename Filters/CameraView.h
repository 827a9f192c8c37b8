// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_CameraView_h
#define hachure_CameraView_h

#include "Core/SampleProjection.h"

class vtkCamera;

namespace hachure
{
/// How a camera sees world coordinates in a viewport of this size, in logical pixels. The clipping
/// range is not read: projectSamples needs none.
ViewProjection cameraView(vtkCamera* camera, const double viewportSize[2]);
} // namespace hachure

#endif
