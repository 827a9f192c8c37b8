// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef hachure_CallTests_h
#define hachure_CallTests_h

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

// What tests ask of any call of Core: its messages, its progress, and that it can be stopped.
namespace hachure
{

// What a call throws as std::invalid_argument.
inline std::string messageOf(const std::function<void()>& call)
{
  try
  {
    call();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "no error";
}

// Lets a call go on for so many reports of progress, whose fractions must rise and be 1 at most.
struct StoppingProgress
{
  int most;
  int calls = 0;
  double last = 0.0;

  bool report(double fraction)
  {
    EXPECT_GE(fraction, this->last);
    EXPECT_LE(fraction, 1.0);
    this->last = fraction;
    return ++this->calls < this->most;
  }
};

} // namespace hachure

#endif
