// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_StippleTone_h
#define hachure_StippleTone_h

// How many stipples of which size make a tone. A stipple comes in where the picture's stipples are
// wanted as dense as the first of them up to it are, and grows as more are wanted (Meruvia Pastor
// and Strothotte 2002, section 2.5, with a size that depends on the picture alone).
namespace hachure
{

// Area of all discs over that of the picture, overlaps counted as often as they are there, which
// covers `tone` of it, both 0 to 1: measured with progressive stipples, for surfaces that are seen
// at an angle of this cosine, in which they crowd in one direction. Tone 1 is all covered.
// Independent of the size of discs and, within .01, of their growth.
float stippleDiscArea(float tone, float facing);

// Diameter over that of a grown disc, 0 to 1, where the picture wants `wanted` times the density at
// which the stipple comes in: at 1 it has none, and is grown where the distances of stipples, the
// roots of densities, have shrunk by 1 + growth. growth: > 0.
float stippleGrowth(float wanted, float growth);

// Mean area of the discs at any density over that of grown ones.
float stippleMeanArea(float growth);

// As stippleDiscArea, for classic stipples that are drawn where their shortest edge in the picture
// is longer than a threshold, which is the same all over. They are spread less evenly, and overlap
// more. Tone 1 has an ink of .993.
// growth: of stipples that grow with their edges, which overlap less; 0: all have the same size.
float stippleClassicDiscArea(float tone, float facing, float growth);

// How many of them there are per area of the picture, times the square of the threshold. The mean
// of hierarchies with splits; in a single one it may be off by a tenth (StippleThresholds).
float stippleEdgeCrowd(float facing);

// There are fewer by this share, 0 to 1, where nearly all of a hierarchy's stipples are drawn: of
// those that the tilt would let in, some have not been made. used: the density over the highest.
float stippleEdgeLack(float facing, float used);

// Stipples per square of a grown disc's diameter that make the tone.
float stippleCrowd(float tone, float facing, float growth);

} // namespace hachure

#endif
