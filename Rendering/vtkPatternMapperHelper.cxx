// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternMapperHelper.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLCellToVTKCellMap.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPatternMapper.h"
#include "vtkPatternPatches.h"
#include "vtkPatternTone.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSelection.h"
#include "vtkShaderProgram.h"
#include "vtkSurfacePart.h"
#include "vtkTextureObject.h"

#include <algorithm>

vtkStandardNewMacro(vtkPatternMapperHelper);

namespace
{
bool IsSurface(int primitive)
{
  return primitive == vtkOpenGLPolyDataMapper::PrimitiveTris ||
    primitive == vtkOpenGLPolyDataMapper::PrimitiveTriStrips;
}

bool IsArray(const vtkPatternToneChannel& channel, bool onCells)
{
  return channel.Source == vtkPatternTone::ARRAY && channel.OnCells == onCells;
}
} // namespace

#ifdef VTK_PATTERN_MAPPER_HAS_DELEGATOR
vtkStandardNewMacro(vtkPatternMapperDelegator);

vtkPatternMapperDelegator::vtkPatternMapperDelegator()
{
  this->GLDelegate = vtkPatternMapperHelper::New();
  this->Delegate.TakeReference(this->GLDelegate);
}
#endif

vtkPatternMapper* vtkPatternMapperHelper::GetMapper()
{
  return vtkPatternMapper::SafeDownCast(this->Parent);
}

void vtkPatternMapperHelper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor)
{
  const vtkPatternMapper::DrawStage stage = this->GetMapper()->GetDrawStage();
  if (stage == vtkPatternMapper::DrawStage::Stock)
  {
    this->Superclass::RenderPieceDraw(renderer, actor);
    return;
  }
  const bool surfaces = stage == vtkPatternMapper::DrawStage::Surfaces;
  this->CurrentSelector = nullptr;
  this->PrimitiveIDOffset = 0;
  const int representation = actor->GetProperty()->GetRepresentation();
  for (int i = PrimitiveStart; i < PrimitiveEnd; ++i)
  {
    if (IsSurface(i) == surfaces)
    {
      this->DrawingVertices = i > PrimitiveTriStrips;
      this->DrawingSelection = false;
      this->DrawIBO(
        renderer, actor, i, this->Primitives[i], this->GetOpenGLMode(representation, i), 0);
    }
  }
  if (!surfaces)
  {
    this->DrawSelection(renderer, actor);
  }
}

void vtkPatternMapperHelper::DrawSelection(vtkRenderer* renderer, vtkActor* actor)
{
  vtkSelection* selection = this->Parent->GetSelection();
  if (!selection || selection->GetNumberOfNodes() == 0)
  {
    return;
  }
  constexpr int selectionPointSize = 5; // as VTK draws it
  for (int i = PrimitiveStart; i <= PrimitiveTriStrips; ++i)
  {
    this->DrawingSelection = true;
    this->DrawIBO(renderer, actor, i, this->SelectionPrimitives[i],
      this->GetOpenGLMode(this->SelectionType, i), selectionPointSize);
  }
}

vtkPatternMapperHelper::~vtkPatternMapperHelper()
{
  if (vtkPatternMapper* mapper = this->GetMapper())
  {
    mapper->GetPatchRecords().Forget(this);
  }
}

std::vector<std::pair<std::string, vtkPatternNumberBuffer*>> vtkPatternMapperHelper::NumberBuffers()
{
  std::vector<std::pair<std::string, vtkPatternNumberBuffer*>> buffers = { { "hachurePatchOfVertex",
                                                                             &this->PatchOfVertex },
    { "hachurePatchRecords", &this->PatchRecords.Shapes },
    { "hachurePatchWeights", &this->PatchRecords.Weights },
    { "hachurePrimitiveIds", &this->PrimitiveIds }, { "hachureRunOfVertex", &this->RunOfVertex } };
  for (std::size_t i = 0; i < this->CellTones.size(); ++i)
  {
    buffers.emplace_back("hachureCellTone" + std::to_string(i), &this->CellTones[i]);
  }
  return buffers;
}

