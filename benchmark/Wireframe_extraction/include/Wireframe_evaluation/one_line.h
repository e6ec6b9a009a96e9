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

#ifndef WIREFRAME_EVALUATION_ONE_LINE_H
#define WIREFRAME_EVALUATION_ONE_LINE_H

#include <string>

namespace Wireframe_evaluation {

/// returns the text with blanks for control characters, so that it stays on one line of a terminal or a table.
inline std::string one_line(std::string text)
{
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || c == 127)
      c = ' ';
  return text;
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_ONE_LINE_H
