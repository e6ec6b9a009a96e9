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

// Included several times on purpose: no include guard. Named parameters that CGAL has: they are not defined once more,
// which would make them others that CGAL's are, but can be followed by ours.

CGAL_add_named_parameter(callback_t, callback, callback)
CGAL_add_named_parameter(geom_traits_t, geom_traits, geom_traits)
CGAL_add_named_parameter(point_t, point_map, point_map)
CGAL_add_named_parameter(random_seed_t, random_seed, random_seed)
CGAL_add_named_parameter(visitor_t, visitor, visitor)
