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

#include <CGAL/Named_function_parameters.h>

#define CGAL_WIREFRAME_NP_LIST <CGAL/Wireframe_extraction/internal/parameters_interface.h>

namespace CGAL {
namespace Wireframe_extraction {

namespace internal_np {

using namespace CGAL::internal_np;

#define CGAL_add_named_parameter(X, Y, Z) enum X { Y };
#include CGAL_WIREFRAME_NP_LIST
#undef CGAL_add_named_parameter

} // namespace internal_np

/// \cond SKIP_IN_MANUAL
// CGAL's list of named parameters is baked into its class; this one adds ours on top of it.
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base>
{
  using Cgal_base = CGAL::Named_function_parameters<T, Tag, Base>;
  using Cgal_base::Cgal_base;

#define CGAL_add_named_parameter(X, Y, Z)                                    \
  template <class K>                                                         \
  Named_parameters<K, internal_np::X, Named_parameters> Z(const K& k) const  \
  {                                                                          \
    return {k, *this};                                                       \
  }
#include CGAL_WIREFRAME_NP_LIST
#undef CGAL_add_named_parameter
};
/// \endcond

namespace parameters {

using namespace CGAL::parameters;

#define CGAL_add_named_parameter(X, Y, Z)       \
  template <class K>                            \
  Named_parameters<K, internal_np::X> Z(const K& k) { return {k}; }
#include CGAL_WIREFRAME_NP_LIST
#undef CGAL_add_named_parameter

} // namespace parameters
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_PARAMETERS_H
