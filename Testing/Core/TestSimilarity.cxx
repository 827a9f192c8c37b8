// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "Core/Random.h"
#include "Core/Similarity.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

using namespace hachure;

struct Cloud
{
  std::vector<glm::dvec2> previous;
  std::vector<glm::dvec2> current;
  std::vector<double> weights;
};

// 500 points in an image of 1000 x 800 pixels, moved by the transform and then by `noise` pixels.
Cloud makeCloud(const Similarity& transform, double noise)
{
  Cloud cloud;
  const auto random = [](std::uint64_t id, std::uint32_t dimension)
  { return unitRandom(1, id, dimension); };
  for (std::uint64_t i = 0; i < 500; ++i)
  {
    const glm::dvec2 p(1000.0 * random(i, 0), 800.0 * random(i, 1));
    const glm::dvec2 error(random(i, 2) - 0.5, random(i, 3) - 0.5);
    cloud.previous.push_back(p);
    cloud.current.push_back(transform.apply(p) + noise * error);
    cloud.weights.push_back(0.1 + random(i, 4));
  }
  return cloud;
}

const Similarity known{ { 1.3 * std::cos(0.7), 1.3 * std::sin(0.7) }, { 310.0, 205.0 },
  { 480.0, 330.0 } };

std::string messageOf(const Cloud& cloud)
{
  try
  {
    fitSimilarity(cloud.previous, cloud.current, cloud.weights);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TEST(Similarity, KnownTransformIsFound)
{
  const Cloud cloud = makeCloud(known, 0.0);
  const SimilarityFit fit = fitSimilarity(cloud.previous, cloud.current, cloud.weights);
  EXPECT_EQ(fit.status, FitStatus::Similarity);
  EXPECT_NEAR(fit.transform.z.x, known.z.x, 1e-12);
  EXPECT_NEAR(fit.transform.z.y, known.z.y, 1e-12);
  EXPECT_NEAR(fit.transform.scale(), 1.3, 1e-12);
  EXPECT_NEAR(fit.transform.angleDegrees(), 0.7 * 180.0 / std::acos(-1.0), 1e-10);
  const glm::dvec2 corner(1000.0, 0.0);
  EXPECT_LT(glm::length(fit.transform.apply(corner) - known.apply(corner)), 1e-9);
  EXPECT_NEAR(fit.residual, 0.0, 1e-9);
  EXPECT_NEAR(fit.correlation, 1.0, 1e-12);
}

TEST(Similarity, ExchangedFramesGiveTheInverse)
{
  const Cloud cloud = makeCloud(known, 60.0);
  const SimilarityFit forth = fitSimilarity(cloud.previous, cloud.current, cloud.weights);
  const SimilarityFit back = fitSimilarity(cloud.current, cloud.previous, cloud.weights);
  const Similarity inverse = forth.transform.inverse();
  EXPECT_LT(glm::length(inverse.z - back.transform.z), 1e-12);
  const glm::dvec2 corner(1000.0, 0.0);
  EXPECT_LT(glm::length(inverse.apply(corner) - back.transform.apply(corner)), 1e-9);
}

TEST(Similarity, NoSmallerErrorNearby)
{
  // The angle is the least-squares one for the fitted scale.
  const Cloud cloud = makeCloud(known, 60.0);
  const SimilarityFit fit = fitSimilarity(cloud.previous, cloud.current, cloud.weights);
  const auto squaredError = [&](Similarity transform)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < cloud.weights.size(); ++i)
    {
      const double length = residualLength(transform, cloud.previous[i], cloud.current[i]);
      sum += cloud.weights[i] * length * length;
    }
    return sum;
  };
  const double best = squaredError(fit.transform);
  EXPECT_NEAR(fit.rmsResidual, std::sqrt(best / fit.weight), 1e-9);
  for (const double turn : { -1e-3, 1e-3 })
  {
    Similarity turned = fit.transform;
    turned.z = complexProduct(turned.z, { std::cos(turn), std::sin(turn) });
    EXPECT_GT(squaredError(turned), best);
  }
}

