// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_OctaveContrast_h
#define hachure_OctaveContrast_h

#include "PatternTile.h"
#include "Span.h"

namespace hachure
{

// Standard deviation of the ink of a pattern's half-size copy over that of the pattern at half
// tone, as seen: blurred by a Gaussian of one pixel, the resolution at which pictures are compared,
// and by the pixel itself. texelsPerPixel: of level 0 of the pattern, > 0. Between 1/4, also where
// no more is left, and 1. `mips` = mipChain(tile).
double octaveContrast(Span<const PatternTile> mips, double texelsPerPixel);

} // namespace hachure

#endif
