// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternPicture.h"

int TestGraphitePicture(int argc, char* argv[])
{
  return testPatternPicture("graphite", argc, argv);
}
