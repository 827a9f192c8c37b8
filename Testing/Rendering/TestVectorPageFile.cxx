// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// Discs and strokes of a page, drawn by programs that read SVG and PDF, lie where they should.

#include "VectorPageFile.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace
{

bool passed = true;

void check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "Not so: " << what << "\n";
    passed = false;
  }
}

constexpr int zoom = 4; // pixels of the pictures per pixel of the page

// Small and large, touching the border, overlapping, opaque and translucent; a ring and a line.
hachure::VectorPage makePage()
{
  hachure::VectorPage page;
  page.size = { 120.0, 80.0 };
  page.millimetresPerPixel = 0.2;
  const double radii[] = { 0.4, 0.8, 1.5, 3.0, 6.0 };
  for (int i = 0; i < 5; ++i)
  {
    page.discs.push_back({ { 12.3 + 20.0 * i, 60.7 }, radii[i], glm::vec3(0.0f), 1.0f });
  }
  page.discs.push_back({ { 100.0, 20.0 }, 8.0, glm::vec3(0.0f), 0.5f });
  page.discs.push_back({ { 0.0, 0.0 }, 5.0, glm::vec3(0.0f), 1.0f });
  page.strokes.push_back({ { { 20.0, 10.0 }, { 60.0, 10.0 }, { 60.0, 40.0 } }, 3.0 });
  page.strokes.back().closed = true;
  page.strokes.push_back({ { { 75.0, 15.0 }, { 85.0, 45.0 } }, 1.2 });
  return page;
}

double distanceTo(const hachure::VectorStroke& stroke, const glm::dvec2& place)
{
  double nearest = 1e9;
  const std::size_t count = stroke.points.size();
  for (std::size_t i = 1; i < count + (stroke.closed ? 1 : 0); ++i)
  {
    const glm::dvec2 from = stroke.points[i - 1];
    const glm::dvec2 along = stroke.points[i % count] - from;
    const double share =
      std::clamp(glm::dot(place - from, along) / glm::dot(along, along), 0.0, 1.0);
    nearest = std::min(nearest, glm::distance(place, from + share * along));
  }
  return nearest;
}

double inkAt(const hachure::VectorPage& page, const glm::dvec2& place)
{
  double paper = 1.0;
  for (const hachure::VectorDisc& disc : page.discs)
  {
    paper *= glm::distance(disc.center, place) < disc.radius ? 1.0 - disc.opacity : 1.0;
  }
  for (const hachure::VectorStroke& stroke : page.strokes)
  {
    paper *= distanceTo(stroke, place) < 0.5 * stroke.width ? 0.0 : 1.0;
  }
  return 1.0 - paper;
}

// Mean ink of a pixel of the picture.
double expectedInk(const hachure::VectorPage& page, int x, int y)
{
  constexpr int samples = 4;
  double ink = 0.0;
  for (int i = 0; i < samples * samples; ++i)
  {
    const int column = i % samples;
    const int row = i / samples;
    const glm::dvec2 part((column + 0.5) / samples, (row + 0.5) / samples);
    ink += inkAt(page, (glm::dvec2(x, y) + part) / static_cast<double>(zoom));
  }
  return ink / (samples * samples);
}

void comparePicture(const hachure::VectorPage& page, const std::string& fileName)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  const int* size = image->GetDimensions();
  check(size[0] == zoom * 120 && size[1] == zoom * 80, fileName + " has the size of the page");
  double difference = 0.0;
  double worst = 0.0;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const double ink = 1.0 - image->GetScalarComponentAsDouble(x, y, 0, 0) / 255.0;
      const double error = std::abs(ink - expectedInk(page, x, y));
      difference += error;
      worst = std::max(worst, error);
    }
  }
  difference /= std::max(1, size[0] * size[1]);
  std::cout << fileName << ": mean difference " << difference << ", worst " << worst << "\n";
  check(difference < 0.002, fileName + " shows the page");
  check(worst < 0.5, fileName + " has every edge within less than half of its pixels");
}

void draw(const std::string& command)
{
  check(std::system(command.c_str()) == 0, command);
}

std::string textOf(const std::string& fileName)
{
  std::ifstream stream(fileName, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

void testPictures(const std::string& folder)
{
  const hachure::VectorPage page = makePage();
  const std::string name = folder + "/TestVectorPageFile";
  const long dotsPerInch = std::lround(zoom * 25.4 / page.millimetresPerPixel);
  const std::string resolution = std::to_string(dotsPerInch);
  hachure::writeVectorPage(page, name + ".svg");
  draw("rsvg-convert -d " + resolution + " -p " + resolution + " '" + name + ".svg' -o '" + name +
    "-svg.png'");
  comparePicture(page, name + "-svg.png");
  hachure::writeVectorPage(page, name + ".PDF");
  // From the resolution alone it would round the size of the page up.
  draw("pdftoppm -scale-to-x 480 -scale-to-y 320 -gray -png -singlefile '" + name + ".PDF' '" +
    name + "-pdf'");
  comparePicture(page, name + "-pdf.png");

  const std::string svg = textOf(name + ".svg");
  check(svg.find("width=\"24mm\" height=\"16mm\" viewBox=\"0 0 24 16\"") != std::string::npos,
    "an SVG file is in millimetres");
  check(svg.find("<circle cx=\"2.46\" cy=\"3.86\" r=\"0.08\"/>") != std::string::npos,
    "discs are circles");
  const std::string pdf = textOf(name + ".PDF");
  hachure::writeVectorPage(page, name + ".PDF");
  check(textOf(name + ".PDF") == pdf, "the same page is the same file");
  check(!std::filesystem::exists(name + ".PDF.part"), "nothing else is left");
}

void checkError(
  const hachure::VectorPage& page, const std::string& fileName, const std::string& expected)
{
  try
  {
    hachure::writeVectorPage(page, fileName);
    check(false, "an error about " + expected);
  }
  catch (const std::exception& error)
  {
    check(std::string(error.what()).find(expected) != std::string::npos,
      std::string(error.what()) + " says " + expected);
  }
}

void testErrors(const std::string& folder)
{
  hachure::VectorPage page = makePage();
  const std::string name = folder + "/TestVectorPageFile-errors";
  std::filesystem::remove_all(name + ".svg");
  std::filesystem::remove_all(name + ".svg.part");
  checkError(page, name + ".eps", "expected a name that ends with .svg or .pdf");
  checkError(page, name, "expected a name that ends with .svg or .pdf");
  checkError(page, folder + "/none/page.pdf", "No such file or directory");
  std::filesystem::create_directory(name + ".svg");
  checkError(page, name + ".svg", "Is a directory");
  check(!std::filesystem::exists(name + ".svg.part"), "no draft is left");
  std::filesystem::remove(name + ".svg");
  hachure::writeVectorPage(page, name + ".svg");
  const std::string before = textOf(name + ".svg");
  page.discs[0].radius = std::nan("");
  checkError(page, name + ".svg", "discs[0]: the radius");
  page = makePage();
  page.size.x = -1.0;
  checkError(page, name + ".svg", "page size: -1");
  check(textOf(name + ".svg") == before, "the file is as it was");
}

} // namespace

int TestVectorPageFile(int argc, char* argv[])
{
  std::string folder = ".";
  for (int i = 1; i + 1 < argc; ++i)
  {
    folder = std::strcmp(argv[i], "-T") == 0 ? argv[i + 1] : folder;
  }
  testPictures(folder);
  testErrors(folder);
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}
