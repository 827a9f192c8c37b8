// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the classic stipples on an object remember in one renderer: how far each has grown.
 */
#ifndef vtkPatternStippleHistory_h
#define vtkPatternStippleHistory_h

#include "StippleEdgeTest.h"
#include "vtkSmartPointer.h"

#include <map>
#include <memory>
#include <vector>

class vtkPatternStyle;
class vtkStippleLayer;

class vtkPatternStippleHistory
{
public:
  /// When stipples are drawn.
  struct Moment
  {
    unsigned long Frame; // the first drawing of a frame advances what is remembered
    bool LookOn;         // this one does not: it draws what an advance would give
  };
  /// The stipples of a layer that are drawn. Those of another set than before, and those that were
  /// not seen, have their full size at once.
  void Draw(vtkStippleLayer* layer, const std::shared_ptr<hachure::StippleEdges>& edges,
    const hachure::StippleEdgeTest& test, const Moment& moment,
    std::vector<hachure::DrawnStipple>& drawn);

  /// Forgets layers that a style does not have.
  void Keep(vtkPatternStyle* style);
  void Forget() { this->Layers.clear(); }

private:
  struct Memory
  {
    std::shared_ptr<hachure::StippleEdges> Edges; // that were drawn last
    std::vector<float> Before, After;             // their sizes, before and after the last advance
    unsigned long Frame = 0;                      // of that advance
  };
  std::map<vtkSmartPointer<vtkStippleLayer>, Memory> Layers;
};

#endif
// VTK-HeaderTest-Exclude: vtkPatternStippleHistory.h
