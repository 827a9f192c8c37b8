// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternMetrics.h"

#include "Core/PatternMetricsCooccurrence.h"
#include "Core/PatternMetricsFlatness.h"
#include "Core/PatternMetricsMotion.h"
#include "Core/PatternMetricsStipples.h"
#include "Core/PatternMetricsTone.h"
#include "PatternMetricsInput.h"

#include <vtkDoubleArray.h>
#include <vtkFFT.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPatternMetrics);

namespace
{

constexpr int portCount = 6;
constexpr double notKnown = std::numeric_limits<double>::quiet_NaN();
const char* const inkExpected = "1 component of linear ink";

// Output 0, a row at a time.
class MetricRows
{
public:
  explicit MetricRows(vtkTable* table)
  {
    this->names->SetName("Metric");
    this->values->SetName("Value");
    table->AddColumn(this->names);
    table->AddColumn(this->values);
  }
  void add(const char* name, double value)
  {
    this->names->InsertNextValue(name);
    this->values->InsertNextValue(value);
  }

private:
  vtkNew<vtkStringArray> names;
  vtkNew<vtkDoubleArray> values;
};

template <class ArrayType, class Value>
void addColumn(vtkTable* table, const char* name, std::size_t rows, Value&& value)
{
  vtkNew<ArrayType> column;
  column->SetName(name);
  for (std::size_t row = 0; row < rows; ++row)
  {
    column->InsertNextValue(value(row));
  }
  table->AddColumn(column);
}

void transform(std::vector<std::complex<double>>& values)
{
  std::vector<vtkFFT::ComplexNumber> input(values.size());
  std::transform(values.begin(), values.end(), input.begin(),
    [](const std::complex<double>& value) {
      return vtkFFT::ComplexNumber{ value.real(), value.imag() };
    });
  const std::vector<vtkFFT::ComplexNumber> output = vtkFFT::Fft(input);
  std::transform(output.begin(), output.end(), values.begin(),
    [](const vtkFFT::ComplexNumber& value) { return std::complex<double>(value.r, value.i); });
}

std::vector<hachure::MetricPlanes> readAll(
  vtkInformationVector* inputs, const char* name, int fewest, int most, const char* expected)
{
  std::vector<hachure::MetricPlanes> images;
  images.reserve(static_cast<std::size_t>(inputs->GetNumberOfInformationObjects()));
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    images.push_back(hachure::readPlanes(vtkImageData::GetData(inputs, i),
      name + std::string(" ") + std::to_string(i), fewest, most, expected));
  }
  return images;
}

// All that belongs to a clip; the views point into the planes.
struct ClipInput
{
  std::vector<hachure::MetricPlanes> frames;
  std::vector<hachure::MetricPlanes> motions;
  std::vector<hachure::MetricPlanes> references; // at most one
  hachure::PatternClip clip;

  explicit ClipInput(vtkInformationVector** inputs)
    : frames(readAll(inputs[vtkPatternMetrics::FRAMES], "frame", 1, 1, inkExpected))
    , motions(
        readAll(inputs[vtkPatternMetrics::MOTIONS], "motion", 3, 5, "u, v and visible, at least"))
    , references(readAll(inputs[vtkPatternMetrics::REFERENCE], "reference", 1, 1, inkExpected))
  {
    for (const auto& frame : this->frames)
    {
      this->clip.frames.push_back(frame.view());
    }
    for (const auto& motion : this->motions)
    {
      this->clip.motions.push_back(hachure::motionOf(motion));
    }
  }
};

void addMotionRows(const hachure::MotionMetrics& metrics, MetricRows& rows)
{
  rows.add("SlideRatio", metrics.slideRatio);
  rows.add("NormalSlideRatio", metrics.normalSlideRatio);
  rows.add("Coherence", metrics.coherence);
  rows.add("MeanSlide", metrics.meanSlide);
  rows.add("MeanMotion", metrics.meanMotion);
  rows.add("LargestMotion", metrics.largestMotion);
  rows.add("BoilMedian", metrics.medianBoil);
  rows.add("BoilLargest", metrics.largestBoil);
  rows.add("Pop", metrics.pop);
}

