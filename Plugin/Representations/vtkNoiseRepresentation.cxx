// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNoiseRepresentation.h"

#include "RepresentationFile.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkNoiseRepresentation);

namespace
{
constexpr const char* NO_ARRAY = "None";

std::string Text(const char* text)
{
  return text ? text : "";
}
} // namespace

//------------------------------------------------------------------------------
vtkNoiseRepresentation::vtkNoiseRepresentation()
  : SpotFile(std::make_unique<RepresentationFile>())
{
  this->SetPatternStyle("phasor");
}

//------------------------------------------------------------------------------
vtkNoiseRepresentation::~vtkNoiseRepresentation() = default;

//------------------------------------------------------------------------------
void vtkNoiseRepresentation::SetNoiseSpotImage(const char* fileName)
{
  this->Change(this->NoiseSpotImage, Text(fileName));
}

//------------------------------------------------------------------------------
const char* vtkNoiseRepresentation::GetNoiseSpotImage()
{
  return this->NoiseSpotImage.c_str();
}

//------------------------------------------------------------------------------
void vtkNoiseRepresentation::SetNoiseDirectionArray(const char* name)
{
  this->Change(this->NoiseDirectionArray, Text(name));
}

//------------------------------------------------------------------------------
const char* vtkNoiseRepresentation::GetNoiseDirectionArray()
{
  return this->NoiseDirectionArray.c_str();
}

//------------------------------------------------------------------------------
void vtkNoiseRepresentation::SetNoiseControlArray(int vtkNotUsed(index), int vtkNotUsed(port),
  int vtkNotUsed(connection), int vtkNotUsed(association), const char* name)
{
  this->Change(this->NoiseControlArrayName, Text(name));
}

//------------------------------------------------------------------------------
const char* vtkNoiseRepresentation::GetNoiseControlArrayName()
{
  return this->NoiseControlArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkNoiseRepresentation::AdjustStyle(vtkPatternStyle* style)
{
  this->Superclass::AdjustStyle(style);
  const vtkSmartPointer<vtkImageData> spot = this->ReadSpot();
  ForEachLayer<vtkNoiseLayer>(style,
    [this, &spot](vtkNoiseLayer* layer)
    {
      this->AdjustKind(layer, spot);
      this->AdjustNumbers(layer);
      this->AdjustControl(layer);
      this->AdjustKernels(layer);
    });
}

//------------------------------------------------------------------------------
void vtkNoiseRepresentation::AdjustKind(vtkNoiseLayer* layer, vtkImageData* spot)
{
  if (this->NoiseKind != AS_IN_STYLE)
  {
    layer->SetKind(this->NoiseKind);
  }
  if (spot)
  {
    layer->SetImage(spot);
    layer->SetImageFileName(this->NoiseSpotImage.c_str());
  }
}

//------------------------------------------------------------------------------
void vtkNoiseRepresentation::AdjustNumbers(vtkNoiseLayer* layer)
{
  layer->SetSpread(layer->GetSpread() + this->NoiseSpread);
  layer->SetRegularity(layer->GetRegularity() * this->NoiseRegularity);
  layer->SetSmoothness(layer->GetSmoothness() + this->NoiseSmoothness);
  if (this->NoiseOverlap > 0.0)
  {
    layer->SetOverlap(this->NoiseOverlap);
  }
  if (this->NoiseFade > 0.0)
  {
    layer->SetFade(this->NoiseFade);
  }
  if (this->NoiseLife >= 0)
  {
    layer->SetLife(this->NoiseLife);
  }
}

//------------------------------------------------------------------------------
void vtkNoiseRepresentation::AdjustControl(vtkNoiseLayer* layer)
{
  if (this->NoiseDirectionArray != NO_ARRAY)
  {
    layer->SetDirectionArrayName(this->NoiseDirectionArray.c_str());
  }
  if (this->NoiseControl != AS_IN_STYLE)
  {
    layer->SetControl(this->NoiseControl);
    layer->SetControlArrayName(this->NoiseControlArrayName.c_str());
    layer->SetControlRange(this->NoiseControlRange);
    layer->SetSizeFactors(this->NoiseSizeFactors[0], this->NoiseSizeFactors[1]);
    layer->SetRegularityFactors(this->NoiseRegularityFactors[0], this->NoiseRegularityFactors[1]);
  }
}

//------------------------------------------------------------------------------
void vtkNoiseRepresentation::AdjustKernels(vtkNoiseLayer* layer)
{
  if (this->NoiseDistribution != AS_IN_STYLE)
  {
    layer->SetDistribution(this->NoiseDistribution);
  }
  if (this->NoiseObjectTest != AS_IN_STYLE)
  {
    layer->SetObjectTest(this->NoiseObjectTest != 0);
  }
  if (this->NoiseTriangleTest != AS_IN_STYLE)
  {
    layer->SetTriangleTest(this->NoiseTriangleTest != 0);
  }
  if (this->NoiseDepthTest != AS_IN_STYLE)
  {
    layer->SetDepthTest(this->NoiseDepthTest != 0);
  }
  if (this->NoisePartialVisibility != AS_IN_STYLE)
  {
    layer->SetPartialVisibility(this->NoisePartialVisibility != 0);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkNoiseRepresentation::ReadSpot()
{
  if (this->SpotFile->IsNew(this->NoiseSpotImage))
  {
    vtkNew<vtkNoiseLayer> reader;
    const bool read = !this->NoiseSpotImage.empty() && reader->ReadImage(this->NoiseSpotImage);
    this->Spot = read ? reader->GetImage() : nullptr;
  }
  return this->Spot;
}

//------------------------------------------------------------------------------
void vtkNoiseRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NoiseKind: " << this->NoiseKind << "\n";
  os << indent << "NoiseSpotImage: " << this->NoiseSpotImage << "\n";
  os << indent << "NoiseSpread: " << this->NoiseSpread << "\n";
  os << indent << "NoiseRegularity: " << this->NoiseRegularity << "\n";
  os << indent << "NoiseSmoothness: " << this->NoiseSmoothness << "\n";
  os << indent << "NoiseOverlap: " << this->NoiseOverlap << "\n";
  os << indent << "NoiseFade: " << this->NoiseFade << "\n";
  os << indent << "NoiseLife: " << this->NoiseLife << "\n";
  os << indent << "NoiseDirectionArray: " << this->NoiseDirectionArray << "\n";
  os << indent << "NoiseControl: " << this->NoiseControl << "\n";
  os << indent << "NoiseControlArrayName: " << this->NoiseControlArrayName << "\n";
  os << indent << "NoiseControlRange: " << this->NoiseControlRange[0] << ", "
     << this->NoiseControlRange[1] << "\n";
  os << indent << "NoiseSizeFactors: " << this->NoiseSizeFactors[0] << ", "
     << this->NoiseSizeFactors[1] << "\n";
  os << indent << "NoiseRegularityFactors: " << this->NoiseRegularityFactors[0] << ", "
     << this->NoiseRegularityFactors[1] << "\n";
  os << indent << "NoiseDistribution: " << this->NoiseDistribution << "\n";
  os << indent << "NoiseObjectTest: " << this->NoiseObjectTest << "\n";
  os << indent << "NoiseTriangleTest: " << this->NoiseTriangleTest << "\n";
  os << indent << "NoiseDepthTest: " << this->NoiseDepthTest << "\n";
  os << indent << "NoisePartialVisibility: " << this->NoisePartialVisibility << "\n";
}
