// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The tones that the attribute stage has to produce for a style: each distinct source once.
 */
#ifndef vtkPatternToneChannels_h
#define vtkPatternToneChannels_h

#include <array>
#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkPatternStyle;
class vtkPatternTone;
class vtkPolyData;

struct vtkPatternToneChannel
{
  int Source = 0; // vtkPatternTone::SourceType, neither CONSTANT nor a separation
  std::string ArrayName;
  int Association = 0;
  int Component = 0;
  std::array<double, 2> Range = { 0.0, 1.0 };
  bool OnCells = false; // found among the cells' arrays
  int LightIndex = -1;
  double HighlightPower = 0.0;

  bool operator==(const vtkPatternToneChannel& other) const;
};

class vtkPatternToneChannels
{
public:
  /// Channels that fit the attribute image.
  static constexpr std::size_t Maximum = 4;

  /// On a legend every tone has an array of points, StandIn() of it, for light that is not there.
  void SetStandIns(bool standIns) { this->StandIns = standIns; }
  /// What an array stands in for a tone: sources that are equal everywhere have the same one. An
  /// array of the surface has tuples of one component here, any other holds tones.
  static std::string StandIn(vtkPatternTone* tone);

  /// Channels of the style's enabled layers. Where an array is missing, not numeric, has too few
  /// components or an empty range, `error` says so and the channel keeps its place without data.
  void Collect(vtkPatternStyle* style, vtkDataObject* input, std::string& error);

  const std::vector<vtkPatternToneChannel>& Get() const { return this->Channels; }
  bool UseLights() const;
  /// What is wrong where the scene has this number of lights, empty where nothing is.
  std::string MissingLight(int lights) const;
  /// Channel of a tone, or -1 for one that needs none.
  int Find(vtkPatternTone* tone) const;
  bool operator==(const vtkPatternToneChannels& other) const
  {
    return this->Channels == other.Channels;
  }

  /// (tone before clamping, 1) per tuple of a block's array, (0, 0) where it has no number.
  static std::vector<float> Values(const vtkPatternToneChannel& channel, vtkPolyData* block);

private:
  vtkPatternToneChannel ChannelOf(vtkPatternTone* tone) const;

  std::vector<vtkPatternToneChannel> Channels;
  bool StandIns = false;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternToneChannels.h
