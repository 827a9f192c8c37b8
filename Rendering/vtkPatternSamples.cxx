// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternSamples.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStratifiedSurfaceSampler.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace
{
std::uint64_t Mix(std::uint64_t hash, std::uint64_t value)
{
  hash ^= value + 0x9e3779b97f4a7c15ULL + (hash << 6) + (hash >> 2);
  return hash;
}

glm::dvec3 Point(vtkPolyData* data, long long id)
{
  glm::dvec3 point;
  data->GetPoint(id, &point[0]);
  return point;
}
} // namespace

bool vtkPatternSamples::Update(vtkDataObject* input, const Options& options, Surface* replaced)
{
  const vtkPatternGeometry::Change change = this->Geometry.Update(input);
  const bool moved =
    change != vtkPatternGeometry::NOTHING || this->PositionVersion != this->FirstPositionVersion;
  const bool sameSamples = change != vtkPatternGeometry::REPLACED && !(options != this->Current) &&
    this->SetVersion > 0 && !(this->IsAnew && moved);
  this->IsAnew = false;
  if (sameSamples && change == vtkPatternGeometry::NOTHING)
  {
    return false;
  }
  if (!sameSamples)
  {
    if (replaced)
    {
      *replaced = { std::move(this->Positions), std::move(this->Normals), std::move(this->Patches),
        std::move(this->PatchSpacing) };
    }
    this->Sample(input, options);
  }
  this->Move();
  this->FirstPositionVersion = sameSamples ? this->FirstPositionVersion : this->PositionVersion;
  return true;
}

void vtkPatternSamples::BeginAnew()
{
  this->IsAnew = true;
}

void vtkPatternSamples::Read(const std::string& role, const std::string& name, int components,
  Association where, Values& values) const
{
  const std::string expected = std::to_string(components) +
    (components == 1 ? " component" : " components") + " for every point" +
    (where == Association::PointsOrCells ? " or cell" : "");
  const auto refuse = [&](const char* what, const std::string& found)
  {
    throw std::invalid_argument(
      role + ": " + what + " '" + name + "'" + found + ", expected " + expected);
  };
  struct Source
  {
    vtkDataArray* Array;
    bool OfPoints;
  };
  std::vector<Source> sources;
  std::uint64_t stamp = Mix(this->SetVersion, this->PositionVersion);
  for (const vtkPatternGeometry::Block& block : this->Geometry.GetBlocks())
  {
    Source source = { block.Data->GetPointData()->GetArray(name.c_str()), true };
    if (!source.Array && where == Association::PointsOrCells)
    {
      source = { block.Data->GetCellData()->GetArray(name.c_str()), false };
    }
    const bool used = block.Data->GetNumberOfPolys() > 0 || block.Data->GetNumberOfStrips() > 0;
    if (used && !source.Array)
    {
      refuse("no array", "");
    }
    if (used && source.Array->GetNumberOfComponents() != components)
    {
      refuse(
        "array", " has " + std::to_string(source.Array->GetNumberOfComponents()) + " components");
    }
    stamp = Mix(stamp, source.Array ? source.Array->GetMTime() : 0);
    sources.push_back(source);
  }
  if (values.Stamp == stamp)
  {
    return;
  }
  const auto stride = static_cast<std::size_t>(components);
  values.Numbers.assign(stride * this->Count(), 0.0);
  for (std::size_t i = 0; i < this->Count(); ++i)
  {
    const Source& source = sources[this->SampleBlock[i]];
    this->ReadSample(i, source.Array, source.OfPoints, &values.Numbers[stride * i]);
  }
  values.Stamp = stamp;
}

void vtkPatternSamples::ReadSample(
  std::size_t sample, vtkDataArray* array, bool ofPoints, double* numbers) const
{
  for (int component = 0; component < array->GetNumberOfComponents(); ++component)
  {
    if (!ofPoints)
    {
      numbers[component] = array->GetComponent(this->SampleCell[sample], component);
      continue;
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      const auto k = static_cast<std::size_t>(corner);
      numbers[component] += this->Barycentrics[sample][corner] *
        array->GetComponent(this->SampleCorners[sample][k], component);
    }
  }
}

