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

#ifndef CASE_MAKER_CASE_ERROR_H
#define CASE_MAKER_CASE_ERROR_H

#include <stdexcept>
#include <string>

namespace Case_maker {

/// Exit codes of the programs that make cases, those of all programs of this project.
enum Exit_code
{
  SUCCESS = 0,
  INTERNAL_ERROR = 1,
  USAGE_ERROR = 2,
  BAD_INPUT = 3,
  NO_SHARP_CURVE = 4
};

/// Why a case cannot be made, in words for who asked for it.
class Case_error : public std::runtime_error
{
public:
  Case_error(Exit_code code, const std::string& text) : std::runtime_error(text), m_code(code) {}

  Exit_code exit_code() const { return m_code; }

private:
  Exit_code m_code;
};

/// returns the error of a bad file.
inline Case_error bad_input(const std::string& text) { return Case_error(BAD_INPUT, text); }

/// returns the error at a line of a file.
inline Case_error bad_input(const std::string& file, std::size_t line, const std::string& text)
{
  return bad_input(file + ":" + std::to_string(line) + ": " + text);
}

/// A case that is left out because the options say so; no error.
struct Case_skipped : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

} // namespace Case_maker

#endif // CASE_MAKER_CASE_ERROR_H
