// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_PaperTile_h
#define hachure_PaperTile_h

#include "PatternTile.h"

namespace hachure
{

// A sheet of paper seen in raking light. The parts are added, each with its own share.
struct PaperOptions
{
  // Texels across the tile, in both directions; 8 to 4096.
  int size = 256;
  // Grains of the tooth, threads or laid lines across the tile; 1 to size / 4, at most 256.
  int periods = 32;
  std::uint32_t seed = 1;
  // 0 to 1: rounded grains of one size, as of cold-pressed paper.
  double grain = 1.0;
  // 0 to 1: fine, long, bent fibres on top.
  double fibres = 0.5;
  // 0 to 1: the ribs of a laid mould along x, and a few chain lines along y.
  double laid = 0.0;
  // 0 to 1: threads over and under each other, as of canvas.
  double weave = 0.0;
};

// Height of the paper, from the lowest (screen 0) to the highest (1) points, uniformly distributed.
// Used as a screen it takes ink in the valleys first, as a wash does; 1 - screen is the order in
// which a dry pencil catches. Throws when all shares are 0.
PatternTile paperTile(const PaperOptions& options = {});

} // namespace hachure

#endif
