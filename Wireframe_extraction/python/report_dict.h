// The report of an extraction as a dictionary, from which the Python side makes its own.

#ifndef WIREFRAME_EXTRACTION_PYTHON_REPORT_DICT_H
#define WIREFRAME_EXTRACTION_PYTHON_REPORT_DICT_H

#include "messages.h"
#include "types.h"

#include <pybind11/stl.h>

#include <string>

namespace python {

inline const char* name_of(Report::Status status)
{
  switch (status)
  {
  case Report::Status::SUCCESS: return "success";
  case Report::Status::NO_FEATURE: return "no_feature";
  case Report::Status::CANCELLED: return "cancelled";
  default: return "invalid_input";
  }
}

inline pybind11::dict report_dict(const Report& report)
{
  pybind11::dict seconds, result;
  pybind11::list warnings;
  for (const std::string& warning : report.warnings)
    warnings.append(to_text(warning));
  for (const auto& stage : report.seconds)
    seconds[stage.first.c_str()] = stage.second;
  result["status"] = name_of(report.status);
  result["message"] = to_text(report.message);
  result["warnings"] = warnings;
  result["number_of_points"] = report.number_of_points;
  result["number_of_skipped_points"] = report.number_of_skipped_points;
  result["number_of_duplicates"] = report.number_of_duplicates;
  result["number_of_strays"] = report.number_of_strays;
  result["skeleton_size"] = report.skeleton_size;
  result["number_of_corners"] = report.number_of_corners;
  result["number_of_free_ends"] = report.number_of_free_ends;
  result["number_of_clusters"] = report.number_of_clusters;
  result["number_of_curves"] = report.number_of_curves;
  result["number_of_doubtful_curves"] = report.number_of_doubtful_curves;
  result["regularities"] = report.regularities;
  result["is_field_estimated"] = report.is_field_estimated;
  result["number_of_near_points"] = report.number_of_near_points;
  result["point_noise"] = report.point_noise;
  result["sampling_distance"] = report.sampling_distance;
  result["noise"] = report.noise;
  result["rms"] = report.rms;
  result["max"] = report.max;
  result["seconds"] = seconds;
  return result;
}

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_REPORT_DICT_H
