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

#ifndef CGAL_WIREFRAME_EXTRACTION_PARAMETERS_H
#define CGAL_WIREFRAME_EXTRACTION_PARAMETERS_H

#include <CGAL/Wireframe_extraction/policies.h>

#include <CGAL/Named_function_parameters.h>

#ifndef DOXYGEN_RUNNING // the manual lists a parameter at each function that takes it
#define CGAL_WIREFRAME_NP_LIST <CGAL/Wireframe_extraction/internal/options/parameters_interface.h>
#define CGAL_WIREFRAME_SHARED_NP_LIST <CGAL/Wireframe_extraction/internal/options/shared_parameters_interface.h>
#endif

namespace CGAL {
namespace Wireframe_extraction {

#ifndef DOXYGEN_RUNNING
namespace internal_np {

using namespace CGAL::internal_np;

#define CGAL_add_named_parameter(X, Y, Z) \
  enum X                                  \
  {                                       \
    Y                                     \
  };
#include CGAL_WIREFRAME_NP_LIST
#undef CGAL_add_named_parameter

} // namespace internal_np

// CGAL's list of named parameters is baked into its class; this one adds ours on top of it.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  using Cgal_base = CGAL::Named_function_parameters<T, Tag, Base>;
  using Cgal_base::Cgal_base;

#define CGAL_add_named_parameter(X, Y, Z)                                   \
  template <class K>                                                        \
  Named_parameters<K, internal_np::X, Named_parameters> Z(const K& k) const \
  {                                                                         \
    return {k, *this};                                                      \
  }
#include CGAL_WIREFRAME_NP_LIST
#include CGAL_WIREFRAME_SHARED_NP_LIST
#undef CGAL_add_named_parameter
};
#endif // DOXYGEN_RUNNING

namespace parameters {

#ifndef DOXYGEN_RUNNING
using namespace CGAL::parameters;

#define CGAL_add_named_parameter(X, Y, Z)           \
  template <class K>                                \
  Named_parameters<K, internal_np::X> Z(const K& k) \
  {                                                 \
    return {k};                                     \
  }
#include CGAL_WIREFRAME_NP_LIST
#include CGAL_WIREFRAME_SHARED_NP_LIST
#undef CGAL_add_named_parameter
#endif

/// \ingroup PkgWireframeExtractionParameters
/// returns the parameters that give the published method (\cgalCite{MAZB21}, with the connection radius of 3 r of the
/// code the authors published), to compare with. Further parameters can be appended.
inline auto paper_defaults()
{
  return corner_measure(Corner_measure::VARIANCE)
    .corner_sampling_ratio(0.1)
    .corner_radius(4.)
    .corner_variance(0.3)
    .connection_radius(3.)
    .use_tangents(false)
    .graph_method(Graph_method::SUBDIVIDED)
    .end_detection(End_detection::MAIN_AXIS)
    .split_threshold(4.)
    .use_creases(false)
    .use_robust_loss(false)
    .move_corners(false)
    .adapt_knots(false)
    .number_of_rounds(1)
    .recognize_types(false);
}

} // namespace parameters
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_PARAMETERS_H
