// SPDX-FileCopyrightText: Hachure contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PatternStyleArchive_h
#define PatternStyleArchive_h

// A style is described once, by functions that list its parameters; an archive runs such a
// description in either direction. Reading: a missing key keeps the object's value, a present key
// is checked and set, and a key that the description does not list is an error. Writing: every
// listed key is stored. What is written therefore reads back to the same values.

#include "JsonText.h"
#include "vtkImageData.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtk_jsoncpp.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

namespace hachure
{

/** Least and greatest value of a parameter, both allowed. */
struct NumberRange
{
  double least;
  double greatest;
};

constexpr NumberRange anyNumber = { -std::numeric_limits<double>::max(),
  std::numeric_limits<double>::max() };

/** What all parts of one style share while it is read or written. */
struct StyleSession
{
  bool reading = true;
  std::string name = "style"; // what messages about the whole call it
  std::string folder;         // names of files in the style are relative to it
  double dotsPerInch = 96.0;  // of every length in millimetres
  std::string dotsPerInchKey; // what stated it first when reading; empty when nothing did
  int digits = 15;            // decimal digits that give back every number written so far
  // Copying: what is written is read by another object of the same program. Objects are handed over
  // as they are instead of the files that they came from, and numbers may be any.
  bool copying = false;
  std::vector<vtkSmartPointer<vtkObject>> objects = {};
};

class StyleArchive
{
public:
  StyleArchive(StyleSession& session, Json::Value& node, std::string path);

  bool isReading() const { return this->session.reading; }
  StyleSession& getSession() { return this->session; }

  /** Reading: whether the object has the key. Writing: true. Either way the key is known. */
  bool has(const char* key);
  /** Path of a key, as "layers[0].ink.color". */
  std::string pathOf(const std::string& key) const;
  [[noreturn]] void fail(const std::string& key, const std::string& reason) const;

  template <class Object, class Get, class Set>
  void number(const char* key, Object* object, Get get, Set set, NumberRange range)
  {
    if (!this->isReading())
    {
      this->writeNumber(key, (object->*get)());
    }
    else if (this->has(key))
    {
      (object->*set)(this->readNumber(key, range));
    }
  }

  template <class Object, class Get, class Set>
  void integer(const char* key, Object* object, Get get, Set set, NumberRange range)
  {
    using Value = decltype((object->*get)());
    if (!this->isReading())
    {
      this->writeInteger(key, (object->*get)());
    }
    else if (this->has(key))
    {
      (object->*set)(static_cast<Value>(this->readInteger(key, range)));
    }
  }

  template <class Object, class Get, class Set>
  void boolean(const char* key, Object* object, Get get, Set set)
  {
    if (!this->isReading())
    {
      this->writeBoolean(key, (object->*get)());
    }
    else if (this->has(key))
    {
      (object->*set)(this->readBoolean(key));
    }
  }

  template <class Object, class Get, class Set>
  void text(const char* key, Object* object, Get get, Set set)
  {
    if (!this->isReading())
    {
      this->writeText(key, (object->*get)());
    }
    else if (this->has(key))
    {
      (object->*set)(this->readText(key).c_str());
    }
  }

  /** An enumeration; names[value] is the text that stands for a value. */
  template <class Object, class Get, class Set>
  void choice(
    const char* key, Object* object, Get get, Set set, const std::vector<std::string>& names)
  {
    if (!this->isReading())
    {
      this->writeText(key, names[(object->*get)()]);
    }
    else if (this->has(key))
    {
      (object->*set)(this->readChoice(key, names));
    }
  }

  /** {"px": 8} or {"mm": 0.6, "dpi": 300}; unit 0 is pixels, 1 is millimetres. */
  template <class Object, class Get, class Set, class GetUnit, class SetUnit>
  void length(const char* key, Object* object, Get get, Set set, GetUnit getUnit, SetUnit setUnit,
    NumberRange range)
  {
    if (!this->isReading())
    {
      this->writeLength(key, (object->*get)(), (object->*getUnit)());
    }
    else if (this->has(key))
    {
      int unit = 0;
      (object->*set)(this->readLength(key, range, unit));
      (object->*setUnit)(unit);
    }
  }

  /** "#rrggbb" in sRGB; a colour that 8 bits cannot hold is an array of three numbers. */
  template <class Object>
  void color(const char* key, Object* object, double* (Object::*get)(),
    void (Object::*set)(double, double, double))
  {
    if (!this->isReading())
    {
      this->writeColor(key, (object->*get)());
    }
    else if (this->has(key))
    {
      double color[3];
      this->readColor(key, color);
      (object->*set)(color[0], color[1], color[2]);
    }
  }

  /** Two finite numbers, each in a range. */
  template <class Object>
  void pair(const char* key, Object* object, double* (Object::*get)(),
    void (Object::*set)(double, double), NumberRange range = anyNumber)
  {
    if (!this->isReading())
    {
      this->writeNumbers(key, (object->*get)(), 2);
    }
    else if (this->has(key))
    {
      double values[2];
      this->readNumbers(key, values, 2, range);
      (object->*set)(values[0], values[1]);
    }
  }

