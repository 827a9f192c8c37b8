// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FrameCost.h"

#include <vtkOpenGLRenderTimer.h>

#include <time.h>

#include <algorithm>
#include <string>

namespace hachure::benchmark
{
namespace
{
double milliseconds(clockid_t clock)
{
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}
} // namespace

//----------------------------------------------------------------------------
FrameCost drawFrame(vtkRenderWindow* window, bool timeGpu)
{
  vtkOpenGLRenderTimer timer;
  window->MakeCurrent();
  window->WaitForCompletion();
  const double cpu = milliseconds(CLOCK_PROCESS_CPUTIME_ID);
  const double wall = milliseconds(CLOCK_MONOTONIC);
  if (timeGpu)
  {
    timer.Start();
  }
  window->Render();
  if (timeGpu)
  {
    timer.Stop();
  }
  window->WaitForCompletion();
  FrameCost cost;
  cost.cpu = milliseconds(CLOCK_PROCESS_CPUTIME_ID) - cpu;
  cost.wall = milliseconds(CLOCK_MONOTONIC) - wall;
  if (timeGpu)
  {
    while (!timer.Ready())
    {
      window->WaitForCompletion();
    }
    cost.gpu = timer.GetElapsedNanoseconds() * 1e-6;
  }
  return cost;
}

//----------------------------------------------------------------------------
bool hasGraphicsProcessor(vtkRenderWindow* window)
{
  const std::string capabilities = window->ReportCapabilities();
  const auto names = [&](const char* name) { return capabilities.find(name) != std::string::npos; };
  return vtkOpenGLRenderTimer::IsSupported() && !names("llvmpipe") && !names("softpipe") &&
    !names("SWR");
}

//----------------------------------------------------------------------------
double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}
} // namespace hachure::benchmark