double meanOf(const std::vector<double>& values)
{
  double sum = 0.0;
  for (const double value : values)
  {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

// Deviations of the ink, in units of the reference or of the first frame.
std::vector<double> contrasts(const ClipInput& input, double minimumFacing)
{
  std::vector<double> deviations = hachure::inkDeviations(input.clip, minimumFacing);
  const double unit = input.references.empty()
    ? deviations.front()
    : hachure::inkDeviation(input.references.front().view());
  for (double& deviation : deviations)
  {
    deviation = unit > 0.0 ? deviation / unit : notKnown;
  }
  return deviations;
}

// NaN without a reference.
hachure::CooccurrenceMetrics cooccurrenceOf(
  const ClipInput& input, const hachure::MotionMetricsOptions& options)
{
  if (input.references.empty())
  {
    return { notKnown, std::vector<double>(input.clip.motions.size(), notKnown) };
  }
  return hachure::measureCooccurrence(input.clip, input.references.front().view(),
    { options.wavelength, options.minimumFacing, options.smoothing });
}

// The columns that have a number for every frame with a motion.
struct FrameColumns
{
  std::vector<double> contrast;
  std::vector<double> frequencies;
  std::vector<double> cooccurrence;
};

void fillFrames(vtkTable* table, const hachure::MotionMetrics& motion, const FrameColumns& numbers)
{
  const std::size_t rows = numbers.contrast.size();
  addColumn<vtkIntArray>(
    table, "Frame", rows, [](std::size_t row) { return static_cast<int>(row); });
  using Step = hachure::StepMetrics;
  const std::pair<const char*, double Step::*> columns[] = { { "Coherence", &Step::coherence },
    { "Boil", &Step::boil }, { "Slide", &Step::slide }, { "Motion", &Step::motion },
    { "NormalSlide", &Step::normalSlide }, { "NormalMotion", &Step::normalMotion } };
  const auto& steps = motion.steps;
  for (const auto& column : columns)
  {
    addColumn<vtkDoubleArray>(table, column.first, rows,
      [&](std::size_t row) { return row < steps.size() ? steps[row].*column.second : notKnown; });
  }
  addColumn<vtkIntArray>(table, "Blocks", rows,
    [&](std::size_t row) { return row < steps.size() ? steps[row].blocks : 0; });
  using Numbers = FrameColumns;
  const std::pair<const char*, std::vector<double> Numbers::*> more[] = { { "Contrast",
                                                                            &Numbers::contrast },
    { "Frequency", &Numbers::frequencies }, { "CooccurrenceError", &Numbers::cooccurrence } };
  for (const auto& column : more)
  {
    addColumn<vtkDoubleArray>(
      table, column.first, rows, [&](std::size_t row) { return (numbers.*column.second)[row]; });
  }
}

double flickerOf(
  const hachure::PatternClip& clip, vtkInformationVector* inputs, int minimumCellPixels)
{
  std::vector<hachure::MetricLabels> labels;
  labels.reserve(static_cast<std::size_t>(inputs->GetNumberOfInformationObjects()));
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    labels.push_back(
      hachure::readLabels(vtkImageData::GetData(inputs, i), "cells " + std::to_string(i)));
  }
  std::vector<hachure::LabelView> views;
  views.reserve(labels.size());
  for (const hachure::MetricLabels& label : labels)
  {
    views.push_back({ label.width, label.height, label.values });
  }
  return hachure::toneFlicker(clip.frames, views, minimumCellPixels);
}

void addToneRows(const hachure::PatternClip& clip, vtkInformationVector* inputs, double wavelength,
  MetricRows& rows)
{
  const auto tones = readAll(inputs, "tone", 1, 1, "1 component of tone");
  if (clip.frames.empty() || (tones.size() != 1 && tones.size() != clip.frames.size()))
  {
    throw std::invalid_argument("tones: " + std::to_string(tones.size()) + " for " +
      std::to_string(clip.frames.size()) + " frames, expected one for each, or one for all");
  }
  hachure::ToneError worst{ 0.0, 0.0 };
  for (std::size_t t = 0; t < clip.frames.size(); ++t)
  {
    const hachure::ToneError error =
      hachure::measureTone(clip.frames[t], tones[std::min(t, tones.size() - 1)].view(), wavelength);
    worst.largest = std::max(worst.largest, error.largest);
    worst.drop = std::max(worst.drop, error.drop);
  }
  rows.add("ToneError", worst.largest);
  rows.add("ToneDrop", worst.drop);
}

struct ClipOptions
{
  hachure::MotionMetricsOptions motion;
  int flatnessWindow = 64;
  int minimumCellPixels = 16;
};

bool isGiven(vtkInformationVector* inputs)
{
  return inputs->GetNumberOfInformationObjects() > 0;
}

// What needs motions. Returns the largest motion of a block, in pixels.
double measureMoving(
  const ClipInput& input, const ClipOptions& options, MetricRows& rows, vtkTable* frames)
{
  const hachure::MotionMetrics motion = hachure::measureMotion(input.clip, options.motion);
  addMotionRows(motion, rows);
  const std::vector<double> contrast = contrasts(input, options.motion.minimumFacing);
  rows.add("Contrast", meanOf(contrast));
  const hachure::FlatnessMetrics flatness = hachure::measureFlatness(
    input.clip, transform, { options.flatnessWindow, options.motion.minimumFacing });
  rows.add("FacingSlope", flatness.facingSlope);
  rows.add("DistanceSlope", flatness.distanceSlope);
  const hachure::CooccurrenceMetrics cooccurrence = cooccurrenceOf(input, options.motion);
  if (!input.references.empty())
  {
    rows.add("CooccurrenceError", cooccurrence.error);
  }
  fillFrames(frames, motion, { contrast, flatness.frequencies, cooccurrence.frames });
  return motion.largestMotion;
}

double measureClip(
  vtkInformationVector** inputs, const ClipOptions& options, MetricRows& rows, vtkTable* frames)
{
  using Metrics = vtkPatternMetrics;
  const ClipInput input(inputs);
  double largestMotion = 0.0;
  if (isGiven(inputs[Metrics::MOTIONS]) || !isGiven(inputs[Metrics::TONES]))
  {
    largestMotion = measureMoving(input, options, rows, frames);
  }
  if (isGiven(inputs[Metrics::CELLS]))
  {
    rows.add(
      "ToneFlicker", flickerOf(input.clip, inputs[Metrics::CELLS], options.minimumCellPixels));
  }
  if (isGiven(inputs[Metrics::TONES]))
  {
    addToneRows(input.clip, inputs[Metrics::TONES], options.motion.wavelength, rows);
  }
  return largestMotion;
}

// The window that was set, or the bounds of all points.
hachure::StippleWindow windowOf(
  const std::vector<std::vector<glm::dvec2>>& sets, const double window[4], bool periodic)
{
  glm::dvec2 low(window[0], window[2]), high(window[1], window[3]);
  if (low.x > high.x)
  {
    low = glm::dvec2(std::numeric_limits<double>::infinity());
    high = -low;
    for (const auto& points : sets)
    {
      for (const glm::dvec2 point : points)
      {
        low = glm::min(low, point);
        high = glm::max(high, point);
      }
    }
  }
  return { low, high - low, periodic };
}

void addStippleRows(const hachure::StippleMetrics& mean, MetricRows& rows)
{
  rows.add("ClarkEvans", mean.clarkEvans);
  rows.add("RelativeRadius", mean.relativeRadius);
  rows.add("LowFrequencyPower", mean.lowFrequencyPower);
  rows.add("MeanPower", mean.meanPower);
  rows.add("AnisotropyDecibels", mean.anisotropy);
}

void fillSpectrum(vtkTable* table, const std::vector<hachure::SpectrumRing>& rings)
{
  addColumn<vtkDoubleArray>(
    table, "Frequency", rings.size(), [&](std::size_t row) { return rings[row].frequency; });
  addColumn<vtkDoubleArray>(
    table, "Power", rings.size(), [&](std::size_t row) { return rings[row].power; });
  addColumn<vtkDoubleArray>(table, "AnisotropyDecibels", rings.size(),
    [&](std::size_t row) { return rings[row].anisotropy; });
  addColumn<vtkIntArray>(
    table, "Count", rings.size(), [&](std::size_t row) { return rings[row].count; });
}

void measureStippleSets(vtkInformationVector* inputs, const double window[4], bool periodic,
  MetricRows& rows, vtkTable* spectrum)
{
  std::vector<std::vector<glm::dvec2>> sets;
  sets.reserve(static_cast<std::size_t>(inputs->GetNumberOfInformationObjects()));
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    sets.push_back(hachure::readPlanePoints(vtkPolyData::GetData(inputs, i)));
  }
  const hachure::StippleWindow rectangle = windowOf(sets, window, periodic);
  std::vector<hachure::StippleMetrics> metrics;
  double nested = 1.0;
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    metrics.push_back(hachure::measureStipples(sets[i], rectangle));
    nested = i > 0 ? std::min(nested, hachure::nesting(sets[i - 1], sets[i])) : nested;
  }
  const hachure::StippleMetrics mean = hachure::meanOfStipples(metrics);
  addStippleRows(mean, rows);
  if (sets.size() > 1)
  {
    rows.add("Nesting", nested);
  }
  fillSpectrum(spectrum, mean.rings);
}

} // namespace

