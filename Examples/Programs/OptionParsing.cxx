// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "OptionParsing.h"

#include "UserError.h"

#include <cmath>
#include <cstdlib>

namespace hachure::program
{
namespace
{
constexpr int SmallestSide = 16;

void takeInput(const std::string& argument, const OptionTable& table)
{
  if (!table.input->empty())
  {
    throw UserError("two input files given: '" + *table.input + "' and '" + argument + "'");
  }
  *table.input = argument;
}
} // namespace

//----------------------------------------------------------------------------
void refuse(const std::string& option, const std::string& value, const std::string& expected)
{
  throw UserError("bad value '" + value + "' for " + option + ": expected " + expected);
}

//----------------------------------------------------------------------------
std::optional<double> toNumber(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value))
  {
    return std::nullopt;
  }
  return value;
}

//----------------------------------------------------------------------------
std::vector<double> toNumbers(const std::string& text, char separator)
{
  std::vector<double> numbers;
  std::size_t start = 0;
  while (start != std::string::npos)
  {
    const std::size_t end = text.find(separator, start);
    const auto number = toNumber(text.substr(start, end - start));
    if (!number)
    {
      return {};
    }
    numbers.push_back(*number);
    start = end == std::string::npos ? end : end + 1;
  }
  return numbers;
}

//----------------------------------------------------------------------------
std::optional<std::array<double, 2>> toPair(const std::string& text, char separator)
{
  const auto numbers = toNumbers(text, separator);
  if (numbers.size() != 2)
  {
    return std::nullopt;
  }
  return std::array<double, 2>{ numbers[0], numbers[1] };
}

//----------------------------------------------------------------------------
int toInteger(const std::string& option, const std::string& text, int low, int high)
{
  const auto value = toNumber(text);
  if (!value || *value != std::floor(*value) || *value < low || *value > high)
  {
    refuse(
      option, text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return static_cast<int>(*value);
}

//----------------------------------------------------------------------------
std::array<int, 2> toSize(const std::string& option, const std::string& text)
{
  const auto fits = [](double side)
  { return side == std::floor(side) && side >= SmallestSide && side <= LargestSide; };
  const auto pair = toPair(text, 'x');
  if (!pair || !fits((*pair)[0]) || !fits((*pair)[1]))
  {
    refuse(option, text,
      "WxH in whole pixels, each from " + std::to_string(SmallestSide) + " to " +
        std::to_string(LargestSide));
  }
  return { static_cast<int>((*pair)[0]), static_cast<int>((*pair)[1]) };
}

//----------------------------------------------------------------------------
std::array<double, 2> toLight(const std::string& option, const std::string& text)
{
  const auto pair = toPair(text, ',');
  if (!pair || std::abs((*pair)[1]) > 90.0)
  {
    refuse(option, text, "AZ,EL in degrees, EL from -90 to 90");
  }
  return *pair;
}

//----------------------------------------------------------------------------
double toIsovalue(const std::string& option, const std::string& text)
{
  const auto value = toNumber(text);
  if (!value)
  {
    refuse(option, text, "a number");
  }
  return *value;
}

//----------------------------------------------------------------------------
std::string toAxis(const std::string& option, const std::string& text)
{
  std::string axis = !text.empty() && text[0] == '+' ? text.substr(1) : text;
  for (const char* known : { "x", "y", "z", "-x", "-y", "-z" })
  {
    if (axis == known)
    {
      return axis;
    }
  }
  refuse(option, text, "one of x y z -x -y -z");
}

//----------------------------------------------------------------------------
bool readArguments(int argumentCount, char* const* arguments, const OptionTable& table)
{
  for (int i = 1; i < argumentCount; ++i)
  {
    const std::string argument = arguments[i];
    const auto action = table.actions.find(argument);
    if (action != table.actions.end())
    {
      action->second();
      return false;
    }
    const auto flag = table.flags.find(argument);
    if (flag != table.flags.end())
    {
      flag->second();
      continue;
    }
    if (argument.size() < 2 || argument[0] != '-')
    {
      takeInput(argument, table);
      continue;
    }
    const auto equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    const auto setter = table.values.find(name);
    if (setter == table.values.end())
    {
      throw UserError("unknown option '" + name + "'; try " + table.program + " --help");
    }
    if (equals == std::string::npos && i + 1 >= argumentCount)
    {
      throw UserError("option " + name + " needs a value");
    }
    setter->second(
      name, equals == std::string::npos ? arguments[++i] : argument.substr(equals + 1));
  }
  if (table.input->empty())
  {
    throw UserError("no input file given; try " + table.program + " --help");
  }
  return true;
}
} // namespace hachure::program
