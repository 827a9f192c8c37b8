// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "JsonReading.h"

#include "UserError.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace hachure::program
{
namespace
{
std::string firstLine(const std::string& text)
{
  std::string line = text;
  std::replace(line.begin(), line.end(), '\n', ' ');
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string numberText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}
} // namespace

//----------------------------------------------------------------------------
Json::Value readJsonFile(const std::string& path)
{
  errno = 0;
  std::ifstream file(path);
  if (!file || file.peek() == std::ifstream::traits_type::eof())
  {
    throw UserError(
      "cannot read '" + path + "': " + (errno ? std::strerror(errno) : "it is empty"));
  }
  Json::CharReaderBuilder builder;
  Json::CharReaderBuilder::strictMode(&builder.settings_);
  Json::Value root;
  std::string errors;
  if (!Json::parseFromStream(builder, file, &root, &errors))
  {
    throw UserError("cannot read '" + path + "': " + firstLine(errors));
  }
  return root;
}

//----------------------------------------------------------------------------
void JsonNode::fail(const std::string& reason) const
{
  throw UserError((this->path.empty() ? "the file" : this->path) + ": " + reason);
}

//----------------------------------------------------------------------------
JsonNode JsonNode::at(const std::string& key) const
{
  return { this->value[key], this->path.empty() ? key : this->path + "." + key };
}

//----------------------------------------------------------------------------
JsonNode JsonNode::at(Json::ArrayIndex index) const
{
  return { this->value[index], this->path + "[" + std::to_string(index) + "]" };
}

//----------------------------------------------------------------------------
void JsonNode::requireObject() const
{
  if (!this->value.isObject())
  {
    this->fail("expected an object");
  }
}

//----------------------------------------------------------------------------
void JsonNode::requireArray() const
{
  if (!this->value.isArray() || this->value.empty())
  {
    this->fail("expected a list with at least one element");
  }
}

//----------------------------------------------------------------------------
void JsonNode::allowOnly(std::initializer_list<const char*> keys) const
{
  this->requireObject();
  for (const std::string& name : this->value.getMemberNames())
  {
    if (std::find(keys.begin(), keys.end(), name) == keys.end())
    {
      this->at(name).fail("unknown key");
    }
  }
}

//----------------------------------------------------------------------------
double JsonNode::number(double least, double greatest) const
{
  if (!this->value.isNumeric())
  {
    this->fail("expected a number");
  }
  const double result = this->value.asDouble();
  if (!(result >= least && result <= greatest))
  {
    this->fail(
      numberText(result) + " is outside " + numberText(least) + " to " + numberText(greatest));
  }
  return result;
}

//----------------------------------------------------------------------------
double JsonNode::number(const char* key, double fallback, double least, double greatest) const
{
  return this->has(key) ? this->at(key).number(least, greatest) : fallback;
}

//----------------------------------------------------------------------------
std::array<double, 3> JsonNode::vector() const
{
  if (!this->value.isArray() || this->value.size() != 3)
  {
    this->fail("expected three numbers");
  }
  std::array<double, 3> result;
  for (Json::ArrayIndex i = 0; i < 3; ++i)
  {
    result[i] = this->at(i).number(-HUGE_VAL, HUGE_VAL);
  }
  return result;
}

//----------------------------------------------------------------------------
std::array<double, 2> JsonNode::pair() const
{
  if (!this->value.isArray() || this->value.size() != 2)
  {
    this->fail("expected two numbers");
  }
  return { this->at(0).number(-HUGE_VAL, HUGE_VAL), this->at(1).number(-HUGE_VAL, HUGE_VAL) };
}

//----------------------------------------------------------------------------
std::array<double, 3> JsonNode::color() const
{
  const std::string text = this->value.isString() ? this->value.asString() : "";
  if (text.size() != 7 || text[0] != '#' ||
    text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
  {
    this->fail("expected a colour \"#rrggbb\"");
  }
  std::array<double, 3> result;
  for (int i = 0; i < 3; ++i)
  {
    result[i] = std::stoi(text.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
  }
  return result;
}
} // namespace hachure::program