vtkPatternMetrics::vtkPatternMetrics()
{
  this->SetNumberOfInputPorts(portCount);
  this->SetNumberOfOutputPorts(3);
}

void vtkPatternMetrics::AddFrame(vtkImageData* ink)
{
  this->AddInputDataObject(FRAMES, ink);
}

void vtkPatternMetrics::AddMotion(vtkImageData* motion)
{
  this->AddInputDataObject(MOTIONS, motion);
}

void vtkPatternMetrics::AddStipples(vtkPolyData* points)
{
  this->AddInputDataObject(STIPPLES, points);
}

void vtkPatternMetrics::AddCells(vtkImageData* cells)
{
  this->AddInputDataObject(CELLS, cells);
}

void vtkPatternMetrics::AddTone(vtkImageData* tone)
{
  this->AddInputDataObject(TONES, tone);
}

void vtkPatternMetrics::SetReference(vtkImageData* ink)
{
  this->SetInputDataObject(REFERENCE, ink);
}

void vtkPatternMetrics::RemoveAllInputs()
{
  for (int port = 0; port < portCount; ++port)
  {
    this->RemoveAllInputConnections(port);
  }
}

int vtkPatternMetrics::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == STIPPLES ? "vtkPolyData" : "vtkImageData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  if (port != REFERENCE)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

