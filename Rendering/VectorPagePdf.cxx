// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VectorPageFile.h"

#include <stdexcept>

#ifdef HACHURE_HAS_CAIRO
#include <cairo-pdf.h>

#include <algorithm>
#include <memory>
#endif

namespace hachure
{
#ifdef HACHURE_HAS_CAIRO
namespace
{

constexpr double pointsPerMillimetre = 72.0 / 25.4;
// Distance of the control points of a quarter of a circle, in radii: off by 0.03 % of the radius.
constexpr double quarterCircle = 0.5522847498;

struct Destroy
{
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int size)
{
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

void setInk(cairo_t* context, const glm::vec3& color, double opacity)
{
  cairo_set_source_rgba(context, color.r, color.g, color.b, std::clamp(opacity, 0.0, 1.0));
}

// As cairo_arc, but always of four curves: that one takes fewer for small discs.
void addDisc(cairo_t* context, const VectorDisc& disc)
{
  const double radius = disc.radius;
  glm::dvec2 out(radius, 0.0);
  const glm::dvec2 center = disc.center;
  cairo_move_to(context, center.x + out.x, center.y + out.y);
  for (int quarter = 0; quarter < 4; ++quarter)
  {
    const glm::dvec2 next(-out.y, out.x);
    const glm::dvec2 first = center + out + quarterCircle * next;
    const glm::dvec2 second = center + next + quarterCircle * out;
    const glm::dvec2 end = center + next;
    cairo_curve_to(context, first.x, first.y, second.x, second.y, end.x, end.y);
    out = next;
  }
  cairo_close_path(context);
}

// Opaque discs of one ink are one shape; others would not darken each other where they overlap.
void drawDiscs(cairo_t* context, const std::vector<VectorDisc>& discs)
{
  for (std::size_t i = 0; i < discs.size(); ++i)
  {
    const VectorDisc& disc = discs[i];
    addDisc(context, disc);
    const bool last = i + 1 == discs.size() || disc.opacity < 1.0f || discs[i + 1].opacity < 1.0f ||
      discs[i + 1].color != disc.color;
    if (last)
    {
      setInk(context, disc.color, disc.opacity);
      cairo_fill(context);
    }
  }
}

void drawStroke(cairo_t* context, const VectorStroke& stroke)
{
  for (const glm::dvec2& point : stroke.points)
  {
    cairo_line_to(context, point.x, point.y);
  }
  if (stroke.closed)
  {
    cairo_close_path(context);
  }
  setInk(context, stroke.color, 1.0);
  cairo_set_line_width(context, stroke.width);
  cairo_stroke(context);
}

void drawPage(cairo_t* context, const VectorPage& page)
{
  // Pixels, y up.
  const double scale = page.millimetresPerPixel * pointsPerMillimetre;
  cairo_scale(context, scale, -scale);
  cairo_translate(context, 0.0, -page.size.y);
  cairo_set_line_cap(context, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  if (page.paintsBackground)
  {
    setInk(context, page.background, 1.0);
    cairo_rectangle(context, 0.0, 0.0, page.size.x, page.size.y);
    cairo_fill(context);
  }
  drawDiscs(context, page.discs);
  for (const VectorStroke& stroke : page.strokes)
  {
    drawStroke(context, stroke);
  }
}

void check(cairo_status_t status)
{
  if (status != CAIRO_STATUS_SUCCESS)
  {
    throw std::runtime_error(
      std::string("cannot draw a PDF page: ") + cairo_status_to_string(status));
  }
}

} // namespace

std::string vectorPageAsPdf(const VectorPage& page)
{
  std::string bytes;
  const glm::dvec2 size = page.size * (page.millimetresPerPixel * pointsPerMillimetre);
  const std::unique_ptr<cairo_surface_t, Destroy> surface(
    cairo_pdf_surface_create_for_stream(append, &bytes, size.x, size.y));
  // The same page is the same bytes, at any time.
  cairo_pdf_surface_set_metadata(surface.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  const std::unique_ptr<cairo_t, Destroy> context(cairo_create(surface.get()));
  drawPage(context.get(), page);
  check(cairo_status(context.get()));
  cairo_surface_finish(surface.get());
  check(cairo_surface_status(surface.get()));
  return bytes;
}

#else

std::string vectorPageAsPdf(const VectorPage&)
{
  throw std::runtime_error("cannot write PDF: built without Cairo; SVG needs none");
}

#endif
} // namespace hachure
