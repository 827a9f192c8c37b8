// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// What one picture costs.

#ifndef FrameCost_h
#define FrameCost_h

#include <vtkRenderWindow.h>

#include <vector>

namespace hachure::benchmark
{
/// Milliseconds of one picture, or sums and means of them.
struct FrameCost
{
  double cpu = 0.0;  ///< of the process, all threads
  double wall = 0.0; ///< elapsed
  double gpu = 0.0;  ///< between the window's first and last command, on the graphics processor
};

/// Draws the window and waits until all of it is there.
FrameCost drawFrame(vtkRenderWindow* window, bool timeGpu);

/// Whether the time of the graphics processor means something: false for OpenGL in software.
bool hasGraphicsProcessor(vtkRenderWindow* window);

double median(std::vector<double> values);
} // namespace hachure::benchmark

#endif
