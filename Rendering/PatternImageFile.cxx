// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternImageFile.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkImageReader2.h"
#include "vtkImageReader2Factory.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"

#include "vtksys/FStream.hxx"
#include "vtksys/SystemTools.hxx"

#include <stdexcept>

namespace
{

[[noreturn]] void fail(const std::string& fileName, const std::string& reason)
{
  throw std::runtime_error("cannot read the image \"" + fileName + "\": " + reason);
}

/** Finds the reader for a file. While VTK tries its readers one by one they may warn that a file
 * of another format is not theirs; that says nothing about the file. */
vtkSmartPointer<vtkImageReader2> findReader(const std::string& fileName)
{
  const int shown = vtkObject::GetGlobalWarningDisplay();
  vtkObject::GlobalWarningDisplayOff();
  vtkImageReader2* reader = vtkImageReader2Factory::CreateImageReader2(fileName.c_str());
  vtkObject::SetGlobalWarningDisplay(shown);
  return vtkSmartPointer<vtkImageReader2>::Take(reader);
}

/** Keeps the errors of a reader or writer off the screen. */
void noteErrors(vtkObject* object, bool& failed)
{
  vtkNew<vtkCallbackCommand> onError;
  onError->SetClientData(&failed);
  onError->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { *static_cast<bool*>(data) = true; });
  object->AddObserver(vtkCommand::ErrorEvent, onError);
}

/** VTK's PNG reader crashes on a file that was cut off, so look for the chunk that ends it. */
bool isCutOff(const std::string& fileName)
{
  const std::string ending = "IEND\xae\x42\x60\x82";
  std::string found(ending.size(), ' ');
  vtksys::ifstream file(fileName.c_str(), std::ios::in | std::ios::binary);
  file.seekg(-static_cast<std::streamoff>(ending.size()), std::ios::end);
  return !file.read(&found[0], static_cast<std::streamsize>(found.size())) || found != ending;
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
  const vtkSmartPointer<vtkImageReader2> reader = findReader(fileName);
  if (!reader)
  {
    fail(fileName, "not a picture format that VTK knows");
  }
  if (vtkPNGReader::SafeDownCast(reader) && isCutOff(fileName))
  {
    fail(fileName, "the file is damaged");
  }
  bool failed = false;
  noteErrors(reader, failed);
  reader->SetFileName(fileName.c_str());
  reader->Update();
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  if (failed || reader->GetErrorCode() != 0 || !image->GetPointData()->GetScalars())
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

//------------------------------------------------------------------------------
void writePatternImage(vtkImageData* image, const std::string& fileName)
{
  bool failed = false;
  vtkNew<vtkPNGWriter> writer;
  noteErrors(writer, failed);
  writer->SetInputData(image);
  writer->SetFileName(fileName.c_str());
  writer->Write();
  if (failed || writer->GetErrorCode() != 0)
  {
    throw std::runtime_error("cannot write the image \"" + fileName + "\"");
  }
}

//------------------------------------------------------------------------------
GreyImage greyImage(vtkImageData* image, const std::string& purpose)
{
  if (!image)
  {
    throw std::invalid_argument("image: expected an image for the " + purpose + ", found none");
  }
  int size[3];
  image->GetDimensions(size);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  if (!scalars || size[0] < 1 || size[1] < 1 || size[2] != 1)
  {
    throw std::invalid_argument("image: expected a 2D image with scalars");
  }
  const int components = scalars->GetNumberOfComponents();
  const int colors = components == 2 || components == 4 ? components - 1 : components;
  GreyImage grey;
  grey.width = size[0];
  grey.height = size[1];
  grey.values.resize(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  for (std::size_t i = 0; i < grey.values.size(); ++i)
  {
    double sum = 0.0;
    for (int c = 0; c < colors; ++c)
    {
      sum += scalars->GetComponent(static_cast<vtkIdType>(i), c);
    }
    grey.values[i] = static_cast<float>(sum / colors);
  }
  return grey;
}

} // namespace hachure
