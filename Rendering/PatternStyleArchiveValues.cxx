// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

// Plain variables, lists and versions of a style or another description.

#include "PatternStyleArchive.h"

namespace
{

constexpr hachure::NumberRange anyVersion = { -1e9, 1e9 };

} // namespace

namespace hachure
{

//------------------------------------------------------------------------------
void StyleArchive::value(const char* key, double& variable, NumberRange range)
{
  if (!this->isReading())
  {
    this->writeNumber(key, variable);
  }
  else if (this->has(key))
  {
    variable = this->readNumber(key, range);
  }
}

//------------------------------------------------------------------------------
void StyleArchive::value(const char* key, int& variable, NumberRange range)
{
  if (!this->isReading())
  {
    this->writeInteger(key, variable);
  }
  else if (this->has(key))
  {
    variable = static_cast<int>(this->readInteger(key, range));
  }
}

//------------------------------------------------------------------------------
void StyleArchive::value(const char* key, std::string& variable)
{
  if (!this->isReading())
  {
    this->writeText(key, variable);
  }
  else if (this->has(key))
  {
    variable = this->readText(key);
  }
}

//------------------------------------------------------------------------------
void StyleArchive::value(const char* key, int& variable, const std::vector<std::string>& names)
{
  if (!this->isReading())
  {
    this->writeText(key, names[variable]);
  }
  else if (this->has(key))
  {
    variable = this->readChoice(key, names);
  }
}

//------------------------------------------------------------------------------
void StyleArchive::numbers(const char* key, double* variables, int count, NumberRange range)
{
  if (this->has(key))
  {
    this->numbers(key, this->node[key], variables, count, range);
  }
}

//------------------------------------------------------------------------------
void StyleArchive::require(const char* key)
{
  if (!this->has(key))
  {
    this->fail(key, "missing");
  }
}

//------------------------------------------------------------------------------
void StyleArchive::version(const char* key, int expected)
{
  if (!this->isReading())
  {
    this->writeInteger(key, expected);
    return;
  }
  const std::string number = std::to_string(expected);
  if (!this->has(key))
  {
    this->fail(key,
      "missing; a " + this->session.name + " states its version as \"" + key + "\": " + number);
  }
  const vtkTypeInt64 found = this->readInteger(key, anyVersion);
  if (found != expected)
  {
    this->fail(key, "version " + std::to_string(found) + " is unknown; expected " + number);
  }
}

//------------------------------------------------------------------------------
Json::Value& StyleArchive::startList(const char* key, std::size_t size)
{
  Json::Value& list = this->node[key];
  if (!this->isReading())
  {
    list = Json::arrayValue;
    list.resize(static_cast<Json::ArrayIndex>(size));
  }
  else if (!list.isArray())
  {
    this->fail(key, std::string("expected a list, got ") + typeName(list));
  }
  return list;
}

} // namespace hachure
