// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// What the user gave cannot be used: the program prints the one line and leaves with code 2.

#ifndef UserError_h
#define UserError_h

#include <stdexcept>

namespace hachure::program
{
class UserError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace hachure::program

#endif
