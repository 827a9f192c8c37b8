// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// What the command lines of the programs share: the form of options and the usual values.

#ifndef OptionParsing_h
#define OptionParsing_h

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace hachure::program
{
/// Pixels along one side that every OpenGL of interest can draw into.
constexpr int LargestSide = 16384;

/// Of options that take a value, as "--name value" or "--name=value".
using ValueOptions =
  std::map<std::string, std::function<void(const std::string& option, const std::string& value)>>;
using PlainOptions = std::map<std::string, std::function<void()>>;

struct OptionTable
{
  std::string program;
  std::string* input = nullptr; ///< gets the one argument that is no option
  ValueOptions values;
  PlainOptions flags;   ///< options without a value
  PlainOptions actions; ///< options after which no other argument is looked at
};

/// Gives every argument to its option; false after an action. Throws UserError, one line that names
/// the option and the value: unknown, without a value, none or two inputs.
bool readArguments(int argumentCount, char* const* arguments, const OptionTable& table);

/// Throws the UserError for a value that an option cannot take.
[[noreturn]] void refuse(
  const std::string& option, const std::string& value, const std::string& expected);

/// A finite number; nothing when the text is not all of one.
std::optional<double> toNumber(const std::string& text);
/// The numbers of "A,B,C"; empty when one is malformed.
std::vector<double> toNumbers(const std::string& text, char separator);
/// The numbers of "A:B" or "W x H"; nothing when there are others than two.
std::optional<std::array<double, 2>> toPair(const std::string& text, char separator);

// The following throw UserError.
int toInteger(const std::string& option, const std::string& text, int low, int high);
std::array<int, 2> toSize(const std::string& option, const std::string& text);
std::array<double, 2> toLight(const std::string& option, const std::string& text);
double toIsovalue(const std::string& option, const std::string& text);
std::string toAxis(const std::string& option, const std::string& text);
} // namespace hachure::program

#endif
