// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternPicture.h"

int TestHalftonePicture(int argc, char* argv[])
{
  return testPatternPicture("halftone", argc, argv);
}
