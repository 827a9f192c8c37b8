// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "JsonText.h"

#include <algorithm>
#include <memory>

namespace hachure
{

//------------------------------------------------------------------------------
Json::Value parseJson(const std::string& text, const std::string& name)
{
  Json::CharReaderBuilder builder;
  Json::CharReaderBuilder::strictMode(&builder.settings_);
  const std::unique_ptr<Json::CharReader> reader(builder.newCharReader());
  Json::Value root;
  std::string errors;
  bool valid = false;
  try
  {
    valid = reader->parse(text.data(), text.data() + text.size(), &root, &errors);
  }
  catch (const std::exception& error) // such as nesting without end
  {
    errors = error.what();
  }
  if (!valid)
  {
    std::replace(errors.begin(), errors.end(), '\n', ' ');
    throw StyleError(name + ": not valid JSON: " + errors);
  }
  return root;
}

//------------------------------------------------------------------------------
std::string jsonText(const Json::Value& root, int digits)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "  ";
  builder["precision"] = digits;
  return Json::writeString(builder, root) + "\n";
}

//------------------------------------------------------------------------------
const char* typeName(const Json::Value& value)
{
  switch (value.type())
  {
    case Json::nullValue:
      return "null";
    case Json::booleanValue:
      return "a truth value";
    case Json::stringValue:
      return "a text";
    case Json::arrayValue:
      return "a list";
    case Json::objectValue:
      return "an object";
    default:
      return "a number";
  }
}

} // namespace hachure