TEST(Similarity, MomentsAdd)
{
  const Cloud cloud = makeCloud(known, 20.0);
  SimilarityMoments all, first, second;
  for (std::size_t i = 0; i < cloud.weights.size(); ++i)
  {
    SimilarityMoments& half = i < cloud.weights.size() / 2 ? first : second;
    half.add(cloud.weights[i], cloud.previous[i], cloud.current[i]);
    all.add(cloud.weights[i], cloud.previous[i], cloud.current[i]);
  }
  first += second;
  const SimilarityFit whole = fitSimilarity(all);
  const SimilarityFit sum = fitSimilarity(first);
  EXPECT_LT(glm::length(whole.transform.z - sum.transform.z), 1e-13);
  EXPECT_LT(glm::length(whole.transform.to - sum.transform.to), 1e-10);
  second.previousOrigin = { 1.0, 0.0 };
  EXPECT_THROW(first += second, std::invalid_argument);
}

TEST(Similarity, FramesFollowTheImage)
{
  const PatternFrame frame{ { 20.0, 30.0 }, { 8.0, 1.0 }, { -1.0, 8.0 } };
  const PatternFrame next = advance(frame, known);
  // The image of any pattern point moves as the image does.
  const glm::dvec2 before = frame.origin + 3.0 * frame.u + 2.0 * frame.v;
  const glm::dvec2 after = next.origin + 3.0 * next.u + 2.0 * next.v;
  EXPECT_LT(glm::length(known.apply(before) - after), 1e-12);
}

TEST(Similarity, DegenerateClouds)
{
  const SimilarityFit none = fitSimilarity(SimilarityMoments());
  EXPECT_EQ(none.status, FitStatus::NoSamples);
  EXPECT_EQ(none.transform.apply({ 3.0, 4.0 }), glm::dvec2(3.0, 4.0));

  for (const std::size_t count : { 1u, 7u })
  {
    const std::vector<glm::dvec2> p(count, { 100.0, 50.0 });
    const std::vector<glm::dvec2> c(count, { 130.0, 10.0 });
    const SimilarityFit fit = fitSimilarity(p, c, std::vector<double>(count, 0.3));
    EXPECT_EQ(fit.status, FitStatus::TranslationOnly);
    EXPECT_EQ(fit.transform.z, glm::dvec2(1.0, 0.0));
    EXPECT_LT(glm::length(fit.transform.apply({ 0.0, 0.0 }) - glm::dvec2(30.0, -40.0)), 1e-12);
  }

  // A mirror image turns no way: the pattern stays upright, and the correlation tells.
  const std::vector<glm::dvec2> square{ { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } };
  const std::vector<glm::dvec2> mirrored{ { -1, 1 }, { 1, 1 }, { 1, -1 }, { -1, -1 } };
  const SimilarityFit mirror = fitSimilarity(square, mirrored, std::vector<double>(4, 1.0));
  EXPECT_NEAR(mirror.correlation, 0.0, 1e-12);
  EXPECT_EQ(mirror.transform.z, glm::dvec2(1.0, 0.0));
}

TEST(Similarity, WrongInputIsNamed)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Cloud cloud = makeCloud(known, 0.0);
  cloud.previous[3].x = nan;
  EXPECT_EQ(messageOf(cloud), "fitSimilarity: previous[3] is not finite");
  cloud.weights[3] = 0.0; // not read
  EXPECT_EQ(messageOf(cloud), "");
  cloud.current[4].y = nan;
  EXPECT_EQ(messageOf(cloud), "fitSimilarity: current[4] is not finite");
  cloud.weights[2] = -1.0;
  EXPECT_NE(messageOf(cloud).find("weights[2] is -1.0"), std::string::npos);
  cloud.weights.pop_back();
  EXPECT_NE(messageOf(cloud).find("500, 500 and 499 elements"), std::string::npos);

  SimilarityMoments moments;
  moments.add(nan, { 0.0, 0.0 }, { 0.0, 0.0 });
  EXPECT_THROW(fitSimilarity(moments), std::invalid_argument);
  EXPECT_THROW((Similarity{ { 0.0, 0.0 }, {}, {} }.inverse()), std::invalid_argument);
}

} // namespace
