// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Similarity.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hachure
{

namespace
{

// Root mean square distance from the centroid, in pixels, below which points count as one point.
constexpr double onePointRadius = 1e-6;
// Correlations under this are rounding errors: the angle would be arbitrary.
constexpr double noCorrelation = 1e-12;

bool isFinite(glm::dvec2 value)
{
  return std::isfinite(value.x) && std::isfinite(value.y);
}

void check(const SimilarityMoments& m)
{
  const double sum = m.weight + m.previous.x + m.previous.y + m.current.x + m.current.y + m.dot +
    m.cross + m.previousSquared + m.currentSquared;
  if (!std::isfinite(sum))
  {
    throw std::invalid_argument("fitSimilarity: moments: a sum is not finite");
  }
  if (m.weight < 0.0)
  {
    throw std::invalid_argument(
      "fitSimilarity: moments.weight is " + std::to_string(m.weight) + ", expected 0 or more");
  }
}

void checkPoint(std::size_t i, glm::dvec2 previous, glm::dvec2 current, double weight)
{
  if (!std::isfinite(weight) || weight < 0.0)
  {
    throw std::invalid_argument("fitSimilarity: weights[" + std::to_string(i) + "] is " +
      std::to_string(weight) + ", expected a finite number of 0 or more");
  }
  if (weight > 0.0 && !(isFinite(previous) && isFinite(current)))
  {
    throw std::invalid_argument(
      "fitSimilarity: " + std::string(isFinite(previous) ? "current[" : "previous[") +
      std::to_string(i) + "] is not finite");
  }
}

} // namespace

glm::dvec2 complexProduct(glm::dvec2 a, glm::dvec2 b)
{
  return { a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x };
}

glm::dvec2 Similarity::apply(glm::dvec2 point) const
{
  return this->to + complexProduct(this->z, point - this->from);
}

double Similarity::scale() const
{
  return std::hypot(this->z.x, this->z.y);
}

double Similarity::angleDegrees() const
{
  constexpr double degreesPerRadian = 57.295779513082320877;
  return std::atan2(this->z.y, this->z.x) * degreesPerRadian;
}

Similarity Similarity::inverse() const
{
  const double squared = glm::dot(this->z, this->z);
  if (!(squared > 0.0))
  {
    throw std::invalid_argument("Similarity::inverse: z is 0 or not a number");
  }
  return { glm::dvec2(this->z.x, -this->z.y) / squared, this->to, this->from };
}

const char* fitStatusName(FitStatus status)
{
  switch (status)
  {
    case FitStatus::Similarity:
      return "Similarity";
    case FitStatus::TranslationOnly:
      return "TranslationOnly";
    case FitStatus::NoSamples:
      break;
  }
  return "NoSamples";
}

SimilarityMoments& SimilarityMoments::operator+=(const SimilarityMoments& other)
{
  if (this->previousOrigin != other.previousOrigin || this->currentOrigin != other.currentOrigin)
  {
    throw std::invalid_argument(
      "SimilarityMoments: other has different origins, expected sums about the same points");
  }
  this->weight += other.weight;
  this->previous += other.previous;
  this->current += other.current;
  this->dot += other.dot;
  this->cross += other.cross;
  this->previousSquared += other.previousSquared;
  this->currentSquared += other.currentSquared;
  return *this;
}

SimilarityFit fitSimilarity(const SimilarityMoments& m)
{
  check(m);
  SimilarityFit fit;
  if (!(m.weight > 0.0))
  {
    return fit;
  }
  const glm::dvec2 p = m.previous / m.weight;
  const glm::dvec2 c = m.current / m.weight;
  fit.weight = m.weight;
  fit.transform.from = m.previousOrigin + p;
  fit.transform.to = m.currentOrigin + c;
  // Sums about the centroids.
  const double dot = m.dot - m.weight * glm::dot(p, c);
  const double cross = m.cross - m.weight * (p.x * c.y - p.y * c.x);
  const double previous = std::max(0.0, m.previousSquared - m.weight * glm::dot(p, p));
  const double current = std::max(0.0, m.currentSquared - m.weight * glm::dot(c, c));

  const double onePoint = m.weight * onePointRadius * onePointRadius;
  if (previous <= onePoint || current <= onePoint)
  {
    fit.status = FitStatus::TranslationOnly;
    fit.rmsResidual = std::sqrt(std::max(0.0, previous + current - 2.0 * dot) / m.weight);
    return fit;
  }
  fit.status = FitStatus::Similarity;
  const double length = std::hypot(dot, cross);
  const double scale = std::sqrt(current / previous);
  fit.correlation = std::min(1.0, length / std::sqrt(previous * current));
  // Angle of the least-squares z of section 3.2, times Horn's symmetric scale.
  fit.transform.z = fit.correlation > noCorrelation ? glm::dvec2(dot, cross) * (scale / length)
                                                    : glm::dvec2(scale, 0.0);
  const double error = scale * scale * previous + current -
    2.0 * (fit.transform.z.x * dot + fit.transform.z.y * cross);
  fit.rmsResidual = std::sqrt(std::max(0.0, error) / m.weight);
  return fit;
}

SimilarityFit fitSimilarity(
  Span<const glm::dvec2> previous, Span<const glm::dvec2> current, Span<const double> weights)
{
  if (previous.size() != current.size() || previous.size() != weights.size())
  {
    throw std::invalid_argument("fitSimilarity: previous, current and weights have " +
      std::to_string(previous.size()) + ", " + std::to_string(current.size()) + " and " +
      std::to_string(weights.size()) + " elements, expected equal numbers");
  }
  SimilarityMoments moments;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    checkPoint(i, previous[i], current[i], weights[i]);
    if (weights[i] > 0.0)
    {
      if (moments.weight == 0.0)
      {
        moments.previousOrigin = previous[i];
        moments.currentOrigin = current[i];
      }
      moments.add(weights[i], previous[i], current[i]);
    }
  }
  SimilarityFit fit = fitSimilarity(moments);
  for (std::size_t i = 0; fit.weight > 0.0 && i < weights.size(); ++i)
  {
    if (weights[i] > 0.0)
    {
      fit.residual +=
        weights[i] / fit.weight * residualLength(fit.transform, previous[i], current[i]);
    }
  }
  return fit;
}

double residualLength(const Similarity& transform, glm::dvec2 previous, glm::dvec2 current)
{
  const glm::dvec2 difference = transform.apply(previous) - current;
  return std::sqrt(glm::dot(difference, difference));
}

bool operator==(const PatternFrame& a, const PatternFrame& b)
{
  return a.origin == b.origin && a.u == b.u && a.v == b.v;
}

bool operator!=(const PatternFrame& a, const PatternFrame& b)
{
  return !(a == b);
}

PatternFrame advance(const PatternFrame& frame, const Similarity& step)
{
  return { step.apply(frame.origin), complexProduct(step.z, frame.u),
    complexProduct(step.z, frame.v) };
}

} // namespace hachure
