// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternPicture.h"

int TestCrossHatchPicture(int argc, char* argv[])
{
  return testPatternPicture("cross-hatch", argc, argv);
}