int vtkPatternMetrics::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  for (int port = 0; port < portCount; ++port)
  {
    for (int i = 0; port != STIPPLES && i < inputVector[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* information = inputVector[port]->GetInformationObject(i);
      int whole[6] = { 0, -1, 0, -1, 0, -1 };
      information->Get(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
      information->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), whole, 6);
    }
  }
  return 1;
}

int vtkPatternMetrics::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkTable* tables[3];
  for (int port = 0; port < 3; ++port)
  {
    tables[port] = vtkTable::GetData(outputVector, port);
  }
  try
  {
    if (!isGiven(inputVector[FRAMES]) && !isGiven(inputVector[STIPPLES]))
    {
      throw std::invalid_argument("Nothing to measure, expected frames or stipples.");
    }
    MetricRows rows(tables[0]);
    if (isGiven(inputVector[FRAMES]))
    {
      ClipOptions options;
      options.motion.wavelength = this->Wavelength;
      options.motion.minimumFacing = this->MinimumFacing;
      options.motion.smoothing = this->Smoothing;
      options.flatnessWindow = this->FlatnessWindow;
      options.minimumCellPixels = this->MinimumCellPixels;
      const double motion = measureClip(inputVector, options, rows, tables[1]);
      if (motion >= 0.5 * this->Wavelength)
      {
        vtkWarningMacro("The surface moves by up to "
          << motion << " pixels per frame, half the Wavelength of " << this->Wavelength
          << " or more: a pattern that slides so far is not recognised.");
      }
    }
    if (isGiven(inputVector[STIPPLES]))
    {
      measureStippleSets(
        inputVector[STIPPLES], this->StippleWindow, this->PeriodicStipples, rows, tables[2]);
    }
  }
  catch (const std::invalid_argument& error)
  {
    for (vtkTable* table : tables)
    {
      table->Initialize();
    }
    vtkErrorMacro(<< error.what());
    return 0;
  }
  return 1;
}

void vtkPatternMetrics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Wavelength: " << this->Wavelength << "\n";
  os << indent << "MinimumFacing: " << this->MinimumFacing << "\n";
  os << indent << "Smoothing: " << this->Smoothing << "\n";
  os << indent << "FlatnessWindow: " << this->FlatnessWindow << "\n";
  os << indent << "MinimumCellPixels: " << this->MinimumCellPixels << "\n";
  os << indent << "StippleWindow: " << this->StippleWindow[0] << " to " << this->StippleWindow[1]
     << ", " << this->StippleWindow[2] << " to " << this->StippleWindow[3] << "\n";
  os << indent << "PeriodicStipples: " << (this->PeriodicStipples ? "on" : "off") << "\n";
}
