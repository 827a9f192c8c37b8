// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws the blocks of a vtkPatternMapper that share a vertex layout: adds the tone arrays to VTK's
 * buffers, and draws either the surfaces or everything else.
 */
#ifndef vtkPatternMapperHelper_h
#define vtkPatternMapperHelper_h

#include "vtkHachureCompatibility.h"

#include "TrianglePatches.h"
#include "vtkPatternCompositeMapper.h"
#include "vtkPatternNumberBuffer.h"
#include "vtkPatternPatchRecords.h"
#include "vtkPatternToneChannels.h"
#include "vtkSmartPointer.h"

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkPatternMapper;
class vtkShaderProgram;

class vtkPatternMapperHelper : public vtkPatternHelperBase
{
public:
  static vtkPatternMapperHelper* New();
  vtkTypeMacro(vtkPatternMapperHelper, vtkPatternHelperBase);

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkPatternMapperHelper() = default;
  ~vtkPatternMapperHelper() override;

  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void SetShaderValues(
    vtkShaderProgram* program, vtkPatternHelperData* data, std::size_t firstPrimitive) override;
  void BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor) override;
  void AppendOneBufferObject(vtkRenderer* renderer, vtkActor* actor, vtkPatternHelperData* data,
    vtkIdType& offset, std::vector<unsigned char>& colors, std::vector<float>& normals) override;

private:
  struct PrimitiveNumbers : vtkPatternNumberBuffer
  {
    std::vector<float> Values; // while buffers are built
  };
  vtkPatternMapper* GetMapper();
  void DrawSelection(vtkRenderer* renderer, vtkActor* actor);
  void AppendPointTones(vtkPolyData* poly);
  void AppendTextureCoordinates(vtkPolyData* poly);
  void SetCoordinates(vtkShaderProgram* program);
  void AppendCellTones(vtkPatternHelperData* data, int representation);
  void AppendPrimitiveIds(vtkPatternHelperData* data, int representation);
  void AppendRuns(vtkPolyData* poly);
  void AppendPatches(vtkPatternHelperData* data, int representation);
  void UploadPatches(vtkOpenGLRenderWindow* window);
  std::vector<std::pair<std::string, vtkPatternNumberBuffer*>> NumberBuffers();

  std::array<PrimitiveNumbers, vtkPatternToneChannels::Maximum> CellTones;
  PrimitiveNumbers PrimitiveIds; // of noises on translucent surfaces
  PrimitiveNumbers RunOfVertex;
  hachure::TrianglePatches Patches; // while buffers are built
  std::size_t VertexCount = 0;      // of these
  vtkPatternNumberBuffer PatchOfVertex;
  vtkPatternPatchRecordBuffers PatchRecords; // for translucent surfaces alone
  hachure::PatchRecords WaitingRecords;      // not uploaded for them yet
  std::set<vtkDataArray*> AppendedPoints;
};

#ifdef VTK_PATTERN_MAPPER_HAS_DELEGATOR
/// Hands blocks that share a vertex layout from the mapper to a helper.
class vtkPatternMapperDelegator : public vtkOpenGLCompositePolyDataMapperDelegator
{
public:
  static vtkPatternMapperDelegator* New();
  vtkTypeMacro(vtkPatternMapperDelegator, vtkOpenGLCompositePolyDataMapperDelegator);

protected:
  vtkPatternMapperDelegator();
  ~vtkPatternMapperDelegator() override = default;
};
#endif

#endif
// VTK-HeaderTest-Exclude: vtkPatternMapperHelper.h