void vtkPatternMapperHelper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceStart(renderer, actor);
  const bool forward = this->GetMapper()->GetDrawStage() == vtkPatternMapper::DrawStage::Stock;
  if (forward && !this->WaitingRecords.shapes.empty())
  {
    this->PatchRecords.Upload(
      vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()), this->WaitingRecords);
    this->WaitingRecords = {};
  }
  for (const auto& named : this->NumberBuffers())
  {
    if (named.second->IsUsable())
    {
      named.second->Texture->Activate();
    }
  }
}

void vtkPatternMapperHelper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  for (const auto& named : this->NumberBuffers())
  {
    if (named.second->IsUsable())
    {
      named.second->Texture->Deactivate();
    }
  }
  this->Superclass::RenderPieceFinish(renderer, actor);
}

void vtkPatternMapperHelper::SetMapperShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetMapperShaderParameters(cellBO, renderer, actor);
  this->SetCoordinates(cellBO.Program);
  if (cellBO.Program->IsUniformUsed("hachurePatchBase"))
  {
    const bool forward = this->GetMapper()->GetDrawStage() == vtkPatternMapper::DrawStage::Stock;
    cellBO.Program->SetUniformf("hachurePatchBase",
      forward ? 0.0f : static_cast<float>(this->GetMapper()->GetPatchRecords().Base(this)));
  }
  for (const auto& named : this->NumberBuffers())
  {
    if (named.second->Texture && cellBO.Program->IsUniformUsed(named.first.c_str()))
    {
      cellBO.Program->SetUniformi(named.first.c_str(), named.second->Texture->GetTextureUnit());
    }
  }
}

void vtkPatternMapperHelper::SetShaderValues(
  vtkShaderProgram* program, vtkPatternHelperData* data, std::size_t firstPrimitive)
{
  this->Superclass::SetShaderValues(program, data, firstPrimitive);
  if (this->GetMapper()->GetHasSurroundings())
  {
    const bool surroundings = vtkSurfacePart::IsSurroundings(vtkPatternHelperPolyData(data));
    program->SetUniformf("hachureNotDrawn", surroundings ? 1.0f : 0.0f);
  }
}

void vtkPatternMapperHelper::BuildBufferObjects(vtkRenderer* renderer, vtkActor* actor)
{
  this->AppendedPoints.clear();
  this->Patches = {};
  this->VertexCount = 0;
  this->PrimitiveIds.Values.clear();
  this->RunOfVertex.Values.clear();
  for (PrimitiveNumbers& tone : this->CellTones)
  {
    tone.Values.clear();
  }
  this->Superclass::BuildBufferObjects(renderer, actor);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const auto upload = [window](PrimitiveNumbers& numbers, int components)
  {
    numbers.Upload(window, numbers.Values, components);
    numbers.Values = {};
  };
  for (PrimitiveNumbers& tone : this->CellTones)
  {
    upload(tone, 2);
  }
  upload(this->PrimitiveIds, 2);
  upload(this->RunOfVertex, 1);
  this->UploadPatches(window);
}

void vtkPatternMapperHelper::UploadPatches(vtkOpenGLRenderWindow* window)
{
  hachure::VertexPatches patches;
  if (this->GetMapper()->GetPatches().IsActive())
  {
    patches = hachure::patchesOfVertices(this->Patches, this->VertexCount);
    if (patches.records.shapes.empty())
    {
      patches.records.shapes.resize(hachure::recordShapes); // samplers must have a texture
      patches.records.weights.resize(hachure::recordWeights);
    }
  }
  this->Patches = {};
  this->PatchOfVertex.Upload(window, patches.vertices, 1);
  this->GetMapper()->GetPatchRecords().Store(this, patches.records);
  this->PatchRecords.Upload(window, {});
  this->WaitingRecords = std::move(patches.records);
}

