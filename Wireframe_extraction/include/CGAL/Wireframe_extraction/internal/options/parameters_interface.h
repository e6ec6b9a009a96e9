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
CGAL_add_named_parameter(deviation_map_t, deviation_map, deviation_map)
CGAL_add_named_parameter(sampling_distance_t, sampling_distance, sampling_distance)
CGAL_add_named_parameter(points_in_memory_t, points_in_memory, points_in_memory)
CGAL_add_named_parameter(error_message_t, error_message, error_message)
CGAL_add_named_parameter(field_origin_t, field_origin, field_origin)
CGAL_add_named_parameter(input_format_t, input_format, input_format)
CGAL_add_named_parameter(clamp_negative_t, clamp_negative, clamp_negative)
CGAL_add_named_parameter(coordinate_properties_t, coordinate_properties, coordinate_properties)
CGAL_add_named_parameter(distance_property_t, distance_property, distance_property)
CGAL_add_named_parameter(points_dataset_t, points_dataset, points_dataset)
CGAL_add_named_parameter(distances_dataset_t, distances_dataset, distances_dataset)
CGAL_add_named_parameter(indices_dataset_t, indices_dataset, indices_dataset)
CGAL_add_named_parameter(use_indices_t, use_indices, use_indices)
CGAL_add_named_parameter(patch_fusion_t, patch_fusion, patch_fusion)
CGAL_add_named_parameter(skip_invalid_t, skip_invalid, skip_invalid)
CGAL_add_named_parameter(number_of_skipped_t, number_of_skipped, number_of_skipped)
CGAL_add_named_parameter(sampling_step_t, sampling_step, sampling_step)
CGAL_add_named_parameter(unit_t, unit, unit)
CGAL_add_named_parameter(step_schema_t, step_schema, step_schema)
CGAL_add_named_parameter(obj_splines_t, obj_splines, obj_splines)
CGAL_add_named_parameter(dxf_splines_t, dxf_splines, dxf_splines)
CGAL_add_named_parameter(chord_tolerance_t, chord_tolerance, chord_tolerance)
CGAL_add_named_parameter(noise_level_t, noise_level, noise_level)
CGAL_add_named_parameter(skeleton_distance_t, skeleton_distance, skeleton_distance)
CGAL_add_named_parameter(support_distance_t, support_distance, support_distance)
CGAL_add_named_parameter(fitting_radius_t, fitting_radius, fitting_radius)
CGAL_add_named_parameter(corner_measure_t, corner_measure, corner_measure)
CGAL_add_named_parameter(corner_sampling_ratio_t, corner_sampling_ratio, corner_sampling_ratio)
CGAL_add_named_parameter(corner_radius_t, corner_radius, corner_radius)
CGAL_add_named_parameter(corner_variance_t, corner_variance, corner_variance)
CGAL_add_named_parameter(corner_residual_t, corner_residual, corner_residual)
CGAL_add_named_parameter(connection_radius_t, connection_radius, connection_radius)
CGAL_add_named_parameter(connection_angle_t, connection_angle, connection_angle)
CGAL_add_named_parameter(use_tangents_t, use_tangents, use_tangents)
CGAL_add_named_parameter(graph_method_t, graph_method, graph_method)
CGAL_add_named_parameter(end_detection_t, end_detection, end_detection)
CGAL_add_named_parameter(split_threshold_t, split_threshold, split_threshold)
CGAL_add_named_parameter(corner_reach_t, corner_reach, corner_reach)
CGAL_add_named_parameter(maximum_gap_t, maximum_gap, maximum_gap)
CGAL_add_named_parameter(smooth_angle_t, smooth_angle, smooth_angle)
CGAL_add_named_parameter(minimum_evidence_t, minimum_evidence, minimum_evidence)
CGAL_add_named_parameter(use_creases_t, use_creases, use_creases)
CGAL_add_named_parameter(use_robust_loss_t, use_robust_loss, use_robust_loss)
CGAL_add_named_parameter(move_corners_t, move_corners, move_corners)
CGAL_add_named_parameter(adapt_knots_t, adapt_knots, adapt_knots)
CGAL_add_named_parameter(number_of_rounds_t, number_of_rounds, number_of_rounds)
CGAL_add_named_parameter(recognize_types_t, recognize_types, recognize_types)
CGAL_add_named_parameter(type_significance_t, type_significance, type_significance)
CGAL_add_named_parameter(regularize_t, regularize, regularize)
CGAL_add_named_parameter(extraction_report_t, extraction_report, extraction_report)
CGAL_add_named_parameter(minimum_fold_t, minimum_fold, minimum_fold)
CGAL_add_named_parameter(maximum_facet_fold_t, maximum_facet_fold, maximum_facet_fold)
CGAL_add_named_parameter(use_boundaries_t, use_boundaries, use_boundaries)
CGAL_add_named_parameter(maximum_number_of_points_t, maximum_number_of_points, maximum_number_of_points)
CGAL_add_named_parameter(mesh_report_t, mesh_report, mesh_report)
