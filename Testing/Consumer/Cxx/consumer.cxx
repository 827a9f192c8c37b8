// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// A program of another project: the three libraries link, their headers are complete, and a style
// loads.

#include <Core/Parallel.h>
#include <Core/Span.h>
#include <vtkNew.h>
#include <vtkPatternStyle.h>

#include <cstdlib>
#include <iostream>
#include <vector>

int main()
{
  std::vector<int> squares(1000);
  hachure::parallelFor(1000, [&](std::int64_t i) { squares[i] = static_cast<int>(i * i); });
  const hachure::Span<const int> view = squares;
  vtkNew<vtkPatternStyle> style;
  if (view[999] != 998001 || !style->LoadPreset("cross-hatch"))
  {
    std::cerr << "wrong answer from the installed libraries\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
