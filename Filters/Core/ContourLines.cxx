// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ContourLines.h"

#include "ContourSegments.h"
#include "ContourVisibility.h"
#include "Parallel.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

namespace hachure
{
namespace
{

constexpr double shortestRun = 2.0;  // pixels: shorter gaps and remainders are mended
constexpr double pointSpacing = 0.1; // pixels

void check(const TriangleMesh& mesh, const ViewProjection& view, const ContourDepth& depth,
  const ContourOptions& options)
{
  checkView(view);
  const auto points = static_cast<std::int64_t>(mesh.points.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int corner = mesh.triangles[i][k];
      if (corner < 0 || corner >= points)
      {
        throw std::invalid_argument("mesh.triangles[" + std::to_string(i) + "]: corner " +
          std::to_string(corner) + " is not one of the " + std::to_string(points) + " points");
      }
    }
  }
  const std::array<int, 4>& box = depth.rectangle;
  if (!depth.values.empty() &&
    (box[2] < 0 || box[3] < 0 ||
      depth.values.size() != static_cast<std::size_t>(box[2]) * static_cast<std::size_t>(box[3])))
  {
    throw std::invalid_argument("depth.values: " + std::to_string(depth.values.size()) +
      " values for " + std::to_string(box[2]) + " x " + std::to_string(box[3]) + " pixels");
  }
  if (!(options.creaseAngle >= 0.0 && options.creaseAngle <= 180.0))
  {
    throw std::invalid_argument("options.creaseAngle: " + std::to_string(options.creaseAngle) +
      " degrees, expected 0 to 180");
  }
}

// Steps with one answer.
struct Run
{
  std::size_t begin = 0, end = 0;
  bool isSeen = false;
  double length = 0.0;
};

std::vector<Run> runsOf(const std::vector<ContourStep>& steps, std::size_t begin, std::size_t end)
{
  std::vector<Run> runs;
  for (std::size_t i = begin; i < end; ++i)
  {
    if (runs.empty() || runs.back().isSeen != steps[i].isSeen)
    {
      runs.push_back({ i, i, steps[i].isSeen, 0.0 });
    }
    runs.back().end = i + 1;
    runs.back().length += glm::distance(steps[i].from, steps[i].to);
  }
  return runs;
}

void setSeen(std::vector<ContourStep>& steps, const Run& run, bool seen)
{
  for (std::size_t i = run.begin; i < run.end; ++i)
  {
    steps[i].isSeen = seen;
  }
}

// First gaps between longer lines, then what is left over between hidden parts.
void mend(std::vector<ContourStep>& steps, std::size_t begin, std::size_t end)
{
  const std::vector<Run> runs = runsOf(steps, begin, end);
  for (std::size_t i = 1; i + 1 < runs.size(); ++i)
  {
    const double shorter = std::min(runs[i - 1].length, runs[i + 1].length);
    if (!runs[i].isSeen && runs[i].length < std::min(shortestRun, shorter))
    {
      setSeen(steps, runs[i], true);
    }
  }
  const std::vector<Run> mended = runsOf(steps, begin, end);
  for (const Run& run : mended)
  {
    if (run.isSeen && run.length < shortestRun && mended.size() > 1)
    {
      setSeen(steps, run, false);
    }
  }
}

// A loop that is hidden somewhere begins where it is hidden longest: then it is like a line. Gaps
// that can be mended do not count; it then begins within what is seen.
void turnLoop(std::vector<ContourStep>& steps)
{
  const std::vector<Run> runs = runsOf(steps, 0, steps.size());
  if (runs.size() < 2)
  {
    return;
  }
  const auto isShorter = [](const Run& a, const Run& b) { return a.length < b.length; };
  const auto hiddenLength = [](const Run& run) { return run.isSeen ? 0.0 : run.length; };
  const auto hidden = std::max_element(runs.begin(), runs.end(),
    [&](const Run& a, const Run& b) { return hiddenLength(a) < hiddenLength(b); });
  const auto longest = std::max_element(runs.begin(), runs.end(), isShorter);
  const std::size_t begin = hiddenLength(*hidden) < shortestRun
    ? longest->begin + (longest->end - longest->begin) / 2
    : hidden->begin;
  std::rotate(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(begin), steps.end());
}

void addPoint(std::vector<glm::dvec2>& points, const glm::dvec2& point)
{
  if (points.empty() || glm::distance(points.back(), point) >= pointSpacing)
  {
    points.push_back(point);
  }
}

// What is seen of joined steps.
void addLines(const std::vector<ContourStep>& steps, const Run& run, bool closed,
  std::vector<ContourLine>& lines)
{
  ContourLine line;
  line.closed = closed;
  for (std::size_t i = run.begin; i < run.end; ++i)
  {
    if (i == run.begin || steps[i].startsPiece)
    {
      addPoint(line.points, steps[i].from);
    }
  }
  const glm::dvec2 last = steps[run.end - 1].to;
  if (closed)
  {
    // The last point is the first one again.
    while (line.points.size() > 1 && glm::distance(line.points.back(), last) < pointSpacing)
    {
      line.points.pop_back();
    }
  }
  else
  {
    if (line.points.size() > 1 && glm::distance(line.points.back(), last) < pointSpacing)
    {
      line.points.pop_back();
    }
    line.points.push_back(last);
  }
  lines.push_back(std::move(line));
}

class ChainDrawer
{
public:
  ChainDrawer(
    const std::vector<ContourSegment>& contourSegments, const ContourVisibility& contourVisibility)
    : segments(contourSegments)
    , visibility(contourVisibility)
  {
  }

