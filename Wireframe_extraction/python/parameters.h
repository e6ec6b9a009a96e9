// The named parameters of an extraction, as Python gives them.

#ifndef WIREFRAME_EXTRACTION_PYTHON_PARAMETERS_H
#define WIREFRAME_EXTRACTION_PYTHON_PARAMETERS_H

#include "types.h"

#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <pybind11/pybind11.h>

#include <cstddef>
#include <functional>

namespace python {

// the thresholds of the library with their defaults, and what else decides on the result
struct Parameters : CGAL::Wireframe_extraction::internal::Extraction_options
{
  double sampling_distance = 0.; // 0: to be estimated
  std::size_t points_in_memory = std::size_t(1) << 20;
  bool skip_invalid = false;
};

// Reads what is there; the rest has its default. The Python side has checked names and types, not ranges.
Parameters parameters_of(const pybind11::dict& values);

// Returns all parameters with their values, under their names.
pybind11::dict to_dict(const Parameters& parameters);

// Returns the values that a parameter may have that is a choice, under its name.
pybind11::dict choices();

// Returns those of the published method.
Parameters paper_parameters();

// All parameters are given each time, so that each function of the library is compiled for one pack of them.
inline auto named_parameters(const Parameters& p, Report& report, const std::function<bool(double)>& callback)
{
  return CGAL::Wireframe_extraction::parameters::sampling_distance(p.sampling_distance)
    .points_in_memory(p.points_in_memory)
    .minimum_fold(p.minimum_fold)
    .noise_level(p.noise_level)
    .skeleton_distance(p.skeleton_distance)
    .support_distance(p.support_distance)
    .fitting_radius(p.fitting_radius)
    .use_creases(p.use_creases)
    .corner_measure(p.corner_measure)
    .corner_sampling_ratio(p.corner_sampling_ratio)
    .corner_radius(p.corner_radius)
    .corner_variance(p.corner_variance)
    .corner_residual(p.corner_residual)
    .connection_radius(p.connection_radius)
    .connection_angle(p.connection_angle)
    .use_tangents(p.use_tangents)
    .graph_method(p.graph_method)
    .end_detection(p.end_detection)
    .split_threshold(p.split_threshold)
    .corner_reach(p.corner_reach)
    .maximum_gap(p.maximum_gap)
    .smooth_angle(p.smooth_angle)
    .minimum_evidence(p.minimum_evidence)
    .use_robust_loss(p.use_robust_loss)
    .move_corners(p.move_corners)
    .adapt_knots(p.adapt_knots)
    .number_of_rounds(p.number_of_rounds)
    .recognize_types(p.recognize_types)
    .type_significance(p.type_significance)
    .regularize(p.regularize)
    .skip_invalid(p.skip_invalid)
    .extraction_report(std::ref(report))
    .callback(callback);
}

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_PARAMETERS_H
