// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "PatternStyleArchive.h"

#include "PatternImageFile.h"

#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace
{

constexpr hachure::NumberRange dotsPerInchRange = { 1.0, 10000.0 };

/** A number as people write it: 0.35, not 0.34999999999999998. */
std::string shortText(double value)
{
  char buffer[40];
  std::snprintf(buffer, sizeof(buffer), "%.10g", value);
  return buffer;
}

std::string joined(const std::vector<std::string>& names, const char* quote)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + (quote + name + quote);
  }
  return text;
}

/** Value of a digit of a colour, or -1. */
int hexadecimal(char digit)
{
  if (digit >= '0' && digit <= '9')
  {
    return digit - '0';
  }
  const char lower = static_cast<char>(digit | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/** Decimal digits that a number needs to be read back unchanged. */
int digitsOf(double value)
{
  for (int digits = 15; digits < 17; ++digits)
  {
    char buffer[40];
    std::snprintf(buffer, sizeof(buffer), "%.*g", digits, value);
    if (std::strtod(buffer, nullptr) == value)
    {
      return digits;
    }
  }
  return 17;
}

/** A file's name as seen from a folder; unchanged without a folder. */
std::string relativeName(const std::string& fileName, const std::string& folder)
{
  using vtksys::SystemTools;
  return folder.empty() ? fileName
                        : SystemTools::RelativePath(SystemTools::CollapseFullPath(folder),
                            SystemTools::CollapseFullPath(fileName));
}

} // namespace

namespace hachure
{

//------------------------------------------------------------------------------
StyleArchive::StyleArchive(StyleSession& sharedSession, Json::Value& object, std::string objectPath)
  : session(sharedSession)
  , node(object)
  , path(std::move(objectPath))
{
}

//------------------------------------------------------------------------------
bool StyleArchive::has(const char* key)
{
  this->knownKeys.emplace_back(key);
  return !this->isReading() || this->node.isMember(key);
}

//------------------------------------------------------------------------------
std::string StyleArchive::pathOf(const std::string& key) const
{
  if (this->path.empty() || key.empty())
  {
    return this->path + key;
  }
  return this->path + "." + key;
}

//------------------------------------------------------------------------------
void StyleArchive::fail(const std::string& key, const std::string& reason) const
{
  const std::string where = this->pathOf(key);
  throw StyleError((where.empty() ? this->session.name : where) + ": " + reason);
}

//------------------------------------------------------------------------------
void StyleArchive::requireObject()
{
  if (!this->isReading() && this->node.isNull())
  {
    this->node = Json::objectValue;
  }
  if (!this->node.isObject())
  {
    this->fail("", std::string("expected an object, got ") + typeName(this->node));
  }
}

//------------------------------------------------------------------------------
void StyleArchive::refuseUnknownKeys() const
{
  if (!this->isReading())
  {
    return;
  }
  for (const std::string& key : this->node.getMemberNames())
  {
    if (std::find(this->knownKeys.begin(), this->knownKeys.end(), key) == this->knownKeys.end())
    {
      this->fail(key, "unknown key; expected one of " + joined(this->knownKeys, ""));
    }
  }
}

//------------------------------------------------------------------------------
double StyleArchive::checkNumber(
  const std::string& key, const Json::Value& value, NumberRange range) const
{
  if (!value.isNumeric())
  {
    this->fail(key, std::string("expected a number, got ") + typeName(value));
  }
  const double number = value.asDouble();
  if (this->session.copying)
  {
    return number;
  }
  if (!(number >= range.least && number <= range.greatest))
  {
    this->fail(key,
      shortText(number) + " is out of range; expected " + shortText(range.least) + " to " +
        shortText(range.greatest));
  }
  return number;
}

//------------------------------------------------------------------------------
double StyleArchive::readNumber(const char* key, NumberRange range)
{
  return this->checkNumber(key, this->node[key], range);
}

//------------------------------------------------------------------------------
vtkTypeInt64 StyleArchive::readInteger(const char* key, NumberRange range)
{
  const double number = this->readNumber(key, range);
  if (number != std::floor(number))
  {
    this->fail(key, "expected a whole number, got " + shortText(number));
  }
  return static_cast<vtkTypeInt64>(number);
}

//------------------------------------------------------------------------------
bool StyleArchive::readBoolean(const char* key)
{
  const Json::Value& value = this->node[key];
  if (!value.isBool())
  {
    this->fail(key, std::string("expected true or false, got ") + typeName(value));
  }
  return value.asBool();
}

//------------------------------------------------------------------------------
std::string StyleArchive::readText(const char* key)
{
  const Json::Value& value = this->node[key];
  if (!value.isString())
  {
    this->fail(key, std::string("expected a text, got ") + typeName(value));
  }
  return value.asString();
}

//------------------------------------------------------------------------------
int StyleArchive::readChoice(const char* key, const std::vector<std::string>& names)
{
  const std::string name = this->readText(key);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
  {
    this->fail(key, "unknown \"" + name + "\"; expected one of " + joined(names, "\""));
  }
  return static_cast<int>(found - names.begin());
}

//------------------------------------------------------------------------------
double StyleArchive::readLength(const char* key, NumberRange range, int& unit)
{
  const Json::Value& value = this->node[key];
  if (!value.isObject() || value.isMember("px") == value.isMember("mm"))
  {
    this->fail(key, "expected a length such as {\"px\": 8} or {\"mm\": 0.6, \"dpi\": 300}");
  }
  double length = 0.0;
  this->group(key,
    [&](StyleArchive& inner)
    {
      unit = inner.has("mm") ? 1 : 0;
      inner.has("px");
      length = inner.readNumber(unit == 1 ? "mm" : "px", range);
      if (unit == 1 && inner.has("dpi"))
      {
        inner.stateDotsPerInch("dpi", inner.readNumber("dpi", dotsPerInchRange));
      }
    });
  return length;
}

//------------------------------------------------------------------------------
void StyleArchive::readNumbers(const char* key, double* values, int count, NumberRange range)
{
  this->numbers(key, this->node[key], values, count, range);
}

//------------------------------------------------------------------------------
void StyleArchive::readColor(const char* key, double* color)
{
  const Json::Value& value = this->node[key];
  if (value.isArray())
  {
    this->readNumbers(key, color, 3, { 0.0, 1.0 });
    return;
  }
  const std::string text = this->readText(key);
  bool valid = text.size() == 7 && text[0] == '#';
  for (int i = 0; valid && i < 3; ++i)
  {
    const int high = hexadecimal(text[1 + 2 * i]);
    const int low = hexadecimal(text[2 + 2 * i]);
    valid = high >= 0 && low >= 0;
    color[i] = (16 * high + low) / 255.0;
  }
  if (!valid)
  {
    this->fail(key, "expected a colour such as \"#1a2b3c\", got \"" + text + "\"");
  }
}

//------------------------------------------------------------------------------
Json::Value StyleArchive::encodeNumber(const std::string& key, double value)
{
  if (!std::isfinite(value) && !this->session.copying)
  {
    this->fail(key, "a number that is not finite cannot be written");
  }
  this->session.digits = std::max(this->session.digits, digitsOf(value));
  return value;
}

//------------------------------------------------------------------------------
void StyleArchive::writeNumber(const char* key, double value)
{
  this->node[key] = this->encodeNumber(key, value);
}

//------------------------------------------------------------------------------
void StyleArchive::writeInteger(const char* key, vtkTypeInt64 value)
{
  this->node[key] = static_cast<Json::Int64>(value);
}

//------------------------------------------------------------------------------
void StyleArchive::writeBoolean(const char* key, bool value)
{
  this->node[key] = value;
}

//------------------------------------------------------------------------------
void StyleArchive::writeText(const char* key, const std::string& value)
{
  this->node[key] = value;
}

//------------------------------------------------------------------------------
void StyleArchive::writeLength(const char* key, double value, int unit)
{
  Json::Value length(Json::objectValue);
  length[unit == 1 ? "mm" : "px"] = this->encodeNumber(key, value);
  if (unit == 1)
  {
    length["dpi"] = this->encodeNumber(key, this->session.dotsPerInch);
  }
  this->node[key] = length;
}

//------------------------------------------------------------------------------
void StyleArchive::numbers(
  const std::string& key, Json::Value& list, double* variables, int count, NumberRange range)
{
  if (!this->isReading())
  {
    list = Json::arrayValue;
    for (int i = 0; i < count; ++i)
    {
      list.append(this->encodeNumber(key, variables[i]));
    }
    return;
  }
  if (!list.isArray() || static_cast<int>(list.size()) != count)
  {
    this->fail(key, "expected a list of " + std::to_string(count) + " numbers");
  }
  for (int i = 0; i < count; ++i)
  {
    variables[i] = this->checkNumber(key + ("[" + std::to_string(i) + "]"), list[i], range);
  }
}

//------------------------------------------------------------------------------
void StyleArchive::writeNumbers(const char* key, const double* values, int count)
{
  std::vector<double> copy(values, values + count);
  this->numbers(key, this->node[key], copy.data(), count, anyNumber);
}

//------------------------------------------------------------------------------
void StyleArchive::writeColor(const char* key, const double* color)
{
  int bytes[3];
  bool exact = true;
  for (int i = 0; i < 3; ++i)
  {
    bytes[i] = static_cast<int>(std::lround(color[i] * 255.0));
    exact = exact && bytes[i] / 255.0 == color[i];
  }
  if (!exact)
  {
    this->writeNumbers(key, color, 3);
    return;
  }
  char text[32];
  std::snprintf(text, sizeof(text), "#%02x%02x%02x", bytes[0], bytes[1], bytes[2]);
  this->writeText(key, text);
}

//------------------------------------------------------------------------------
void StyleArchive::stateDotsPerInch(const std::string& key, double value)
{
  if (!this->session.dotsPerInchKey.empty() && value != this->session.dotsPerInch)
  {
    this->fail(key,
      shortText(value) + " differs from " + shortText(this->session.dotsPerInch) + " in " +
        this->session.dotsPerInchKey + "; a style has one resolution");
  }
  this->session.dotsPerInch = value;
  this->session.dotsPerInchKey = this->pathOf(key);
}

//------------------------------------------------------------------------------
void StyleArchive::resolution(const char* key)
{
  if (!this->isReading())
  {
    this->writeNumber(key, this->session.dotsPerInch);
  }
  else if (this->has(key))
  {
    this->stateDotsPerInch(key, this->readNumber(key, dotsPerInchRange));
  }
}

//------------------------------------------------------------------------------
std::string StyleArchive::readFileName(const char* key)
{
  const std::string fileName = this->readText(key);
  return this->session.folder.empty()
    ? fileName
    : vtksys::SystemTools::CollapseFullPath(fileName, this->session.folder);
}

//------------------------------------------------------------------------------
void StyleArchive::writeFileName(const char* key, const std::string& fileName)
{
  this->writeText(key, relativeName(fileName, this->session.folder));
}

//------------------------------------------------------------------------------
bool StyleArchive::imageFile(
  const char* key, vtkSmartPointer<vtkImageData>& image, std::string& imageFileName)
{
  if (this->session.copying)
  {
    return this->handOver(key, image, imageFileName);
  }
  if (!this->isReading())
  {
    if (image && imageFileName.empty())
    {
      this->fail(key, "the image has no file; save it and call SetImageFileName");
    }
    if (image)
    {
      this->writeFileName(key, imageFileName);
    }
    return false;
  }
  if (!this->has(key))
  {
    return false;
  }
  const std::string fileName = this->readFileName(key);
  try
  {
    image = readPatternImage(fileName);
    imageFileName = fileName;
  }
  catch (const std::runtime_error& error)
  {
    this->fail(key, error.what());
  }
  return true;
}

} // namespace hachure
