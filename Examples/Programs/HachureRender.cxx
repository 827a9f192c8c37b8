// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// hachure-render: draws a file's surface with a pattern style, as pictures and a movie.

#include "Animation.h"
#include "FrameSink.h"
#include "OutputFolder.h"
#include "RenderOptions.h"
#include "Scene.h"
#include "UserError.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>

namespace hachure::program
{
namespace
{
constexpr int OrbitFrameRate = 24;
/// How often progress is told where it cannot be overwritten.
constexpr int ProgressSteps = 10;

/// The turntable view of a frame of an orbit, zoomed by equal factors from frame to frame.
TurntableView orbitView(const RenderOptions& options, int frame, int frames)
{
  TurntableView view;
  view.azimuth += 360.0 * frame / frames;
  if (options.zoom)
  {
    const double part = frames > 1 ? static_cast<double>(frame) / (frames - 1) : 0.0;
    view.zoom = (*options.zoom)[0] * std::pow((*options.zoom)[1] / (*options.zoom)[0], part);
  }
  return view;
}

void tellProgress(int done, int frames)
{
  if (isatty(STDERR_FILENO))
  {
    std::fprintf(stderr, "\rframe %d of %d%s", done, frames, done == frames ? "\n" : "");
  }
  else if (done == frames || done * ProgressSteps / frames != (done - 1) * ProgressSteps / frames)
  {
    std::fprintf(stderr, "frame %d of %d\n", done, frames);
  }
}

void render(const RenderOptions& options)
{
  const auto start = std::chrono::steady_clock::now();
  checkWritableFolder(options.output);
  Scene scene(options);
  std::unique_ptr<Animation> animation;
  if (!options.animation.empty())
  {
    animation = std::make_unique<Animation>(options.animation, scene);
  }
  FrameSinkOptions output;
  output.folder = options.output;
  output.width = options.size[0];
  output.height = options.size[1];
  output.frames = animation ? animation->numberOfFrames() : std::max(1, options.orbit);
  output.movie = options.movie;
  output.frameRate = animation ? animation->frameRate() : OrbitFrameRate;
  FrameSink sink(output);
  for (int frame = 0; frame < output.frames; ++frame)
  {
    if (animation)
    {
      animation->apply(frame, scene);
    }
    else
    {
      scene.setTime(static_cast<double>(frame) / output.frameRate);
      scene.setView(orbitView(options, frame, output.frames));
    }
    sink.add(scene.draw());
    tellProgress(frame + 1, output.frames);
  }
  sink.finish();
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  std::fprintf(
    stderr, "%d frames in %s, %.1f s\n", output.frames, options.output.c_str(), spent.count());
}

void listStyles()
{
  for (const std::string& name : styleNames())
  {
    std::printf("%s\n", name.c_str());
  }
}

void run(const RenderOptions& options)
{
  switch (options.action)
  {
    case Action::Help:
      std::fputs(helpText(), stdout);
      break;
    case Action::Version:
      std::printf("hachure-render %s\n", HACHURE_VERSION);
      break;
    case Action::ListStyles:
      listStyles();
      break;
    case Action::Render:
      render(options);
      break;
  }
}
} // namespace
} // namespace hachure::program

//----------------------------------------------------------------------------
int main(int argumentCount, char** arguments)
{
  try
  {
    hachure::program::run(hachure::program::parseOptions(argumentCount, arguments));
    return 0;
  }
  catch (const hachure::program::UserError& error)
  {
    std::fprintf(stderr, "hachure-render: %s\n", error.what());
    return 2;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "hachure-render: %s\n", error.what());
    return 1;
  }
}
