// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPatternLegendWindow.h"

#include "vtkHachureCompatibility.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPatternLegendWindow);

vtkPatternLegendWindow::vtkPatternLegendWindow()
{
  this->SetFrameBlitModeToNoBlit();
  this->SetUseOffScreenBuffers(true);
  this->SetMultiSamples(0);
  this->SetAlphaBitPlanes(1);
  this->SwapBuffersOff();
}

vtkPatternLegendWindow::~vtkPatternLegendWindow()
{
  if (this->Owner)
  {
    this->Finalize();
  }
}

void vtkPatternLegendWindow::MakeCurrent()
{
  if (this->Owner)
  {
    this->Owner->MakeCurrent();
  }
}

bool vtkPatternLegendWindow::IsCurrent()
{
  return this->Owner && this->Owner->IsCurrent();
}

// The owner has loaded the functions of OpenGL.
void vtkPatternLegendWindow::OpenGLInitContext()
{
#if !__has_include("vtk_glad.h")
  this->GlewInitValid = true;
  this->Initialized = true;
#endif
  this->Superclass::OpenGLInitContext();
}
