// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternToneChannels.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPatternBlocks.h"
#include "vtkPatternLayer.h"
#include "vtkPatternStyle.h"
#include "vtkPatternTone.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
bool FollowsLights(const vtkPatternToneChannel& channel)
{
  return channel.Source == vtkPatternTone::LIGHT || channel.Source == vtkPatternTone::HIGHLIGHT;
}

bool NeedsChannel(vtkPatternTone* tone)
{
  return tone->GetSource() != vtkPatternTone::CONSTANT && !tone->IsSeparation();
}

vtkPatternToneChannel Describe(vtkPatternTone* tone)
{
  vtkPatternToneChannel channel;
  channel.Source = tone->GetSource();
  if (channel.Source == vtkPatternTone::ARRAY)
  {
    channel.ArrayName = tone->GetArrayName() ? tone->GetArrayName() : "";
    channel.Association = tone->GetArrayAssociation();
    channel.Component = tone->GetComponent();
    channel.Range = { tone->GetRange()[0], tone->GetRange()[1] };
  }
  if (FollowsLights(channel))
  {
    channel.LightIndex = tone->GetLightIndex();
  }
  if (channel.Source == vtkPatternTone::HIGHLIGHT)
  {
    channel.HighlightPower = tone->GetHighlightPower();
  }
  return channel;
}

vtkAbstractArray* FindArray(vtkPolyData* block, const std::string& name, bool onCells)
{
  vtkDataSetAttributes* data = onCells ? static_cast<vtkDataSetAttributes*>(block->GetCellData())
                                       : static_cast<vtkDataSetAttributes*>(block->GetPointData());
  return data->GetAbstractArray(name.c_str());
}

bool FoundAnywhere(
  const std::vector<vtkPattern::Block>& blocks, const std::string& name, bool onCells)
{
  return std::any_of(blocks.begin(), blocks.end(),
    [&](const vtkPattern::Block& block)
    { return FindArray(block.Data, name, onCells) != nullptr; });
}

// What is wrong with a block's array, empty where nothing is.
std::string Complaint(const vtkPatternToneChannel& channel, vtkAbstractArray* found)
{
  std::ostringstream text;
  auto* array = vtkDataArray::SafeDownCast(found);
  if (!array)
  {
    text << "tone array '" << channel.ArrayName << "' is a " << found->GetClassName()
         << "; expected numbers";
  }
  else if (channel.Component >= array->GetNumberOfComponents())
  {
    text << "tone array '" << channel.ArrayName << "' has " << array->GetNumberOfComponents()
         << " components; component " << channel.Component << " was asked for";
  }
  return text.str();
}

std::string Resolve(vtkPatternToneChannel& channel, const std::vector<vtkPattern::Block>& blocks)
{
  std::ostringstream text;
  if (!(std::isfinite(channel.Range[0]) && std::isfinite(channel.Range[1])) ||
    channel.Range[0] == channel.Range[1])
  {
    text << "tone range of array '" << channel.ArrayName << "' is [" << channel.Range[0] << ", "
         << channel.Range[1] << "]; expected two different finite numbers";
    return text.str();
  }
  const bool points =
    channel.Association != vtkPatternTone::CELLS && FoundAnywhere(blocks, channel.ArrayName, false);
  channel.OnCells = !points && channel.Association != vtkPatternTone::POINTS &&
    FoundAnywhere(blocks, channel.ArrayName, true);
  if (!points && !channel.OnCells)
  {
    static const char* const places[] = { "point or cell", "point", "cell" };
    text << "no " << places[channel.Association] << " array '" << channel.ArrayName
         << "' to take the tone from; the surface is drawn as one without data";
    return blocks.empty() ? std::string() : text.str();
  }
  for (const vtkPattern::Block& block : blocks)
  {
    vtkAbstractArray* array = FindArray(block.Data, channel.ArrayName, channel.OnCells);
    std::string complaint = array ? Complaint(channel, array) : std::string();
    if (!complaint.empty())
    {
      return complaint;
    }
  }
  return {};
}
} // namespace

bool vtkPatternToneChannel::operator==(const vtkPatternToneChannel& other) const
{
  return this->Source == other.Source && this->ArrayName == other.ArrayName &&
    this->Association == other.Association && this->Component == other.Component &&
    this->Range == other.Range && this->OnCells == other.OnCells &&
    this->LightIndex == other.LightIndex && this->HighlightPower == other.HighlightPower;
}

