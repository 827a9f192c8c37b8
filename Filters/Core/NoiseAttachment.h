// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseAttachment_h
#define hachure_NoiseAttachment_h

#include "NoiseSurface.h"

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

// Kernels of a noise whose surface is replaced by others with other triangles, frame by frame: an
// isosurface whose value changes, time steps with other cells. They neither pop nor slide.
//
// The points of a surface are a Poisson process on surface and densities (NoiseSurface.h). Two
// operations keep it one: points are left out independently of each other, and independent
// processes are put together. At a change
// - every point that was in use goes to the closest point of the new surface, with its id, and so
//   its phase and direction, and with its birth density, divided by the growth of the surface
//   there;
// - points live for `life` changes. One of `life` equal shares, told by a hash of the id, begins to
//   fade out, over half a life: the cosine of a quarter of a turn. Of the new surface's own points,
//   the same share fades in: the sine. The squares sum up to 1, so that the field keeps its
//   deviation, and the number of kernels grows by half at most;
// - other points of the new surface are left out where the carried ones cover it, and count in full
//   where they do not: where the way to the closest point of the old surface and back ends more
//   than half a kernel away, where the old one is farther than the reach, and where it was not
//   seen, or not as closely;
// - points whose way back ends elsewhere fade out; those that would jump by more than a kernel go
//   at once, with the surface that they were on;
// - points that both surfaces have, by the ids of triangles or by equal triangles, stay as they
// are.
//
// Between changes nothing fades: the same surface and view have the same kernels. Frames depend on
// those before by the view of the last frame on the old surface alone.
namespace hachure
{

class NoiseAttachment
{
public:
  // Changes that a point lives for, 1 or more; 0: every surface has its own points at once.
  explicit NoiseAttachment(int changes = 16);

  // The kernels of a view. Another surface than in the last call replaces that. It is kept, and
  // must stay as it is, with its positions, until the call after the next change: a pointer that
  // owns those as well will do. hidden: may leave out kernels that nothing is seen of; the next
  // change does not depend on it. Throws as NoiseSurface::kernels does.
  void kernels(const std::shared_ptr<NoiseSurface>& next, const NoiseView& view,
    const NoiseKernelOptions& options, std::vector<NoiseKernel>& result,
    const NoiseOcclusion* hidden = nullptr);

  // Forgets what was before: the next surface has its own points at once.
  void reset();
  // Forgets, where it is another life. Throws std::invalid_argument for less than 0.
  void setLife(int changes);

  // Points that came from surfaces before, those that fade out included.
  std::size_t carriedCount() const { return this->carried.size(); }

private:
  // When a point fades in and out, by numbers of changes.
  struct Term
  {
    std::int64_t arrival;
    std::int64_t leave;
  };
  struct Carried
  {
    std::int32_t facet; // in the order of the tree
    glm::dvec2 weights;
    glm::dvec2 direction; // in edges of the triangle, of any length: what turning is told from
    double birth;
    std::uint64_t id;
    Term term;
  };
  class Change;

  double weight(const Term& term) const;
  void weigh(std::vector<NoiseKernel>& kernels) const;
  void addCarried(const NoiseView& view, const NoiseKernelOptions& options,
    std::vector<NoiseKernel>& result) const;
  void replace(const std::shared_ptr<NoiseSurface>& next, const NoiseKernelOptions& options);

  int life;
  std::int64_t change = 0;
  std::shared_ptr<NoiseSurface> surface;
  // Of the last call; a control does not outlive it, so the points that it chose are kept.
  NoiseView lastView;
  NoiseKernelOptions lastOptions;
  bool lastControlled = false;
  std::vector<NoisePoint> lastPoints;
  std::vector<Carried> carried;
  std::unordered_map<std::uint64_t, Term> own; // of the surface's points that do not count in full
};

} // namespace hachure

#endif