  std::vector<ContourLine> draw(const ContourChain& chain)
  {
    std::vector<ContourLine> lines;
    std::vector<ContourStep> steps;
    for (const ContourChain::Link& link : chain.links)
    {
      this->visibility.addSteps(this->segments[link.segment], link.reversed, steps);
    }
    bool closed = chain.closed && this->closeLoop(steps);
    if (closed)
    {
      turnLoop(steps);
    }
    for (std::size_t begin = 0; begin < steps.size();)
    {
      std::size_t end = begin + 1;
      while (end < steps.size() && (closed || steps[end].isJoined))
      {
        ++end;
      }
      mend(steps, begin, end);
      const std::vector<Run> runs = runsOf(steps, begin, end);
      closed = closed && runs.size() == 1;
      for (const Run& run : runs)
      {
        if (run.isSeen)
        {
          addLines(steps, run, closed, lines);
        }
      }
      begin = end;
    }
    return lines;
  }

private:
  // Whether nothing of a loop was cut off. If something was, it begins after the first cut.
  bool closeLoop(std::vector<ContourStep>& steps) const
  {
    if (steps.empty())
    {
      return false;
    }
    steps.front().isJoined =
      glm::distance(steps.back().to, steps.front().from) < 0.5 * pointSpacing;
    const auto cut = std::find_if(
      steps.begin(), steps.end(), [](const ContourStep& step) { return !step.isJoined; });
    if (cut == steps.end())
    {
      return true;
    }
    std::rotate(steps.begin(), cut, steps.end());
    return false;
  }

  const std::vector<ContourSegment>& segments;
  const ContourVisibility& visibility;
};

} // namespace

std::vector<ContourLine> contourLines(const TriangleMesh& mesh, const ViewProjection& view,
  const ContourDepth& depth, const ContourOptions& options)
{
  check(mesh, view, depth, options);
  const std::vector<ContourSegment> segments = contourSegments(mesh, view, options);
  const std::vector<ContourChain> chains = chainContours(segments);
  const ContourVisibility visibility(view, depth);
  std::vector<std::vector<ContourLine>> drawn(chains.size());
  parallelFor(static_cast<std::int64_t>(chains.size()),
    [&](std::int64_t i) { drawn[i] = ChainDrawer(segments, visibility).draw(chains[i]); });
  std::vector<ContourLine> lines;
  for (std::vector<ContourLine>& part : drawn)
  {
    lines.insert(
      lines.end(), std::make_move_iterator(part.begin()), std::make_move_iterator(part.end()));
  }
  return lines;
}

} // namespace hachure