std::string vtkPatternToneChannels::StandIn(vtkPatternTone* tone)
{
  const vtkPatternToneChannel channel = Describe(tone);
  std::ostringstream name;
  name << "source " << channel.Source;
  if (channel.Source == vtkPatternTone::ARRAY)
  {
    name << ", component " << channel.Component << " of " << channel.ArrayName;
  }
  return name.str();
}

vtkPatternToneChannel vtkPatternToneChannels::ChannelOf(vtkPatternTone* tone) const
{
  vtkPatternToneChannel channel = Describe(tone);
  if (this->StandIns)
  {
    vtkPatternToneChannel standIn;
    standIn.Source = vtkPatternTone::ARRAY;
    standIn.ArrayName = StandIn(tone);
    standIn.Association = vtkPatternTone::POINTS;
    standIn.Range = channel.Range;
    return standIn;
  }
  return channel;
}

void vtkPatternToneChannels::Collect(
  vtkPatternStyle* style, vtkDataObject* input, std::string& error)
{
  this->Channels.clear();
  const std::vector<vtkPattern::Block> blocks = vtkPattern::Blocks(input);
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    vtkPatternLayer* layer = style->GetLayer(i);
    if (!layer->GetEnabled() || !NeedsChannel(layer->GetTone()) ||
      this->Find(layer->GetTone()) >= 0)
    {
      continue;
    }
    vtkPatternToneChannel channel = this->ChannelOf(layer->GetTone());
    if (this->Channels.size() == Maximum)
    {
      error =
        "a style may use 4 different tones besides constants and separations; the one of layer " +
        std::to_string(i) + " is one too many";
      return;
    }
    if (channel.Source == vtkPatternTone::ARRAY && error.empty())
    {
      error = Resolve(channel, blocks);
    }
    else if (channel.Source == vtkPatternTone::ARRAY)
    {
      Resolve(channel, blocks);
    }
    this->Channels.push_back(channel);
  }
}

bool vtkPatternToneChannels::UseLights() const
{
  return std::any_of(this->Channels.begin(), this->Channels.end(), FollowsLights);
}

std::string vtkPatternToneChannels::MissingLight(int lights) const
{
  for (const vtkPatternToneChannel& channel : this->Channels)
  {
    if (channel.LightIndex >= lights)
    {
      return "tone from light " + std::to_string(channel.LightIndex) + ": the renderer has " +
        std::to_string(lights) + " lights, counted from 0; the surface is drawn without this light";
    }
  }
  return {};
}

int vtkPatternToneChannels::Find(vtkPatternTone* tone) const
{
  if (!NeedsChannel(tone))
  {
    return -1;
  }
  vtkPatternToneChannel wanted = this->ChannelOf(tone);
  for (std::size_t i = 0; i < this->Channels.size(); ++i)
  {
    wanted.OnCells = this->Channels[i].OnCells; // found, not asked for
    if (wanted == this->Channels[i])
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

std::vector<float> vtkPatternToneChannels::Values(
  const vtkPatternToneChannel& channel, vtkPolyData* block)
{
  const vtkIdType count = channel.OnCells ? block->GetNumberOfCells() : block->GetNumberOfPoints();
  std::vector<float> values(2 * static_cast<std::size_t>(count), 0.0f);
  auto* array = vtkDataArray::SafeDownCast(FindArray(block, channel.ArrayName, channel.OnCells));
  const double extent = channel.Range[1] - channel.Range[0];
  if (!array || array->GetNumberOfTuples() < count ||
    channel.Component >= array->GetNumberOfComponents() || extent == 0.0)
  {
    return values;
  }
  const int components = array->GetNumberOfComponents();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double value = 0.0;
    if (channel.Component >= 0)
    {
      value = array->GetComponent(i, channel.Component);
    }
    else
    {
      for (int c = 0; c < components; ++c)
      {
        value = std::hypot(value, array->GetComponent(i, c));
      }
    }
    if (std::isfinite(value))
    {
      // Far outside the range all tones are alike; floats stay small enough to interpolate well.
      constexpr double bound = 1e6;
      const auto index = 2 * static_cast<std::size_t>(i);
      values[index] =
        static_cast<float>(std::clamp((value - channel.Range[0]) / extent, -bound, bound));
      values[index + 1] = 1.0f;
    }
  }
  return values;
}
