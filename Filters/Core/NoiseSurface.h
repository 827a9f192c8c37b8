// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_NoiseSurface_h
#define hachure_NoiseSurface_h

#include "NoiseKernels.h"
#include "SampleProjection.h"
#include "TriangleMesh.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

// Points on a surface for the kernels of a noise, as many as the picture needs, whatever the
// triangles (Benard et al. 2010, section 3.3, with a density that does not follow the mesh).
//
// The points are a Poisson process on the surface times an axis of densities: every point has a
// birth density q, and where the picture asks for D points per unit of the surface's area, those
// with q < D are drawn. So the sets for all densities are nested, a point fades in slowly while the
// picture zooms in on it, and it stays the same point on a surface that deforms.
//
// Levels are octaves of q. Which points a level has on a triangle is a function of seed, triangle
// id, the triangle's area in the reference mesh, and the level alone: neither of other triangles
// nor of the order of frames, of threads, or of what was seen before.
namespace hachure
{

struct NoiseSurfaceTree;

struct NoisePoint
{
  std::int32_t triangle = 0;
  glm::dvec2 weights{ 0.0 }; // barycentric, of the second and third corner
  double birth = 0.0;        // q, points per unit of reference area
  std::uint64_t id = 0;      // random bits of this point: a hash of (seed, triangle id, level, ...)
};

struct NoiseView
{
  glm::dmat4 modelToClip{ 1.0 };    // OpenGL's convention
  glm::dvec2 viewportOrigin{ 0.0 }; // pixels of the framebuffer
  glm::dvec2 viewportSize{ 1.0, 1.0 };
};

struct NoiseKernelOptions
{
  // Mean number of kernels that overlap in a pixel (N'), 1 or more, as their squared weights count:
  // kernels that fade in count less.
  double overlap = 32.0;
  double radius = 16.0;     // of kernels, pixels; > 0
  double frequency = 0.125; // F0, cycles per pixel
  // Direction of the wave vector, radians; and how far it is spread at random to both sides, 0 to
  // pi / 2: 0 anisotropic, pi / 2 isotropic.
  double orientation = 0.0;
  double spread = 0.0;
  // From the lines of a control's direction to the orientation: those of waves lie across the wave
  // vector, those of a spot along its x axis (0).
  double lineAngle = 0.5 * 3.14159265358979323846;
  // Whether directions turn with the surface around the line of sight, so that kernels keep their
  // look while it rolls. For a spread of pi / 2, where no direction is special, that alone differs.
  bool turning = false;
  // Octaves of density over which a point fades in, > 0.
  double fade = 1.0;
  // Only phases 0 and pi: kernels of random sign. Otherwise all phases.
  bool signs = false;
  // A point's own parameters, empty: all have the above. Called from several threads.
  struct Control
  {
    double frequency = 1.0;      // factor of it; above 0
    double bandwidth = 1.0;      // factor of it; above 0, below 1 makes kernels larger
    glm::dvec3 direction{ 0.0 }; // model space: of the lines; 0: as above
  };
  std::function<Control(const NoisePoint&)> control;
  // Factors of the bandwidth are clamped to this range, lowest and highest, which must hold 1:
  // larger kernels reach into the viewport from farther away, and smaller ones need more points.
  // Without a control it does not matter.
  glm::dvec2 bandwidthRange{ 0.5, 2.0 };
};

class NoiseOcclusion;

class NoiseSurface
{
public:
  // ids: per triangle, the same for the same triangle in every time step and on every rank; empty:
  // a hash of the corners' positions in the reference mesh. objects: block of each triangle; empty:
  // all 0. The mesh is the reference: areas are measured on it, or are those given, where triangles
  // were known before by their ids. Triangles without area have no points. Its points must outlive
  // the calls up to that of setPositions; all else is copied. Throws std::invalid_argument as
  // checkTriangleMesh does, for arrays of other lengths, and for areas that are not finite and 0 or
  // more.
  NoiseSurface(const TriangleMesh& reference, Span<const std::uint64_t> ids = {},
    Span<const std::int32_t> objects = {}, std::uint32_t seed = 1, Span<const double> areas = {});
  ~NoiseSurface();
  NoiseSurface(NoiseSurface&&) noexcept;
  NoiseSurface& operator=(NoiseSurface&&) noexcept;

  // Where the surface is now: the same triangles at other points, which must outlive the next
  // calls. Throws for another number of points and for corners that are not finite, and then the
  // surface stays where it was.
  void setPositions(Span<const glm::dvec3> positions);

  // The points of birth density below `density` on all of the surface, in an order that depends on
  // the mesh alone. Throws for a density below 0 or one that asks for more than 2^30 points.
  std::vector<NoisePoint> points(double density) const;

  // The kernels of a view, those whose disc meets the viewport, back faces included; what lies
  // behind the near plane is left out. Cost follows the number of kernels. Their order depends on
  // the mesh alone. Points of levels that were not met before are made here, and kept. Throws for a
  // view or options out of their ranges.
  std::vector<NoiseKernel> kernels(const NoiseView& view, const NoiseKernelOptions& options);
  // The same into the memory of a frame before; `points`: the point of each kernel, if wanted;
  // hidden: leaves out kernels that nothing is seen of.
  void kernels(const NoiseView& view, const NoiseKernelOptions& options,
    std::vector<NoiseKernel>& result, std::vector<NoisePoint>* points = nullptr,
    const NoiseOcclusion* hidden = nullptr);

  // Bytes that are held.
  std::size_t memory() const;

  // Bytes that points may take which kernels() made; those that were not met for longest are
  // dropped, and made again, equal, when they are. Default 256 MiB.
  void setMemoryBudget(std::size_t bytes);

  // For NoiseAttachment: the triangles, where they are, and their blocks (empty: all 0).
  const NoiseSurfaceTree& tree() const;
  Span<const glm::dvec3> positions() const;
  Span<const std::int32_t> objects() const;

private:
  struct Data;
  std::unique_ptr<Data> data;
};

// Weight of a point of birth density q where the picture asks for density D, `fade` octaves of D
// after it appeared: 0 for D <= q, 1 from D = q 2^fade on.
double noiseFadeWeight(double density, double birth, double fade);

// Mean of the squared weights of all points up to D: the share of points that count.
double noiseFadeShare(double fade);

// The kernels of the paper, for comparison (equations 2 to 4): on every triangle 2M points,
// M = 2^floor(log2 N) for N expected points on its image, the second half of weight
// alpha = sqrt(N / M - 1); one point of weight N where N < 1. At most 2^16 points on a triangle.
// Cost follows the number of triangles. Of the control, the bandwidth does not change the number of
// points. Of `points`, one for each kernel if wanted, the birth is the N at which the point
// appears.
std::vector<NoiseKernel> classicNoiseKernels(const TriangleMesh& mesh,
  Span<const std::uint64_t> ids, Span<const std::int32_t> objects, std::uint32_t seed,
  const NoiseView& view, const NoiseKernelOptions& options,
  std::vector<NoisePoint>* points = nullptr);

} // namespace hachure

#endif
