// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternPicture.h"

int TestHatchPicture(int argc, char* argv[])
{
  return testPatternPicture("hatch", argc, argv);
}
