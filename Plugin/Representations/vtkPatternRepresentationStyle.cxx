// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
// What the properties of the representation replace in a style.
#include "vtkPatternRepresentation.h"

#include "RepresentationFile.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkNoiseLayer.h"
#include "vtkStippleLayer.h"

#include <cmath>

namespace
{
// The setters take angles within a full turn.
double WithinTurn(double degrees)
{
  return std::fmod(degrees, 360.0);
}
} // namespace

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustStyle(vtkPatternStyle* style)
{
  const vtkSmartPointer<vtkImageData> picture = this->ReadPicture();
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    vtkPatternLayer* const layer = style->GetLayer(i);
    if (auto* image = vtkImagePatternLayer::SafeDownCast(layer))
    {
      this->AdjustMarks(image, picture);
      this->AdjustMarksMotion(image);
    }
    if (auto* noise = vtkNoiseLayer::SafeDownCast(layer))
    {
      this->AdjustNoise(noise);
    }
    if (auto* stipples = vtkStippleLayer::SafeDownCast(layer))
    {
      stipples->SetSize(stipples->GetSize() * this->PatternScale);
    }
    layer->SetSeed(layer->GetSeed() + static_cast<vtkTypeUInt32>(this->PatternSeed));
    this->AdjustInk(layer);
    this->AdjustTone(layer->GetTone());
  }
  if (this->PatternPaper != AS_IN_STYLE)
  {
    style->SetPaperSource(this->PatternPaper);
    style->SetPaperColor(this->PatternPaperColor);
  }
  this->AdjustOutline(style);
  this->AdjustMotion(style);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustOutline(vtkPatternStyle* style)
{
  if (this->PatternOutlineInk != AS_IN_STYLE)
  {
    style->SetOutlineColor(this->PatternOutlineColor);
  }
  else if (this->PatternInk == INK_COLOR)
  {
    style->SetOutlineColor(this->PatternInkColor);
  }
  if (this->PatternOutline != AS_IN_STYLE)
  {
    style->SetOutline(this->PatternOutline != 0);
    style->SetOutlineWidth(this->PatternOutlineWidth);
    style->SetOutlineWidthUnit(vtkPatternLayer::PIXELS);
    style->SetOutlineSilhouette(this->PatternOutlineSilhouette != 0);
    style->SetOutlineCreases(this->PatternOutlineCreases != 0);
    style->SetOutlineBorders(this->PatternOutlineBorders != 0);
    style->SetOutlineCreaseAngle(this->PatternOutlineCreaseAngle);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustMotion(vtkPatternStyle* style)
{
  if (this->PatternTracking != AS_IN_STYLE)
  {
    style->SetTrackingMode(this->PatternTracking);
  }
  if (this->PatternLockRotation != AS_IN_STYLE)
  {
    style->SetLockRotation(this->PatternLockRotation != 0);
  }
  if (this->PatternLockScale != AS_IN_STYLE)
  {
    style->SetLockScale(this->PatternLockScale != 0);
  }
  if (this->PatternWeights != AS_IN_STYLE)
  {
    style->SetWeightScheme(this->PatternWeights);
    style->SetFeatureSource(this->PatternFeatures);
    style->SetFeatureArrayName(this->PatternFeatureArrayName);
  }
  if (this->PatternSamplesPerPatch > 0)
  {
    style->SetSamplesPerPatch(this->PatternSamplesPerPatch);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustInk(vtkPatternLayer* layer)
{
  if (this->PatternInk != AS_IN_STYLE)
  {
    layer->SetColorSource(
      this->PatternInk == INK_COLOR ? vtkPatternLayer::INK : vtkPatternLayer::SURFACE);
    layer->SetColor(this->PatternInkColor);
  }
  layer->SetOpacity(layer->GetOpacity() * this->PatternInkOpacity);
  if (this->PatternBlendMode != AS_IN_STYLE)
  {
    layer->SetBlendMode(this->PatternBlendMode);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustTone(vtkPatternTone* tone)
{
  if (this->PatternTone != AS_IN_STYLE)
  {
    this->AdjustSource(tone);
  }
  if (this->PatternToneInvert != AS_IN_STYLE)
  {
    tone->SetInvert(this->PatternToneInvert != 0);
  }
  tone->SetGamma(tone->GetGamma() * this->PatternToneGamma);
  if (this->PatternToneRemap != AS_IN_STYLE)
  {
    tone->SetRemap(this->PatternToneRemap);
    tone->SetSteps(this->PatternToneSteps);
    tone->SetRemapRange(this->PatternToneRemapRange);
  }
  tone->SetBlackGeneration(tone->GetBlackGeneration() * this->PatternBlackGeneration);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustSource(vtkPatternTone* tone)
{
  tone->SetSource(this->PatternTone);
  const double low = this->PatternToneRange[0];
  const double high = this->PatternToneRange[1];
  tone->SetArrayName(this->PatternToneArrayName.c_str());
  tone->SetArrayAssociation(this->PatternToneAssociation == vtkDataObject::FIELD_ASSOCIATION_CELLS
      ? vtkPatternTone::CELLS
      : vtkPatternTone::POINTS);
  tone->SetComponent(this->PatternToneComponent);
  tone->SetRange(low, low != high ? high : low + std::max(1.0, std::abs(low)));
  tone->SetConstant(this->PatternToneConstant);
  tone->SetLightIndex(this->PatternTone == vtkPatternTone::HIGHLIGHT ? this->PatternHighlightLight
                                                                     : this->PatternToneLight);
  tone->SetHighlightPower(this->PatternHighlightPower);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustMarks(vtkImagePatternLayer* layer, vtkImageData* picture)
{
  this->AdjustKind(layer, picture);
  layer->SetSize(layer->GetSize() * this->PatternScale);
  layer->SetAngle(WithinTurn(layer->GetAngle() + this->PatternAngle));
  layer->SetIrregularity(layer->GetIrregularity() + this->PatternIrregularity);
  if (this->PatternDensities > 0)
  {
    layer->SetDensities(this->PatternDensities);
  }
  this->AdjustBrush(layer);
  this->AdjustPaperGrain(layer);
  if (this->PatternToneCorrection != AS_IN_STYLE)
  {
    layer->SetToneCorrection(this->PatternToneCorrection);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustKind(vtkImagePatternLayer* layer, vtkImageData* picture)
{
  if (picture)
  {
    layer->SetPattern(vtkImagePatternLayer::IMAGE);
    layer->SetImage(picture);
    layer->SetImageFileName(this->PatternImageFile.c_str());
    layer->SetSize(picture->GetDimensions()[0]);
    layer->SetSizeUnit(vtkPatternLayer::PIXELS);
    layer->SetAngle(0.0);
  }
  else if (this->PatternKind != AS_IN_STYLE && this->PatternKind != vtkImagePatternLayer::IMAGE)
  {
    layer->SetPattern(this->PatternKind);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustBrush(vtkImagePatternLayer* layer)
{
  if (this->PatternBrush != AS_IN_STYLE)
  {
    layer->SetDabLength(this->PatternDabLength);
    layer->SetDabJitter(this->PatternDabJitter);
    layer->SetDabDensity(this->PatternDabDensity);
    layer->SetBristles(this->PatternBristles);
    layer->SetBump(this->PatternBump);
    layer->SetColorVariation(this->PatternColorVariation);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustPaperGrain(vtkImagePatternLayer* layer)
{
  if (this->PatternPaperGrain != AS_IN_STYLE)
  {
    layer->SetPaperContrast(this->PatternPaperGrain != 0 ? this->PatternPaperContrast : 0.0);
  }
  layer->SetPaperSize(layer->GetPaperSize() * this->PatternPaperScale);
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustMarksMotion(vtkImagePatternLayer* layer)
{
  if (this->PatternMotion != AS_IN_STYLE)
  {
    layer->SetMotion(this->PatternMotion);
    layer->SetSurfacePeriod(this->PatternSurfacePeriod);
  }
  if (this->PatternTransition != AS_IN_STYLE)
  {
    layer->SetTransition(this->PatternTransition);
  }
  if (this->PatternPace != AS_IN_STYLE)
  {
    layer->SetPace(this->PatternPace);
  }
  if (this->PatternPatchPower < 1.0)
  {
    layer->SetPatchPower(this->PatternPatchPower);
  }
  if (this->PatternTransitionTime > 0.0)
  {
    layer->SetTransitionTime(this->PatternTransitionTime);
  }
  if (this->PatternTransitionScales != AS_IN_STYLE)
  {
    layer->SetLodStart(this->PatternTransitionRange[0]);
    layer->SetLodEnd(this->PatternTransitionRange[1]);
  }
}

//------------------------------------------------------------------------------
void vtkPatternRepresentation::AdjustNoise(vtkNoiseLayer* layer)
{
  layer->SetSize(layer->GetSize() * this->PatternScale);
  layer->SetAngle(WithinTurn(layer->GetAngle() + this->PatternAngle));
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> vtkPatternRepresentation::ReadPicture()
{
  const bool wanted = this->PatternKind == vtkImagePatternLayer::IMAGE;
  const std::string fileName = wanted ? this->PatternImageFile : std::string();
  if (this->PictureFile->IsNew(fileName))
  {
    vtkNew<vtkImagePatternLayer> reader;
    const bool read = !fileName.empty() && reader->ReadImage(fileName);
    this->Picture = read ? reader->GetImage() : nullptr;
  }
  return this->Picture;
}
