// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Keeps VTK's messages off the terminal, so that a failure is told once, in one line.

#ifndef ErrorCollector_h
#define ErrorCollector_h

#include <vtkSmartPointer.h>

#include <string>

class vtkOutputWindow;

namespace hachure::program
{
/// While one lives, VTK's errors are collected and its warnings dropped.
class ErrorCollector
{
public:
  ErrorCollector();
  ~ErrorCollector();
  ErrorCollector(const ErrorCollector&) = delete;
  ErrorCollector& operator=(const ErrorCollector&) = delete;

  /// The first error as one line without source file and address; empty when there was none.
  std::string first() const;

private:
  vtkSmartPointer<vtkOutputWindow> previous;
  vtkSmartPointer<vtkOutputWindow> window;
};
} // namespace hachure::program

#endif
