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

// Included several times on purpose: no include guard. One line per named parameter, in CGAL's own format.

CGAL_add_named_parameter(distance_map_t, distance_map, distance_map)
CGAL_add_named_parameter(sampling_distance_t, sampling_distance, sampling_distance)
CGAL_add_named_parameter(error_message_t, error_message, error_message)
CGAL_add_named_parameter(distance_property_t, distance_property, distance_property)
CGAL_add_named_parameter(skip_invalid_t, skip_invalid, skip_invalid)
CGAL_add_named_parameter(number_of_skipped_t, number_of_skipped, number_of_skipped)
CGAL_add_named_parameter(sampling_step_t, sampling_step, sampling_step)
