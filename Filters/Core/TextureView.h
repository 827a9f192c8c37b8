// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_TextureView_h
#define hachure_TextureView_h

#include "Span.h"

#include <glm/gtc/type_precision.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <string>
#include <vector>

// The views that view-dependent textures are made of (Grimm and Kowalski 2002): a camera, the image
// that was painted or taken with it, and from where else that image is to be seen. Coordinates are
// those of the surface.
namespace hachure
{

// How a view appears where the camera comes from its extreme points to its own place.
enum class FadeMode
{
  Curve,  // by the fade curve, as seen from each cell (the paper's)
  Middle, // from the middle of what it shows outwards
  Even    // equally everywhere: by the camera's place alone
};

struct TextureView
{
  // To OpenGL's clip space, of whose square the image fills all: x to the right, y up, -1 to 1.
  glm::dmat4 modelToClip{ 1.0 };
  // Where the camera is and the place it looks at, about which extreme points lie. Of parallel
  // views only the direction from focus to eye counts, and the distance between them.
  glm::dvec3 eye{ 0.0, 0.0, 1.0 };
  glm::dvec3 focus{ 0.0 };
  bool parallel = false;
  // Pixels of the image, 1 to mostViewPixels a side.
  int width = 0;
  int height = 0;
  // Whether the image is only seen from directions around the view's own, in front of what is seen
  // from everywhere.
  bool dependent = false;
  // Extreme places of the camera, any number in any order: of a dependent view's range. None: it is
  // seen from everywhere, at the same place in the stack as other dependent views.
  std::vector<glm::dvec3> extremes;
  // Points of relative angle (0: the view's own camera, 1: on the polygon of extreme points), 0 to
  // 1 and rising, and of the image's share there, 0 to 1; linear between them and constant up to 0
  // and 1. Beyond 1 the share is 0 whatever the curve says.
  std::vector<glm::dvec2> fadeCurve{ { 0.0, 1.0 }, { 0.5, 1.0 }, { 1.0, 0.0 } };
  FadeMode fadeMode = FadeMode::Curve;
};

constexpr int mostViewPixels = 16384;

// sRGB with straight alpha, which masks: what is 0 is no part of the view. Rows from the bottom up.
struct TextureImage
{
  int width = 0;
  int height = 0;
  Span<const glm::u8vec4> pixels;
};

// Throw std::invalid_argument naming the first bad member and its value after `name`: numbers that
// are not finite, a matrix that cannot be inverted, eye and focus in one place, sizes, curves and,
// of images, ones that are not as large as their view's.
void checkTextureView(const TextureView& view, const std::string& name);
void checkTextureImage(const TextureImage& image, const TextureView& view, const std::string& name);

// Whether both see the same pixels of a surface.
bool haveSameCamera(const TextureView& a, const TextureView& b);
// Whether both have the same share in every direction.
bool haveSameFade(const TextureView& a, const TextureView& b);

} // namespace hachure

#endif
