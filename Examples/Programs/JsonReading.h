// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause

/// Checked access to JSON: every failure is a UserError that starts with the path of the value.

#ifndef JsonReading_h
#define JsonReading_h

#include <vtk_jsoncpp.h>

#include <array>
#include <initializer_list>
#include <string>

namespace hachure::program
{
Json::Value readJsonFile(const std::string& path);

/// A value together with where it stands in the file.
struct JsonNode
{
  Json::Value value;
  std::string path; ///< "camera[1]"; empty for the whole file

  [[noreturn]] void fail(const std::string& reason) const;
  bool has(const char* key) const { return this->value.isMember(key); }
  JsonNode at(const std::string& key) const;
  JsonNode at(Json::ArrayIndex index) const;

  void requireObject() const;
  void requireArray() const; ///< with at least one element
  void allowOnly(std::initializer_list<const char*> keys) const;

  double number(double least, double greatest) const;
  double number(const char* key, double fallback, double least, double greatest) const;
  std::array<double, 3> vector() const;
  std::array<double, 2> pair() const;
  std::array<double, 3> color() const; ///< "#rrggbb"
};
} // namespace hachure::program

#endif
