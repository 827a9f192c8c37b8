// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_Similarity_h
#define hachure_Similarity_h

#include "Span.h"

#include <glm/vec2.hpp>

#include <cstdint>

// The 2D similarity transform (translation, rotation, uniform scale) that best maps weighted points
// p of the previous frame to the points c of the current one: Breslav et al. 2007, section 3.2,
// after Horn 1987. Points and vectors of the image are read as complex numbers x + iy, y up.
namespace hachure
{

// q -> to + z (q - from): the previous centroid goes to the current centroid.
struct Similarity
{
  glm::dvec2 z{ 1.0, 0.0 };
  glm::dvec2 from{ 0.0 };
  glm::dvec2 to{ 0.0 };

  glm::dvec2 apply(glm::dvec2 point) const;
  double scale() const;
  // Counter-clockwise, in (-180, 180].
  double angleDegrees() const;
  // z must not be 0.
  Similarity inverse() const;
};

enum class FitStatus : std::uint8_t
{
  Similarity,      // rotation, scale and translation are known
  TranslationOnly, // all points fall together: rotation and scale are kept
  NoSamples        // no weight at all: the identity
};

const char* fitStatusName(FitStatus status);

// All that the fit needs to know of the points. Moments of disjoint sets of points add up to the
// moments of the union, as long as all of them are taken about the same pair of origins; origins
// near the points keep the digits of small patches far from the corner of the image.
struct SimilarityMoments
{
  glm::dvec2 previousOrigin{ 0.0 };
  glm::dvec2 currentOrigin{ 0.0 };
  double weight = 0.0;
  glm::dvec2 previous{ 0.0 };   // sum w p
  glm::dvec2 current{ 0.0 };    // sum w c
  double dot = 0.0;             // sum w p . c
  double cross = 0.0;           // sum w p x c
  double previousSquared = 0.0; // sum w |p|^2
  double currentSquared = 0.0;  // sum w |c|^2

  void add(double w, glm::dvec2 p, glm::dvec2 c)
  {
    p -= this->previousOrigin;
    c -= this->currentOrigin;
    const double px = w * p.x;
    const double py = w * p.y;
    const double cx = w * c.x;
    const double cy = w * c.y;
    this->weight += w;
    this->previous.x += px;
    this->previous.y += py;
    this->current.x += cx;
    this->current.y += cy;
    this->dot += px * c.x + py * c.y;
    this->cross += px * c.y - py * c.x;
    this->previousSquared += px * p.x + py * p.y;
    this->currentSquared += cx * c.x + cy * c.y;
  }
  // Throws std::invalid_argument where the origins differ.
  SimilarityMoments& operator+=(const SimilarityMoments& other);
};

struct SimilarityFit
{
  Similarity transform;
  double weight = 0.0;
  // sqrt(sum w |z p - c|^2 / sum w) in pixels, p and c about their centroids; from the moments.
  double rmsResidual = 0.0;
  // sum w |z p - c| / sum w in pixels: how far the pattern slides in this step. It needs the
  // points; 0 in a fit from moments alone.
  double residual = 0.0;
  // |sum w conj(p) c| / sqrt(sum w |p|^2 sum w |c|^2), in [0, 1]: 1 for a similarity, 0 for a
  // mirror image. 1 where no rotation is fitted.
  double correlation = 1.0;
  FitStatus status = FitStatus::NoSamples;
};

// The fit with Horn's symmetric scale: exchanging the two frames gives the inverse transform.
// Throws std::invalid_argument on moments that are not finite or a negative weight.
SimilarityFit fitSimilarity(const SimilarityMoments& moments);

// The same from points, with the residual. Throws std::invalid_argument on different sizes, on
// positions or weights that are not finite and on negative weights. Points of weight 0 are not
// read.
SimilarityFit fitSimilarity(
  Span<const glm::dvec2> previous, Span<const glm::dvec2> current, Span<const double> weights);

// |z p - c| of one point, p and c about the centroids of the fit.
double residualLength(const Similarity& transform, glm::dvec2 previous, glm::dvec2 current);

// Where a pattern lies in the image: `origin` is the point of pattern coordinates (0, 0), u and v
// are the image vectors of (1, 0) and (0, 1); logical pixels, y up (Breslav et al. 2007,
// section 3.3).
struct PatternFrame
{
  glm::dvec2 origin{ 0.0, 0.0 };
  glm::dvec2 u{ 1.0, 0.0 };
  glm::dvec2 v{ 0.0, 1.0 };
};

bool operator==(const PatternFrame& a, const PatternFrame& b);
bool operator!=(const PatternFrame& a, const PatternFrame& b);

// The frame after the image has moved by the transform.
PatternFrame advance(const PatternFrame& frame, const Similarity& step);

glm::dvec2 complexProduct(glm::dvec2 a, glm::dvec2 b);

} // namespace hachure

#endif
