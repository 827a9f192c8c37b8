// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternStippleHistory.h"

#include "vtkPatternStyle.h"
#include "vtkStippleLayer.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

void vtkPatternStippleHistory::Draw(vtkStippleLayer* layer,
  const std::shared_ptr<hachure::StippleEdges>& edges, const hachure::StippleEdgeTest& test,
  const Moment& moment, std::vector<hachure::DrawnStipple>& drawn)
{
  Memory& memory = this->Layers[layer];
  if (memory.Edges != edges)
  {
    memory = {};
    memory.Edges = edges;
  }
  const bool another = memory.Frame != moment.Frame;
  const bool advances = another && !moment.LookOn;
  if (advances)
  {
    memory.Before = std::move(memory.After);
    memory.Frame = moment.Frame;
  }
  hachure::StippleSizes sizes;
  sizes.before = another && !advances ? memory.After : memory.Before;
  sizes.step = 1.0f / static_cast<float>(std::max(1, layer->GetGrowthFrames()));
  test.draw(*edges, sizes, drawn);
  if (advances)
  {
    memory.After = std::move(sizes.after);
  }
}

void vtkPatternStippleHistory::Keep(vtkPatternStyle* style)
{
  std::set<vtkPatternLayer*> kept;
  for (int i = 0; i < style->GetNumberOfLayers(); ++i)
  {
    kept.insert(style->GetLayer(i));
  }
  for (auto i = this->Layers.begin(); i != this->Layers.end();)
  {
    i = kept.count(i->first) > 0 ? std::next(i) : this->Layers.erase(i);
  }
}
