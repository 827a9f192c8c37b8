// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewTextureState_h
#define hachure_ViewTextureState_h

#include "HemisphereTable.h"
#include "ViewCellColors.h"
#include "ViewCoverage.h"
#include "ViewTexture.h"
#include "ViewTextureSurface.h"

#include <vector>

namespace hachure
{

// What a ViewTexture keeps from one call to the next.
class ViewTexture::State
{
public:
  State(const TriangleMesh& mesh, const SurfaceCells& cells, const SurfaceFrames& frames,
    const ViewTextureOptions& ofOptions)
    : options(ofOptions)
    , surface(mesh, cells, frames)
    , table(ofOptions.map, ofOptions.hemisphere)
  {
    this->result.hemisphere = this->stopped.hemisphere = ofOptions.hemisphere;
    this->result.map = this->stopped.map = ofOptions.map;
  }

  struct Entry
  {
    TextureView view;
    std::vector<glm::u8vec4> image; // none: nothing is seen
    bool hasCoverage = false, hasColors = false;
    ViewCoverage coverage;
    ViewCellColors colors;
  };

  void setViews(const std::vector<TextureView>& views);
  void setImage(std::size_t view, const TextureImage& image);
  bool updateViews(const ProgressFn& progress);
  bool updateBase(const ProgressFn& progress);
  bool updateHemispheres(const ProgressFn& progress);
  const ViewTextureColors& colors(ViewTextureContent content, const ProgressFn& progress);
  std::vector<std::vector<float>> nodeShares(const ProgressFn& progress);
  void cover(Entry& entry);
  Entry& entryAt(std::size_t view);
  void assemble(ViewTextureContent content);
  void forget(const Entry& entry);

  ViewTextureOptions options;
  ViewTextureSurface surface;
  HemisphereTable table;
  std::vector<Entry> entries;
  bool inCoverageColors = false;
  bool hasBase = false, hasHemispheres = false;
  bool isAssembled = false;
  ViewTextureContent assembled = ViewTextureContent::Combined;
  std::vector<glm::u8vec4> base, hemispheres; // empty while `result` has them
  ViewTextureColors result, stopped;
};

} // namespace hachure

#endif
