// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TextureViewThumbnail_h
#define hachure_TextureViewThumbnail_h

#include "vtkSmartPointer.h"

#include <array>

class vtkImageData;

namespace hachure
{

// The picture of a view as red, green, blue and alpha, with no more than `most` pixels a side: each
// the mean of those it stands for. mask: null, or another alpha, by its first component.
vtkSmartPointer<vtkImageData> viewThumbnail(vtkImageData* picture, vtkImageData* mask, int most);

// The colour of a view among all, 0 to 1, as where the coverage of views is shown.
std::array<double, 3> viewColor(int view);

} // namespace hachure

#endif
