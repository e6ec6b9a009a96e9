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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_JSON_TEXT_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_JSON_TEXT_H

#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <cmath>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// readers take "-0" for the integer 0, and the sign is lost
inline std::string json_number(double value)
{
  return value == 0. ? std::string(std::signbit(value) ? "-0.0" : "0") : number_to_string(value);
}

// In quotes. What is no UTF-8 is not looked at.
inline std::string json_string(const std::string& text)
{
  std::string result = "\"";
  for (const char letter : text)
  {
    const unsigned char code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\')
      result += '\\';
    if (code >= 0x20)
      result += letter;
    else
      result += std::string("\\u00") + "01"[code / 16] + "0123456789abcdef"[code % 16];
  }
  return result + "\"";
}

// "[a,b,c]"
template <class Range, class To_text>
std::string json_array(const Range& range, const To_text& to_text, const char* separator = ",")
{
  std::string text = "[";
  for (const auto& value : range)
  {
    text += (text.size() == 1 ? "" : separator);
    text += to_text(value);
  }
  return text + "]";
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_JSON_TEXT_H
