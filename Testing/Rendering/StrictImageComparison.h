// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StrictImageComparison_h
#define StrictImageComparison_h

#include <vtkImageData.h>
#include <vtkImageDifference.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>

// Comparing pictures of strokes. VTK's usual regression metric lets pixels shift by one and
// averages their neighbours first, which makes it blind to the direction and spacing of strokes: it
// accepts a hatch turned by 10 degrees. Here every pixel is compared with its own counterpart.
namespace strict
{

// Differences of up to this many grey levels of 255 are rounding of the GL implementation, not
// drawing.
constexpr int ignoredLevels = 16;

// Sum over all pixels of the difference beyond ignoredLevels, as vtkImageDifference counts it. 0:
// the same picture; a hatch on 300 x 300 pixels turned by half a degree: more than 10,000.
inline double imageError(vtkImageData* image, vtkImageData* expected)
{
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(image);
  difference->SetImageData(expected);
  difference->AllowShiftOff();
  difference->AveragingOff();
  difference->SetThreshold(ignoredLevels);
  difference->Update();
  return difference->GetThresholdedError();
}

// The picture in the window's back buffer, drawn anew, as RGB bytes.
inline vtkSmartPointer<vtkImageData> grab(vtkRenderWindow* window)
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(window);
  filter->ReadFrontBufferOff();
  filter->SetInputBufferTypeToRGB();
  filter->Update();
  return filter->GetOutput();
}

inline std::string option(int argc, char* argv[], const char* flag)
{
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::strcmp(argv[i], flag) == 0)
    {
      return argv[i + 1];
    }
  }
  return std::string();
}

inline void write(vtkImageData* image, const std::string& path)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
}

// Compares `image` with the picture named by -V and returns what a test returns. Where they differ,
// or where there is no picture yet, the image is left in the folder named by -T to be looked at.
inline int regressionTest(vtkImageData* image, int argc, char* argv[], double allowedError = 0.0)
{
  const std::string baseline = option(argc, argv, "-V");
  const std::string name = baseline.substr(baseline.find_last_of('/') + 1);
  const std::string written = option(argc, argv, "-T") + "/" + name;
  if (!std::ifstream(baseline).good())
  {
    write(image, written);
    std::cerr << "no baseline " << baseline << "; look at " << written << "\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(baseline.c_str());
  reader->Update();
  const int* size = image->GetDimensions();
  const int* expectedSize = reader->GetOutput()->GetDimensions();
  const bool sameSize = size[0] == expectedSize[0] && size[1] == expectedSize[1];
  const double error = sameSize ? imageError(image, reader->GetOutput()) : -1.0;
  if (sameSize && error <= allowedError)
  {
    return EXIT_SUCCESS;
  }
  write(image, written);
  std::cerr << written << " differs from " << baseline << ": "
            << (sameSize ? "error " + std::to_string(error) : std::string("another size"))
            << ", allowed " << allowedError << "\n";
  return EXIT_FAILURE;
}

inline int regressionTest(
  vtkRenderWindow* window, int argc, char* argv[], double allowedError = 0.0)
{
  return regressionTest(grab(window), argc, argv, allowedError);
}

} // namespace strict

#endif
