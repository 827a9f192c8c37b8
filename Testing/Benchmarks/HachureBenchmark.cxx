// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// hachure-benchmark: what patterns cost, relative to VTK's own drawing.

#include "BenchmarkOptions.h"
#include "PatternCost.h"
#include "UserError.h"
#include "WaveletSurface.h"

#include <vtk_jsoncpp.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>

namespace hachure::benchmark
{
using hachure::program::UserError;

namespace
{
constexpr int Digits = 4;

std::string describe(const std::string& style, const PatternCost& cost)
{
  char coverage[64];
  std::snprintf(coverage, sizeof(coverage), "%.1f %%", 100.0 * cost.coverage);
  std::string text = "style " + style + "; plain is vtkPolyDataMapper; surface covers " + coverage +
    " of the picture; memory_bytes is OpenGL objects that the style adds";
  text += cost.gpu ? "; gpu_ms by timer query" : "; gpu_ms null, no graphics processor to time";
  return text;
}

Json::Value toJson(const LayerConfiguration& layer, vtkPolyData* surface,
  const BenchmarkOptions& options, const PatternCost& cost)
{
  Json::Value row;
  row["layer"] = layer.layer;
  row["config"] = describe(layer.style, cost);
  row["triangles"] = static_cast<Json::Int64>(surface->GetNumberOfPolys());
  row["patches"] = options.patches;
  row["width"] = options.size[0];
  row["height"] = options.size[1];
  row["plain_cpu_ms"] = cost.plainCpu;
  row["pattern_cpu_ms"] = cost.patternCpu;
  row["cpu_ratio"] = cost.cpuRatio;
  row["wall_ratio"] = cost.wallRatio;
  row["gpu_ms"] = cost.gpu ? Json::Value(*cost.gpu) : Json::Value();
  row["memory_bytes"] = static_cast<Json::Int64>(cost.memory);
  return row;
}

Json::Value measureAll(const BenchmarkOptions& options)
{
  Json::Value rows(Json::arrayValue);
  for (const int triangles : options.triangles)
  {
    auto surface = waveletSurface(triangles);
    if (options.patches > 1)
    {
      surface = inPatches(surface, options.patches);
    }
    for (const LayerConfiguration& layer : options.layers)
    {
      std::fprintf(stderr, "layer %s, style %s, %lld triangles\n", layer.layer.c_str(),
        layer.style.c_str(), static_cast<long long>(surface->GetNumberOfPolys()));
      rows.append(toJson(layer, surface, options, measure(surface, layer, options)));
    }
  }
  return rows;
}

void run(const BenchmarkOptions& options)
{
  for (const LayerConfiguration& layer : options.layers)
  {
    checkStyle(layer.style);
  }
  // Before measuring, which takes long. Under another name until it is whole.
  const std::string part = options.json + ".part";
  std::ofstream file;
  if (!options.json.empty())
  {
    file.open(part);
    if (!file)
    {
      throw UserError("cannot write '" + options.json + "'");
    }
  }
  try
  {
    Json::StreamWriterBuilder builder;
    builder["indentation"] = "  ";
    builder["precision"] = Digits;
    const std::string text = Json::writeString(builder, measureAll(options)) + "\n";
    std::cout << text << std::flush;
    if (!options.json.empty())
    {
      file << text;
      file.close();
      if (!file || std::rename(part.c_str(), options.json.c_str()) != 0)
      {
        throw UserError("cannot write '" + options.json + "'");
      }
    }
  }
  catch (...)
  {
    if (!options.json.empty())
    {
      std::remove(part.c_str());
    }
    throw;
  }
}
} // namespace
} // namespace hachure::benchmark

//----------------------------------------------------------------------------
int main(int argumentCount, char** arguments)
{
  try
  {
    const auto options = hachure::benchmark::parseOptions(argumentCount, arguments);
    if (options.help)
    {
      std::fputs(hachure::benchmark::helpText(), stdout);
    }
    else
    {
      hachure::benchmark::run(options);
    }
    return 0;
  }
  catch (const hachure::program::UserError& error)
  {
    std::fprintf(stderr, "hachure-benchmark: %s\n", error.what());
    return 2;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "hachure-benchmark: %s\n", error.what());
    return 1;
  }
}
