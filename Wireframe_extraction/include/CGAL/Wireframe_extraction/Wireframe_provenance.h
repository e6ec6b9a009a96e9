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

#ifndef CGAL_WIREFRAME_EXTRACTION_WIREFRAME_PROVENANCE_H
#define CGAL_WIREFRAME_EXTRACTION_WIREFRAME_PROVENANCE_H

#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgWireframeExtractionIO
/// What a file may tell of where its wireframe comes from, beside what the wireframe itself tells. Nothing is told of
/// what is empty. All text is UTF-8.
struct Wireframe_provenance
{
  std::string program;                                      ///< the program that made it, and its version
  std::vector<std::string> inputs;                          ///< the names of the files that it was made from
  std::vector<std::pair<std::string, std::string>> options; ///< what the program was told: names and values
  double noise_level = 0.; ///< the errors of the distances, in the unit of the cloud; 0 where they are not known
  std::vector<std::string> warnings;     ///< what the program warned of
  std::vector<std::string> regularities; ///< `Wireframe_extraction_report::regularities`
  std::string unit;                      ///< what one unit of the coordinates is, if it is known: `um`, `mm`, `cm`,
                                         ///< `m`, `in` or `ft`
};

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_PROVENANCE_H