void vtkPatternMapperHelper::AppendPointTones(vtkPolyData* poly)
{
  const auto& channels = this->GetMapper()->GetToneChannels().Get();
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    if (!IsArray(channels[i], false))
    {
      continue;
    }
    const std::vector<float> values = vtkPatternToneChannels::Values(channels[i], poly);
    vtkNew<vtkFloatArray> tones;
    tones->SetNumberOfComponents(2);
    tones->SetNumberOfTuples(poly->GetNumberOfPoints());
    std::copy(values.begin(), values.end(), tones->GetPointer(0));
    const std::string name = "hachureTone" + std::to_string(i) + "MC";
    this->VBOs->AppendDataArray(name.c_str(), tones, VTK_FLOAT);
  }
}

void vtkPatternMapperHelper::AppendTextureCoordinates(vtkPolyData* poly)
{
  if (!this->GetMapper()->GetUsesTextureCoordinates())
  {
    return;
  }
  // Every block has the attribute, also one without texture coordinates.
  vtkDataArray* given = poly->GetPointData()->GetTCoords();
  const vtkIdType count = poly->GetNumberOfPoints();
  const bool known = given && given->GetNumberOfTuples() == count;
  const int components = known ? std::min(given->GetNumberOfComponents(), 2) : 0;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  for (vtkIdType point = 0; point < count; ++point)
  {
    double tuple[3] = { 0.0, 0.0, known ? 1.0 : 0.0 };
    for (int i = 0; i < components; ++i)
    {
      tuple[i] = given->GetComponent(point, i);
    }
    coordinates->SetTuple(point, tuple);
  }
  this->VBOs->AppendDataArray("hachureTextureMC", coordinates, VTK_FLOAT);
}

void vtkPatternMapperHelper::SetCoordinates(vtkShaderProgram* program)
{
  if (!program->IsUniformUsed("hachureCoordScale"))
  {
    return;
  }
  float scale[3] = { 1.0f, 1.0f, 1.0f };
  float shift[3] = { 0.0f, 0.0f, 0.0f };
  vtkOpenGLVertexBufferObject* buffer = this->VBOs->GetVBO("vertexMC");
  if (buffer && buffer->GetCoordShiftAndScaleEnabled())
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      scale[i] = static_cast<float>(1.0 / buffer->GetScale()[i]);
      shift[i] = static_cast<float>(buffer->GetShift()[i]);
    }
  }
  program->SetUniform3f("hachureCoordScale", scale);
  program->SetUniform3f("hachureCoordShift", shift);
}

void vtkPatternMapperHelper::AppendCellTones(vtkPatternHelperData* data, int representation)
{
  vtkPolyData* poly = vtkPatternHelperPolyData(data);
  vtkCellArray* primitives[4] = { poly->GetVerts(), poly->GetLines(), poly->GetPolys(),
    poly->GetStrips() };
  const auto& channels = this->GetMapper()->GetToneChannels().Get();
  for (std::size_t i = 0; i < channels.size(); ++i)
  {
    if (!IsArray(channels[i], true))
    {
      continue;
    }
    data->CellCellMap->Update(primitives, representation, poly->GetPoints());
    const std::vector<float> values = vtkPatternToneChannels::Values(channels[i], poly);
    std::vector<float>& all = this->CellTones[i].Values;
    for (std::size_t primitive = 0; primitive < data->CellCellMap->GetSize(); ++primitive)
    {
      const auto cell = static_cast<std::size_t>(data->CellCellMap->GetValue(primitive));
      const bool known = 2 * cell + 1 < values.size();
      all.push_back(known ? values[2 * cell] : 0.0f);
      all.push_back(known ? values[2 * cell + 1] : 0.0f);
    }
  }
}

