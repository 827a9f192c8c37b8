// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Memory that OpenGL holds for a window.

#ifndef DeviceMemory_h
#define DeviceMemory_h

#include <vtkRenderWindow.h>

#include <cstdint>

namespace hachure::benchmark
{
/// Bytes of all textures, renderbuffers and buffers of the window's context, from their sizes and
/// formats: the same on every OpenGL, where the memory of the process depends on the driver.
std::int64_t deviceBytes(vtkRenderWindow* window);
} // namespace hachure::benchmark

#endif
