// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseTileLists_h
#define hachure_NoiseTileLists_h

#include "NoiseKernels.h"
#include "Span.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hachure
{

// Which kernels reach into which tiles of a rectangle, for sums on a graphics card: there every
// pixel looks at all kernels of its tile.
struct NoiseTileLists
{
  int tileSize = 16; // pixels: 16, 32 or 64, about as large as the kernels
  int columns = 0, rows = 0;
  // Kernels of tile i = row * columns + column: [starts[i], starts[i + 1]) in `kernels`, ascending.
  std::vector<std::uint32_t> starts;
  std::vector<std::uint32_t> kernels;
};

// rectangle: x, y, width, height in the framebuffer. Kernels that cannot be drawn are in no list: a
// parameter that is not finite, no weight or no bandwidth. Throws std::invalid_argument for a size
// below 0.
NoiseTileLists noiseTileLists(Span<const NoiseKernel> kernels, const std::array<int, 4>& rectangle);

} // namespace hachure

#endif
