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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_RECOGNIZE_PIECES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_RECOGNIZE_PIECES_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>
#include <CGAL/Wireframe_extraction/internal/types/Typed_piece.h>

#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What the curves of a network are made of.
struct Recognized_pieces
{
  std::vector<Typed_piece> pieces;
  std::vector<Vector> vertices;          // those that were given, which may have moved, and then those of cuts
  std::vector<std::string> regularities; // a line for each kind and each curve that others agree with
  bool is_cancelled = false;             // and without pieces
};

// `vertices` are those of the network. A closed curve that passes smoothly through its vertex, at which it is alone, is
// cut loose from it. `proceed` is asked with the share that is done whether to go on.
Recognized_pieces recognize_pieces(const Skeleton_data& skeleton, const Extraction_options& options,
                                   const std::vector<Vector>& vertices, std::vector<Untyped_curve>& curves,
                                   const std::function<bool(double)>& proceed);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/types/recognize_pieces_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_RECOGNIZE_PIECES_H
