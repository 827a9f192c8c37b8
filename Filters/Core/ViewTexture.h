// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_ViewTexture_h
#define hachure_ViewTexture_h

#include "SurfaceCells.h"
#include "SurfaceFrames.h"
#include "SurfaceSampling.h"
#include "TextureView.h"
#include "TriangleMesh.h"
#include "ViewTextureColors.h"

#include <memory>
#include <vector>

namespace hachure
{

struct ViewTextureOptions
{
  int hemisphere = 8; // directions a side: 4, 8 or 16
  HemisphereMap map = HemisphereMap::Octahedral;
  // Levels finer than any view take the colours of the next coarser one; else nothing is known
  // there, as in the paper.
  bool propagateUp = true;
  // Shares of what is seen from some directions include the views' shares of depth, as in the
  // paper: at a depth between two levels a view is then mixed with what is seen from everywhere,
  // even as seen by its own camera. Views also count alike however obliquely they see the surface,
  // and end at an edge; else they count by the square of the cosine.
  bool classicShares = false;
};

enum class ViewTextureContent
{
  Combined,
  DependentOnly,   // nothing is known of what is seen from everywhere
  IndependentOnly, // nothing is seen from some directions
  Coverage         // every view has a colour of its own, coverageColor(), where its mask leaves it
};

// The fixed colour of a view among all.
glm::u8vec4 coverageColor(std::size_t view);

// Blends images of a surface to one texture that depends on the view (Grimm and Kowalski 2002). It
// keeps what it can from one call to the next: which pixels show which cells as long as cameras
// stay, and what is seen from everywhere or from some directions as long as views of that kind do.
class ViewTexture
{
public:
  // Copies everything. Throws std::invalid_argument for a wrong mesh, cells or frames of another
  // one, and wrong options.
  ViewTexture(const TriangleMesh& mesh, const SurfaceCells& cells, const SurfaceFrames& frames,
    const ViewTextureOptions& options = {});
  ~ViewTexture();
  ViewTexture(ViewTexture&&) noexcept;
  ViewTexture& operator=(ViewTexture&&) noexcept;

  // In any number. A view keeps the image of the one with its number before if that is as large.
  // Throws std::invalid_argument for the first wrong one, see checkTextureView(), and then keeps
  // what was there.
  void setViews(const std::vector<TextureView>& views);
  std::size_t viewCount() const;
  // Copies the pixels. A view without an image sees nothing. Throws std::invalid_argument for a
  // number that is no view's and an image that is not as large as its view.
  void setImage(std::size_t view, const TextureImage& image);

  // Brought up to date; valid until the next call. Without nodes if the progress function stopped
  // the work, which the next call takes up again.
  const ViewTextureColors& colors(
    ViewTextureContent content = ViewTextureContent::Combined, const ProgressFn& progress = {});

  // The level, between two, at which cells are as large as the view's pixels: see ViewCoverage.
  double depthOf(std::size_t view);
  // For every view and every node: the view's share of what is known there, 0 to 1, whatever the
  // direction, by masks and shares of depth. The shares of all views sum to 1, or to 0 where
  // nothing is known. Without views if the progress function stopped the work.
  std::vector<std::vector<float>> nodeShares(const ProgressFn& progress = {});

private:
  class State;
  std::unique_ptr<State> state;
};

} // namespace hachure

#endif