  ///@{
  /** The same of plain variables. An enumeration: names[value] is the text that stands for it. */
  void value(const char* key, double& variable, NumberRange range = anyNumber);
  void value(const char* key, int& variable, NumberRange range);
  void value(const char* key, std::string& variable);
  void value(const char* key, int& variable, const std::vector<std::string>& names);
  template <std::size_t Size>
  void value(const char* key, std::array<double, Size>& variable, NumberRange range = anyNumber)
  {
    this->numbers(key, variable.data(), Size, range);
  }
  template <std::size_t Size>
  void value(
    const char* key, std::vector<std::array<double, Size>>& variable, NumberRange range = anyNumber)
  {
    if (this->has(key))
    {
      Json::Value& items = this->startList(key, variable.size());
      variable.resize(items.size());
      for (Json::ArrayIndex i = 0; i < items.size(); ++i)
      {
        const std::string item = key + ("[" + std::to_string(i) + "]");
        this->numbers(item, items[i], variable[i].data(), Size, range);
      }
    }
  }
  void numbers(const char* key, double* variables, int count, NumberRange range = anyNumber);
  ///@}

  /** Reading: fails where the object does not have the key. */
  void require(const char* key);

  /** The version of the format, which must be there and be this one. */
  void version(const char* key, int expected);

  /** A list of objects; body gets the archive of each and the element that it describes. */
  template <class Element, class Body>
  void list(const char* key, std::vector<Element>& elements, Body&& body)
  {
    if (!this->has(key))
    {
      return;
    }
    Json::Value& items = this->startList(key, elements.size());
    elements.resize(items.size());
    for (Json::ArrayIndex i = 0; i < items.size(); ++i)
    {
      StyleArchive inner(
        this->session, items[i], this->pathOf(key) + ("[" + std::to_string(i) + "]"));
      inner.describe([&](StyleArchive& item) { body(item, elements[i]); });
    }
  }

  ///@{
  /** The name of a file, which in a style is relative to its folder; absolute here. */
  std::string readFileName(const char* key);
  void writeFileName(const char* key, const std::string& fileName);
  ///@}

  /** The name of a picture file, which is read; an image without a file cannot be written. Returns
   * whether the image or its name has become another one. */
  bool imageFile(const char* key, vtkSmartPointer<vtkImageData>& image, std::string& imageFileName);

  /** Copying: an object and its file. Returns whether either has become another one. */
  template <class Object>
  bool handOver(const char* key, vtkSmartPointer<Object>& object, std::string& fileName)
  {
    StyleSession& shared = this->session;
    const vtkSmartPointer<Object> known = object;
    const std::string knownName = fileName;
    this->group(key,
      [&](StyleArchive& inner)
      {
        int index = static_cast<int>(shared.objects.size());
        if (!shared.reading)
        {
          shared.objects.emplace_back(object);
        }
        inner.value("object", index, { 0.0, static_cast<double>(shared.objects.size()) });
        inner.value("file", fileName);
        object = Object::SafeDownCast(shared.objects[static_cast<std::size_t>(index)]);
      });
    return object != known || fileName != knownName;
  }

  /** An object inside this one; body gets the archive of that object. */
  template <class Body>
  void group(const char* key, Body&& body)
  {
    if (!this->has(key))
    {
      return;
    }
    StyleArchive inner(this->session, this->node[key], this->pathOf(key));
    inner.describe(body);
  }

  /** Runs a description on this object and refuses the keys that it did not list. */
  template <class Body>
  void describe(Body&& body)
  {
    this->requireObject();
    body(*this);
    this->refuseUnknownKeys();
  }

  vtkTypeInt64 readInteger(const char* key, NumberRange range);
  std::string readText(const char* key);
  void writeInteger(const char* key, vtkTypeInt64 value);
  void writeText(const char* key, const std::string& value);
  /** The dots per inch of lengths in millimetres, as a parameter of its own. */
  void resolution(const char* key);

private:
  Json::Value& startList(const char* key, std::size_t size);
  void numbers(
    const std::string& key, Json::Value& list, double* variables, int count, NumberRange range);
  double readNumber(const char* key, NumberRange range);
  double checkNumber(const std::string& key, const Json::Value& value, NumberRange range) const;
  void writeNumber(const char* key, double value);
  bool readBoolean(const char* key);
  int readChoice(const char* key, const std::vector<std::string>& names);
  double readLength(const char* key, NumberRange range, int& unit);
  void readNumbers(const char* key, double* values, int count, NumberRange range);
  void readColor(const char* key, double* color);
  void writeBoolean(const char* key, bool value);
  void writeLength(const char* key, double value, int unit);
  void writeNumbers(const char* key, const double* values, int count);
  void writeColor(const char* key, const double* color);
  Json::Value encodeNumber(const std::string& key, double value);
  void stateDotsPerInch(const std::string& key, double value);
  void requireObject();
  void refuseUnknownKeys() const;

  StyleSession& session;
  Json::Value& node;
  std::string path;
  std::vector<std::string> knownKeys;
};

} // namespace hachure

#endif
