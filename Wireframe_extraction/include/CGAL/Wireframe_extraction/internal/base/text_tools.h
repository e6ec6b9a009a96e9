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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_TEXT_TOOLS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_TEXT_TOOLS_H

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

inline bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

inline std::string_view trim(std::string_view text)
{
  while (!text.empty() && is_blank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back()))
    text.remove_suffix(1);
  return text;
}

inline bool starts_with(std::string_view text, std::string_view prefix)
{
  return text.substr(0, prefix.size()) == prefix;
}

// ASCII only, so that no locale has a say
inline std::string to_lower(std::string_view text)
{
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

// How many bytes the letter takes with which a text in UTF-8 begins; 0 if it begins with something else, or with what
// controls a terminal.
inline std::size_t size_of_letter(std::string_view text)
{
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) < 0x80)
    return byte(0) >= 32 && byte(0) < 127 ? 1 : 0;
  const std::size_t size = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < size)
    return 0;
  std::uint32_t letter = byte(0) & (0x7Fu >> size);
  for (std::size_t i = 1; i < size; ++i)
  {
    if ((byte(i) & 0xC0u) != 0x80u)
      return 0;
    letter = (letter << 6) | (byte(i) & 0x3Fu);
  }
  constexpr std::uint32_t first_of_three_bytes = 0x800, first_of_four_bytes = 0x10000, beyond_all = 0x110000,
                          beyond_controls = 0xA0;
  const bool is_short_enough = size < 3 || letter >= (size == 3 ? first_of_three_bytes : first_of_four_bytes);
  const bool is_half_of_a_pair = letter >= 0xD800 && letter < 0xE000; // of UTF-16
  return is_short_enough && letter >= beyond_controls && letter < beyond_all && !is_half_of_a_pair ? size : 0;
}

// Text of a file as it may stand in a message: short, and without bytes a terminal could choke on. Letters in UTF-8
// stay.
inline std::string printable(std::string_view text, std::size_t limit = 40)
{
  std::string result;
  for (std::size_t count = 0; count < limit && !text.empty(); ++count)
  {
    const std::size_t size = size_of_letter(text);
    result += size > 0 ? std::string(text.substr(0, size)) : "?";
    text.remove_prefix((std::max)(size, std::size_t(1)));
  }
  return result + (text.empty() ? "" : "...");
}

inline std::string quote(std::string_view text) { return "\"" + printable(text) + "\""; }

// the shortest text that reads back as the same double, with a point whatever the locale
inline std::string number_to_string(double value)
{
#if defined(__cpp_lib_to_chars)
  char digits[64];
  const std::to_chars_result result = std::to_chars(digits, digits + sizeof(digits), value);
  return std::string(digits, result.ptr);
#else
  std::ostringstream stream;
  stream.imbue(std::locale::classic());
  stream.precision(17);
  stream << value;
  return stream.str();
#endif
}

inline double out_of_range_value(std::string_view text)
{
  const std::size_t exponent = text.find_first_of("eE");
  const bool is_tiny = exponent != std::string_view::npos && exponent + 1 < text.size() && text[exponent + 1] == '-';
  return is_tiny ? 0. : std::numeric_limits<double>::infinity();
}

// Whether a text is what older programs of Windows write for what is not finite, such as 1.#QNAN, -1.#IND and 1.#INF00.
inline bool is_not_finite_on_windows(std::string_view text)
{
  if (!text.empty() && text[0] == '-')
    text.remove_prefix(1);
  if (!starts_with(text, "1.#"))
    return false;
  text.remove_prefix(3);
  while (!text.empty() && text.back() == '0')
    text.remove_suffix(1);
  for (const char* const name : {"qnan", "snan", "ind", "inf"})
    if (to_lower(text) == name)
      return true;
  return false;
}

// reads a number that takes the whole text; independent of the locale, "nan", "inf", "1.#QNAN" and the like are numbers
inline bool parse_number(std::string_view text, double& value)
{
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix(1);
  if (text.empty())
    return false;
  if (is_not_finite_on_windows(text))
  {
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  const char* const last = text.data() + text.size();
#if defined(__cpp_lib_to_chars)
  const std::from_chars_result result = std::from_chars(text.data(), last, value);
  if (result.ptr != last || result.ec == std::errc::invalid_argument)
    return false;
  if (result.ec == std::errc::result_out_of_range)
    value = out_of_range_value(text);
  return true;
#else
  const std::string lower = to_lower(text);
  if (lower == "nan" || lower == "-nan" || lower == "inf" || lower == "-inf")
  {
    value = std::numeric_limits<double>::infinity();
    return true;
  }
  std::istringstream stream(lower);
  stream.imbue(std::locale::classic());
  stream >> value;
  if (stream.fail() && std::abs(value) >= (std::numeric_limits<double>::max)())
  {
    value = out_of_range_value(text);
    stream.clear();
  }
  return !stream.fail() && stream.peek() == std::istringstream::traits_type::eof();
#endif
}

// reads a natural number that takes the whole text
template <class Unsigned>
bool parse_count(std::string_view text, Unsigned& value)
{
  const char* const last = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), last, value);
  return !text.empty() && result.ptr == last && result.ec == std::errc();
}

// splits at blanks
inline void split_at_blanks(std::string_view text, std::vector<std::string_view>& fields)
{
  fields.clear();
  std::size_t position = 0;
  while (position < text.size())
  {
    if (is_blank(text[position]))
    {
      ++position;
      continue;
    }
    const std::size_t begin = position;
    while (position < text.size() && !is_blank(text[position]))
      ++position;
    fields.push_back(text.substr(begin, position - begin));
  }
}

// splits at every separator; blanks around a field do not count, and neither does a separator at the end
inline void split_at(char separator, std::string_view text, std::vector<std::string_view>& fields)
{
  fields.clear();
  while (!text.empty())
  {
    const std::size_t end = text.find(separator);
    fields.push_back(trim(text.substr(0, end)));
    text = (end == std::string_view::npos) ? std::string_view() : text.substr(end + 1);
    if (trim(text).empty())
      return;
  }
}

// "a, b, c" or "(none)"
template <class Names>
std::string join(const Names& names)
{
  std::string text;
  for (const auto& name : names)
    text += (text.empty() ? "" : ", ") + printable(name);
  return text.empty() ? "(none)" : text;
}

// what is wrong with a file without a single byte, and what helps
inline const char* empty_file_text() { return "is empty; get a complete copy of the file"; }

// what is wrong with a text that is to be a number, and what helps
inline std::string no_number_text(std::string_view text)
{
  return (text.empty() ? std::string("empty") : quote(text) + ", no number")
    + (text.find(',') != std::string_view::npos ? "; decimals need a point, not a comma" : "; write a number there");
}

inline std::string plural(std::size_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_TEXT_TOOLS_H
