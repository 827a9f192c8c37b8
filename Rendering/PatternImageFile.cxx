// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternImageFile.h"

#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkPointData.h"

#include "vtksys/SystemTools.hxx"

#include <stdexcept>

namespace
{

[[noreturn]] void fail(const std::string& fileName, const std::string& reason)
{
  throw std::runtime_error("cannot read the image \"" + fileName + "\": " + reason);
}

} // namespace

namespace hachure
{

vtkSmartPointer<vtkImageData> readPatternImage(const std::string& fileName)
{
  if (!vtksys::SystemTools::FileExists(fileName, true))
  {
    fail(fileName, "no such file");
  }
  const auto reader = vtkSmartPointer<vtkImageReader2>::Take(
    vtkImageReader2Factory::CreateImageReader2(fileName.c_str()));
  if (!reader)
  {
    fail(fileName, "not a picture format that VTK knows");
  }
  reader->SetFileName(fileName.c_str());
  reader->Update();
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || !image->GetPointData()->GetScalars() ||
    image->GetNumberOfPoints() == 0)
  {
    fail(fileName, "the file is damaged");
  }
  if (image->GetDimensions()[2] != 1)
  {
    fail(fileName,
      "expected one slice, got " + std::to_string(image->GetDimensions()[2]) + " of them");
  }
  return image;
}

} // namespace hachure
