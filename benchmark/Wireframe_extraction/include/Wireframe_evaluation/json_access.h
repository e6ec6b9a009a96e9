// Copyright (c) 2026 The Wireframe_extraction authors.
// All rights reserved.
//
// This file is part of Wireframe_extraction, a package in the conventions of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Wireframe_extraction authors

#ifndef WIREFRAME_EVALUATION_JSON_ACCESS_H
#define WIREFRAME_EVALUATION_JSON_ACCESS_H

#include <Wireframe_evaluation/Polyline.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Wireframe_evaluation {

/// The content of a file is not what it should be; the text says in one line what is wrong, and where.
struct Format_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

namespace internal {

typedef nlohmann::json Json;

inline Json read_json(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw Format_error("cannot be opened");
  if (in.peek() == std::ifstream::traits_type::eof())
    throw Format_error(in.bad() ? "cannot be read; is it a folder?" : "is empty");
  Json document;
  try
  {
    document = Json::parse(in);
  }
  catch (const Json::exception& error)
  {
    // the text starts with the name of the exception in brackets
    const std::string text = error.what();
    const std::size_t end = text.find("] ");
    throw Format_error("is not JSON: " + (end == std::string::npos ? text : text.substr(end + 2)));
  }
  if (!document.is_object())
    throw Format_error("is not a JSON object");
  return document;
}

inline const Json& member(const Json& object, const char* key, const std::string& place)
{
  const auto it = object.find(key);
  if (it == object.end())
    throw Format_error(place + "there is no \"" + key + "\"");
  return *it;
}

inline const Json& array_member(const Json& object, const char* key, const std::string& place)
{
  const Json& result = member(object, key, place);
  if (!result.is_array())
    throw Format_error(place + "\"" + key + "\" is not a list");
  return result;
}

inline double number(const Json& value, const std::string& what)
{
  if (!value.is_number())
    throw Format_error(what + " is not a number");
  const double result = value.get<double>();
  if (!std::isfinite(result))
    throw Format_error(what + " is not finite");
  return result;
}

inline Point point(const Json& value, const std::string& what)
{
  if (!value.is_array() || value.size() != 3)
    throw Format_error(what + " is not a list of three numbers");
  return Point(number(value[0], what), number(value[1], what), number(value[2], what));
}

inline std::vector<double> numbers(const Json& object, const char* key, const std::string& place)
{
  std::vector<double> result;
  for (const Json& value : array_member(object, key, place))
    result.push_back(number(value, place + "number " + std::to_string(result.size()) + " of \"" + key + "\""));
  return result;
}

inline std::vector<Point> points(const Json& object, const char* key, const std::string& place)
{
  std::vector<Point> result;
  for (const Json& value : array_member(object, key, place))
    result.push_back(point(value, place + "point " + std::to_string(result.size()) + " of \"" + key + "\""));
  return result;
}

inline bool boolean(const Json& object, const char* key, const std::string& place)
{
  const auto it = object.find(key);
  if (it == object.end() || it->is_null())
    return false;
  if (!it->is_boolean())
    throw Format_error(place + "\"" + key + "\" is neither true nor false");
  return it->get<bool>();
}

inline std::string text(const Json& object, const char* key, const std::string& place)
{
  const auto it = object.find(key);
  if (it == object.end() || it->is_null())
    return std::string();
  if (!it->is_string())
    throw Format_error(place + "\"" + key + "\" is not a text");
  return it->get<std::string>();
}

inline bool has(const Json& object, const char* key)
{
  const auto it = object.find(key);
  return it != object.end() && !it->is_null();
}

} // namespace internal
} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_JSON_ACCESS_H