void vtkPatternSamples::Sample(vtkDataObject* input, const Options& options)
{
  this->Current = options;
  ++this->SetVersion;
  vtkNew<vtkStratifiedSurfaceSampler> sampler;
  sampler->SetInputDataObject(input);
  sampler->SetSamplesPerPatch(options.SamplesPerPatch);
  sampler->SetSeed(options.Seed);
  sampler->SetPatchArrayName(options.PatchArrayName);
  sampler->Update();
  vtkPolyData* samples = sampler->GetOutput();
  const vtkIdType count = samples->GetNumberOfPoints();
  vtkPointData* arrays = samples->GetPointData();
  vtkDataArray* corners = arrays->GetArray("PointIds");
  vtkDataArray* weights = arrays->GetArray("Barycentrics");
  vtkDataArray* patches = arrays->GetArray("PatchId");
  vtkDataArray* normals = arrays->GetArray("Normals");
  vtkDataArray* blockIds = arrays->GetArray("BlockIndex");
  vtkDataArray* cells = arrays->GetArray("CellId");
  vtkDataArray* spacing = samples->GetFieldData()->GetArray("PatchSpacing");

  this->SampleBlock.clear();
  this->SampleCorners.clear();
  this->SampleCell.clear();
  this->Barycentrics.clear();
  this->Patches.clear();
  this->Orientation.clear();
  this->PatchSpacing.clear();
  for (vtkIdType i = 0; spacing && i < spacing->GetNumberOfTuples(); ++i)
  {
    this->PatchSpacing.push_back(spacing->GetComponent(i, 0));
  }
  if (count == 0)
  {
    return;
  }

  const auto size = static_cast<std::size_t>(count);
  this->SampleBlock.reserve(size);
  this->SampleCorners.reserve(size);
  this->SampleCell.reserve(size);
  this->Barycentrics.reserve(size);
  this->Patches.reserve(size);
  this->Orientation.reserve(size);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto flatIndex = static_cast<unsigned int>(blockIds->GetComponent(i, 0));
    const auto found = std::find_if(this->Geometry.GetBlocks().begin(),
      this->Geometry.GetBlocks().end(),
      [flatIndex](const vtkPatternGeometry::Block& block) { return block.FlatIndex == flatIndex; });
    this->SampleBlock.push_back(
      static_cast<std::uint32_t>(found - this->Geometry.GetBlocks().begin()));
    this->SampleCorners.push_back({ static_cast<long long>(corners->GetComponent(i, 0)),
      static_cast<long long>(corners->GetComponent(i, 1)),
      static_cast<long long>(corners->GetComponent(i, 2)) });
    this->SampleCell.push_back(static_cast<long long>(cells->GetComponent(i, 0)));
    this->Barycentrics.emplace_back(
      weights->GetComponent(i, 0), weights->GetComponent(i, 1), weights->GetComponent(i, 2));
    this->Patches.push_back(static_cast<std::int32_t>(patches->GetComponent(i, 0)));
    vtkPolyData* data = this->Geometry.GetBlocks()[this->SampleBlock.back()].Data;
    const auto& ids = this->SampleCorners.back();
    const glm::dvec3 a = Point(data, ids[0]);
    const glm::dvec3 winding = glm::cross(Point(data, ids[1]) - a, Point(data, ids[2]) - a);
    const glm::dvec3 outward(
      normals->GetComponent(i, 0), normals->GetComponent(i, 1), normals->GetComponent(i, 2));
    this->Orientation.push_back(glm::dot(winding, outward) < 0.0 ? -1 : 1);
  }
}

void vtkPatternSamples::Move()
{
  ++this->PositionVersion;
  const std::size_t count = this->SampleCorners.size();
  this->Positions.resize(count);
  this->Normals.resize(count);
  glm::dvec3 lower(0.0);
  glm::dvec3 upper(0.0);
  for (std::size_t i = 0; i < count; ++i)
  {
    vtkPolyData* data = this->Geometry.GetBlocks()[this->SampleBlock[i]].Data;
    const auto& ids = this->SampleCorners[i];
    const glm::dvec3 a = Point(data, ids[0]);
    const glm::dvec3 b = Point(data, ids[1]);
    const glm::dvec3 c = Point(data, ids[2]);
    const glm::dvec3& w = this->Barycentrics[i];
    this->Positions[i] = w.x * a + w.y * b + w.z * c;
    const glm::dvec3 winding = glm::cross(b - a, c - a);
    const double length = glm::length(winding);
    this->Normals[i] = length > 0.0 ? winding * (this->Orientation[i] / length) : glm::dvec3(0.0);
    lower = i == 0 ? this->Positions[i] : glm::min(lower, this->Positions[i]);
    upper = i == 0 ? this->Positions[i] : glm::max(upper, this->Positions[i]);
  }
  this->Center = 0.5 * (lower + upper);
}

hachure::TrackedSamples vtkPatternSamples::Tracked() const
{
  hachure::TrackedSamples tracked;
  tracked.positions = this->Positions;
  tracked.normals = this->Normals;
  tracked.patches = this->Patches;
  tracked.patchSpacing = this->PatchSpacing;
  return tracked;
}

double vtkPatternSamples::Spacing(std::size_t sample) const
{
  const auto patch = static_cast<std::size_t>(this->Patches[sample]);
  return patch < this->PatchSpacing.size() ? this->PatchSpacing[patch] : 0.0;
}
