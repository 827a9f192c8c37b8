// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "FileReading.h"

#include "ErrorCollector.h"
#include "UserError.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkDataSet.h>
#include <vtkExodusIIReader.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNetCDFCFReader.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkSLCReader.h>
#include <vtkSTLReader.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

namespace hachure::program
{
namespace
{
using MakeReader = vtkSmartPointer<vtkAlgorithm> (*)(const std::string& path);

template <class Reader>
vtkSmartPointer<vtkAlgorithm> makeReader(const std::string& path)
{
  auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

/// Exodus reads no field unless told to.
vtkSmartPointer<vtkAlgorithm> makeExodusReader(const std::string& path)
{
  auto reader = vtkSmartPointer<vtkExodusIIReader>::New();
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  for (const int type : { vtkExodusIIReader::NODAL, vtkExodusIIReader::ELEM_BLOCK })
  {
    reader->SetAllArrayStatus(type, 1);
  }
  return reader;
}

const std::vector<std::pair<std::string, MakeReader>>& readers()
{
  static const std::vector<std::pair<std::string, MakeReader>> Known = {
    { ".vtp", makeReader<vtkXMLPolyDataReader> },
    { ".vtu", makeReader<vtkXMLUnstructuredGridReader> },
    { ".vti", makeReader<vtkXMLImageDataReader> },
    { ".vtm", makeReader<vtkXMLMultiBlockDataReader> },
    { ".stl", makeReader<vtkSTLReader> },
    { ".obj", makeReader<vtkOBJReader> },
    { ".ply", makeReader<vtkPLYReader> },
    { ".ex2", makeExodusReader },
    { ".nii", makeReader<vtkNIFTIImageReader> },
    { ".nii.gz", makeReader<vtkNIFTIImageReader> },
    { ".slc", makeReader<vtkSLCReader> },
    { ".nc", makeReader<vtkNetCDFCFReader> },
    { ".cdf", makeReader<vtkNetCDFCFReader> },
  };
  return Known;
}

MakeReader readerFor(const std::string& path)
{
  const std::string name = lowerCase(std::filesystem::path(path).filename().string());
  std::string known;
  for (const auto& [extension, make] : readers())
  {
    if (name.size() > extension.size() &&
      name.compare(name.size() - extension.size(), extension.size(), extension) == 0)
    {
      return make;
    }
    known += " " + extension;
  }
  throw UserError("unknown file type '" + path + "'; known:" + known);
}

void checkReadable(const std::string& path)
{
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
  {
    throw UserError("cannot read '" + path + "': it is a folder");
  }
  errno = 0;
  if (!std::ifstream(path, std::ios::binary))
  {
    throw UserError("cannot read '" + path + "': " + std::strerror(errno));
  }
}

/// VTK writes the range of an array with infinities and then cannot read it back, which is
/// harmless.
bool isHarmless(const std::string& error)
{
  return error.empty() || error.find("InformationKey") != std::string::npos;
}

/// Readers leave an empty data set behind when they give up.
bool isEmpty(vtkDataObject* data)
{
  return !data || data->GetNumberOfElements(vtkDataObject::POINT) == 0;
}
} // namespace

//----------------------------------------------------------------------------
std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

//----------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> readFile(const std::string& path)
{
  const MakeReader make = readerFor(path);
  checkReadable(path);
  ErrorCollector errors;
  const vtkSmartPointer<vtkAlgorithm> reader = make(path);
  reader->Update();
  vtkSmartPointer<vtkDataObject> data = reader->GetOutputDataObject(0);
  if (!isHarmless(errors.first()) || reader->GetErrorCode() != 0)
  {
    throw UserError("cannot read '" + path +
      "': " + (errors.first().empty() ? "it is not a valid file of its type" : errors.first()));
  }
  if (isEmpty(data))
  {
    throw UserError("'" + path + "' holds no points");
  }
  return data;
}
} // namespace hachure::program
