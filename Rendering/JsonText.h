// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef JsonText_h
#define JsonText_h

#include "vtk_jsoncpp.h"

#include <stdexcept>
#include <string>

namespace hachure
{

/** A style that cannot be read or written; the text is "path in the style: reason". */
class StyleError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** The value of a JSON text; throws StyleError, whose text starts with the name of the whole. */
Json::Value parseJson(const std::string& text, const std::string& name);

/** JSON text with numbers of so many digits. */
std::string jsonText(const Json::Value& root, int digits);

/** What a value is, as messages call it: "a list". */
const char* typeName(const Json::Value& value);

} // namespace hachure

#endif
