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

#ifndef CASE_MAKER_NUMBER_CHECK_H
#define CASE_MAKER_NUMBER_CHECK_H

#include <CLI/CLI.hpp>

#include <cmath>
#include <string>

namespace Case_maker {

/// returns a check of a length on the command line; CLI11's own ones let through what is not a number, and infinities.
inline CLI::Validator number_check(bool is_zero_allowed = false)
{
  return CLI::Validator(
    [is_zero_allowed](std::string& text) {
      double x = 0;
      const bool is_number = CLI::detail::lexical_cast(text, x) && std::isfinite(x);
      if (is_number && (x > 0 || (is_zero_allowed && x == 0)))
        return std::string();
      return "'" + text + "' is not a " + (is_zero_allowed ? "number of 0 or more" : "positive number");
    },
    "");
}

} // namespace Case_maker

#endif // CASE_MAKER_NUMBER_CHECK_H
