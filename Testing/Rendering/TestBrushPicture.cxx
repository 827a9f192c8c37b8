// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternPicture.h"

int TestBrushPicture(int argc, char* argv[])
{
  return testPatternPicture("brush", argc, argv);
}
