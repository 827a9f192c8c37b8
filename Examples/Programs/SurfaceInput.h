// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// From a file of any supported type to surfaces that are ready to be drawn.

#ifndef SurfaceInput_h
#define SurfaceInput_h

#include <vtkDataObject.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace hachure::program
{
struct Surface
{
  vtkSmartPointer<vtkDataObject> data; ///< vtkPolyData, or vtkMultiBlockDataSet of vtkPolyData
  std::string up = "y";                ///< axis that points up in files of this type
  std::string front = "z";             ///< axis that points at the viewer
};

/// Reads the file, takes the isosurface or the outer surface, removes degenerate cells, adds
/// normals where there are none. Throws UserError: unreadable file, a volume without isovalue,
/// an isovalue outside the scalars, a surface without cells.
Surface readSurface(const std::string& path, const std::optional<double>& isovalue);

/// The polydata leaves of a surface, empty ones left out.
std::vector<vtkPolyData*> surfaceLeaves(vtkDataObject* surface);

/// A regular selection of the surface's points, enough to fit a view to within a pixel or two.
/// Throws UserError, which names the file, when none has finite coordinates.
std::vector<glm::dvec3> fitPoints(vtkDataObject* surface, const std::string& path);

/// An array of the surface as a tone.
struct ToneArray
{
  int component = 0;                          ///< -1: the magnitude of several components
  std::array<double, 2> range = { 0.0, 1.0 }; ///< finite values, low < high
};

/// The array over all leaves. Throws UserError with the names that do exist when no leaf has it.
ToneArray toneArray(vtkDataObject* surface, const std::string& name);
} // namespace hachure::program

#endif
