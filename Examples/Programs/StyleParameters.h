// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// The numbers and colours of a style that key frames may change, named as in its JSON file.

#ifndef StyleParameters_h
#define StyleParameters_h

#include <functional>
#include <string>

class vtkPatternStyle;

namespace hachure::program
{
struct StyleParameter
{
  enum class Kind
  {
    Number,
    Range, ///< two numbers
    Color  ///< three, from "#rrggbb"
  };
  Kind kind = Kind::Number;
  double least = 0.0; ///< of a number; both are allowed
  double greatest = 1.0;
  std::function<void(const double* values)> set;
};

/// Looks up a path such as "layers[0].field.size". Throws UserError that lists what there is.
StyleParameter styleParameter(vtkPatternStyle* style, const std::string& path);
} // namespace hachure::program

#endif