void vtkPatternMapperHelper::AppendPrimitiveIds(vtkPatternHelperData* data, int representation)
{
  if (!this->GetMapper()->GetUsesPrimitiveIds())
  {
    return;
  }
  vtkPolyData* poly = vtkPatternHelperPolyData(data);
  vtkCellArray* primitives[4] = { poly->GetVerts(), poly->GetLines(), poly->GetPolys(),
    poly->GetStrips() };
  data->CellCellMap->Update(primitives, representation, poly->GetPoints());
  std::vector<vtkIdType> cells;
  cells.reserve(data->CellCellMap->GetSize());
  for (std::size_t i = 0; i < data->CellCellMap->GetSize(); ++i)
  {
    cells.push_back(data->CellCellMap->GetValue(i));
  }
  this->GetMapper()->AppendPrimitiveIds(poly, cells, this->PrimitiveIds.Values);
}

// Where VTK has put the block's points, which other blocks may share.
void vtkPatternMapperHelper::AppendRuns(vtkPolyData* poly)
{
  if (!this->GetMapper()->GetUsesRuns())
  {
    return;
  }
  vtkIdType start = 0;
  vtkIdType total = 0;
  this->VBOs->ArrayExists("vertexMC", poly->GetPoints()->GetData(), start, total);
  std::vector<float> records;
  this->GetMapper()->AppendRuns(poly, records);
  std::vector<float>& all = this->RunOfVertex.Values;
  const auto first = static_cast<std::size_t>(start);
  all.resize(std::max(all.size(), first + records.size()));
  std::copy(records.begin(), records.end(), all.begin() + static_cast<std::ptrdiff_t>(first));
}

void vtkPatternMapperHelper::AppendPatches(vtkPatternHelperData* data, int representation)
{
  const vtkPatternPatches& patches = this->GetMapper()->GetPatches();
  if (!patches.IsActive())
  {
    return;
  }
  vtkPolyData* poly = vtkPatternHelperPolyData(data);
  vtkCellArray* primitives[4] = { poly->GetVerts(), poly->GetLines(), poly->GetPolys(),
    poly->GetStrips() };
  data->CellCellMap->Update(primitives, representation, poly->GetPoints());
  const vtkIdType* offsets = data->CellCellMap->GetPrimitiveOffsets();
  std::vector<vtkIdType> cells;
  for (auto i = static_cast<std::size_t>(offsets[2] - offsets[0]); i < data->CellCellMap->GetSize();
       ++i)
  {
    cells.push_back(data->CellCellMap->GetValue(i));
  }
  // Where VTK has put the block's points, which other blocks may share.
  vtkIdType start = 0;
  vtkIdType total = 0;
  this->VBOs->ArrayExists("vertexMC", poly->GetPoints()->GetData(), start, total);
  const auto firstVertex = static_cast<std::uint32_t>(start);
  patches.Append(poly, cells, firstVertex, this->GetMapper()->GetPatchOrigin(), this->Patches);
  this->VertexCount =
    std::max(this->VertexCount, firstVertex + static_cast<std::size_t>(poly->GetNumberOfPoints()));
}

void vtkPatternMapperHelper::AppendOneBufferObject(vtkRenderer* renderer, vtkActor* actor,
  vtkPatternHelperData* data, vtkIdType& offset, std::vector<unsigned char>& colors,
  std::vector<float>& normals)
{
  vtkPolyData* poly = vtkPatternHelperPolyData(data);
  const bool hasPoints = poly->GetPoints() && poly->GetNumberOfPoints() > 0;
  // Blocks that share points share VTK's vertices: their tones must be appended once, too.
  if (hasPoints && this->AppendedPoints.insert(poly->GetPoints()->GetData()).second)
  {
    this->AppendPointTones(poly);
    this->AppendTextureCoordinates(poly);
  }
  this->Superclass::AppendOneBufferObject(renderer, actor, data, offset, colors, normals);
  if (hasPoints)
  {
    this->AppendCellTones(data, actor->GetProperty()->GetRepresentation());
    this->AppendPrimitiveIds(data, actor->GetProperty()->GetRepresentation());
    this->AppendRuns(poly);
    this->AppendPatches(data, actor->GetProperty()->GetRepresentation());
  }
}

void vtkPatternMapperHelper::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const auto& named : this->NumberBuffers())
  {
    named.second->Release(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
