// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VectorPageFile.h"

#include "vtkIndent.h"
#include "vtkNew.h"
#include "vtkXMLDataElement.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

// SVG through VTK's XML elements, as vtkSVGExporter writes it. That exporter itself draws
// vtkContext2D scenes, in pixels, with circles as polygons.
namespace hachure
{
namespace
{

constexpr int decimals = 4; // of a millimetre: a tenth of a micrometre

// Neither the locale nor trailing zeros show.
std::string number(double value)
{
  std::array<char, 64> digits;
  const auto end = std::to_chars(
    digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals);
  std::string text(digits.data(), end.ec == std::errc() ? end.ptr : digits.data());
  if (text.find('.') != std::string::npos)
  {
    text.erase(text.find_last_not_of('0') + 1);
    text.erase(text.find_last_not_of('.') + 1);
  }
  return text == "-0" ? "0" : text;
}

std::string colorName(const glm::vec3& color)
{
  static const char* const digits = "0123456789abcdef";
  std::string name = "#";
  for (int i = 0; i < 3; ++i)
  {
    const int level = static_cast<int>(std::lround(255.0f * std::clamp(color[i], 0.0f, 1.0f)));
    name += digits[level / 16];
    name += digits[level % 16];
  }
  return name;
}

class SvgPage
{
public:
  explicit SvgPage(const VectorPage& vectorPage)
    : page(vectorPage)
    , scale(vectorPage.millimetresPerPixel)
  {
  }

  std::string text() const
  {
    vtkNew<vtkXMLDataElement> root;
    root->SetName("svg");
    root->SetAttribute("xmlns", "http://www.w3.org/2000/svg");
    root->SetAttribute("version", "1.1");
    const std::string width = number(this->scale * this->page.size.x);
    const std::string height = number(this->scale * this->page.size.y);
    root->SetAttribute("width", (width + "mm").c_str());
    root->SetAttribute("height", (height + "mm").c_str());
    std::string box = "0 0 ";
    box += width;
    box += ' ';
    box += height;
    root->SetAttribute("viewBox", box.c_str());
    if (this->page.paintsBackground)
    {
      vtkXMLDataElement* background = add(root, "rect");
      set(background, "id", "background");
      set(background, "width", width);
      set(background, "height", height);
      set(background, "fill", colorName(this->page.background));
    }
    this->addDiscs(root);
    this->addStrokes(root);
    std::ostringstream stream;
    stream << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    root->PrintXML(stream, vtkIndent());
    return stream.str();
  }

private:
  // The parent keeps it.
  static vtkXMLDataElement* add(vtkXMLDataElement* parent, const char* name)
  {
    vtkNew<vtkXMLDataElement> element;
    element->SetName(name);
    parent->AddNestedElement(element);
    return element;
  }

  static void set(vtkXMLDataElement* element, const char* name, const std::string& value)
  {
    element->SetAttribute(name, value.c_str());
  }

  std::string x(double pixels) const { return number(this->scale * pixels); }
  std::string y(double pixels) const { return number(this->scale * (this->page.size.y - pixels)); }

  void addDiscs(vtkXMLDataElement* root) const
  {
    if (this->page.discs.empty())
    {
      return;
    }
    vtkXMLDataElement* all = add(root, "g");
    set(all, "id", "discs");
    vtkXMLDataElement* group = nullptr;
    const VectorDisc* before = nullptr;
    for (const VectorDisc& disc : this->page.discs)
    {
      if (!before || disc.color != before->color || disc.opacity != before->opacity)
      {
        group = add(all, "g");
        set(group, "fill", colorName(disc.color));
        if (disc.opacity < 1.0f)
        {
          set(group, "fill-opacity", number(std::max(disc.opacity, 0.0f)));
        }
      }
      before = &disc;
      vtkXMLDataElement* circle = add(group, "circle");
      set(circle, "cx", this->x(disc.center.x));
      set(circle, "cy", this->y(disc.center.y));
      set(circle, "r", number(this->scale * disc.radius));
    }
  }

  void addStrokes(vtkXMLDataElement* root) const
  {
    if (this->page.strokes.empty())
    {
      return;
    }
    vtkXMLDataElement* all = add(root, "g");
    set(all, "id", "contours");
    set(all, "fill", "none");
    set(all, "stroke-linecap", "round");
    set(all, "stroke-linejoin", "round");
    vtkXMLDataElement* group = nullptr;
    const VectorStroke* before = nullptr;
    for (const VectorStroke& stroke : this->page.strokes)
    {
      if (!before || stroke.color != before->color || stroke.width != before->width)
      {
        group = add(all, "g");
        set(group, "stroke", colorName(stroke.color));
        set(group, "stroke-width", number(this->scale * stroke.width));
      }
      before = &stroke;
      if (!stroke.points.empty())
      {
        set(add(group, "path"), "d", this->pathOf(stroke));
      }
    }
  }

  std::string pathOf(const VectorStroke& stroke) const
  {
    std::string path;
    for (const glm::dvec2& point : stroke.points)
    {
      path += path.empty() ? "M" : " L";
      path += this->x(point.x);
      path += ' ';
      path += this->y(point.y);
    }
    return stroke.closed ? path + " Z" : path;
  }

  const VectorPage& page;
  double scale; // millimetres per pixel
};

} // namespace

std::string vectorPageAsSvg(const VectorPage& page)
{
  return SvgPage(page).text();
}

} // namespace hachure
