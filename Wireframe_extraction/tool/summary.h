// What the tool extract_wireframe says when it is done.

#ifndef EXTRACT_WIREFRAME_SUMMARY_H
#define EXTRACT_WIREFRAME_SUMMARY_H

#include "Field_scale.h"

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <cstdio>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tool {

inline std::string short_number(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}

inline std::string seconds_text(double seconds)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2f", seconds);
  return text;
}

inline std::string counted(std::size_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

// the curves of one kind
struct Curve_counts
{
  std::size_t all = 0, closed = 0;
};

inline std::pair<const char*, const char*> kind_names(CGAL::Wireframe_curve_type type)
{
  switch (type)
  {
  case CGAL::Wireframe_curve_type::LINE: return {"line", "lines"};
  case CGAL::Wireframe_curve_type::CIRCLE: return {"circle", "circles"};
  case CGAL::Wireframe_curve_type::ARC: return {"circular arc", "circular arcs"};
  case CGAL::Wireframe_curve_type::ELLIPSE: return {"ellipse", "ellipses"};
  case CGAL::Wireframe_curve_type::ELLIPTIC_ARC: return {"elliptic arc", "elliptic arcs"};
  default: return {"B-spline", "B-splines"};
  }
}

template <class GeomTraits>
std::string curves_text(const CGAL::Wireframe<GeomTraits>& wireframe)
{
  std::map<CGAL::Wireframe_curve_type, Curve_counts> counts;
  for (const auto& curve : wireframe.curves)
  {
    ++counts[curve.type].all;
    counts[curve.type].closed += curve.is_closed() ? 1 : 0;
  }
  std::string text;
  for (const auto& kind : counts)
  {
    const auto names = kind_names(kind.first);
    text += (text.empty() ? "" : ", ") + counted(kind.second.all, names.first, names.second);
    if (kind.first == CGAL::Wireframe_curve_type::BSPLINE && kind.second.closed > 0) // of others, the kind tells it
      text += " (" + std::to_string(kind.second.closed) + " closed)";
  }
  return text;
}

// a length in the cloud's unit, which is named if it is known, and in sampling distances
inline std::string length_text(double length, double sampling_distance, const std::string& unit)
{
  return short_number(length) + (unit.empty() ? "" : " " + unit)
    + (sampling_distance > 0. ? " = " + short_number(length / sampling_distance) + " r" : "");
}

inline void print_row(std::ostream& out, const std::string& name, const std::string& text)
{
  out << name << std::string(name.size() < 12 ? 12 - name.size() : 1, ' ') << text << '\n';
}

inline std::string points_text(const CGAL::Wireframe_extraction_report& report, std::size_t number_of_skipped)
{
  std::string text = std::to_string(report.number_of_points);
  if (number_of_skipped > 0)
    text += ", " + std::to_string(number_of_skipped) + " more skipped as invalid";
  if (report.number_of_duplicates > 0)
    text += ", " + std::to_string(report.number_of_duplicates) + " of the skeleton twice";
  return text;
}

inline std::string times_text(const std::vector<std::pair<std::string, double>>& seconds)
{
  std::string text;
  double sum = 0.;
  for (const auto& stage : seconds)
  {
    text += (text.empty() ? "" : ", ") + stage.first + " " + seconds_text(stage.second);
    sum += stage.second;
  }
  return seconds_text(sum) + " (" + text + ")";
}

// the rows of a table: a name and a text each
typedef std::vector<std::pair<std::string, std::string>> Summary;

// How many curves are doubtful and which, the reasons, and what to do about it: three lines, or one if there are none.
template <class GeomTraits>
Summary doubts_of(const CGAL::Wireframe<GeomTraits>& wireframe)
{
  static constexpr std::size_t most_in_line = 15;
  std::map<CGAL::Wireframe_doubt, std::size_t> reasons;
  std::vector<std::size_t> doubtful;
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
  {
    if (wireframe.curves[i].is_doubtful())
      doubtful.push_back(i);
    for (const CGAL::Wireframe_doubt doubt : wireframe.curves[i].doubts)
      ++reasons[doubt];
  }
  std::string text = std::to_string(doubtful.size()) + " of " + counted(wireframe.curves.size(), "curve", "curves");
  for (std::size_t k = 0; k < doubtful.size() && k < most_in_line; ++k)
    text += (k == 0 ? ": " : ", ") + std::to_string(doubtful[k]);
  if (doubtful.size() > most_in_line)
    text += " and " + std::to_string(doubtful.size() - most_in_line) + " more";
  Summary rows = {{"Doubtful", text}};
  if (doubtful.empty())
    return rows;
  text.clear();
  for (const auto& reason : reasons)
    text += (text.empty() ? "" : ", ") + to_string(reason.first) + " " + std::to_string(reason.second);
  rows.emplace_back("Why", text);
  rows.emplace_back("What to do", "look at them: --html OUT.html shows them alone, .json and .csv name their reasons");
  return rows;
}

template <class GeomTraits>
Summary summary_of(const Field_scale& scale, const CGAL::Wireframe<GeomTraits>& wireframe,
                   const CGAL::Wireframe_extraction_report& report, std::size_t number_of_skipped,
                   const std::string& distance_place, const std::string& unit)
{
  const double r = report.sampling_distance;
  Summary rows;
  rows.emplace_back("Points", points_text(report, number_of_skipped));
  if (!distance_place.empty())
    rows.emplace_back("Distances", distance_place);
  rows.emplace_back("r", short_number(r) + (unit.empty() ? "" : " " + unit) + " (" + scale.origin_of_r + ")");
  if (report.is_field_estimated)
    rows.emplace_back("Field",
                      "estimated from the points, whose noise is " + length_text(report.point_noise, r, unit) + "; "
                        + counted(report.number_of_near_points, "point", "points") + " near features");
  rows.emplace_back("Noise",
                    length_text(report.noise, r, unit)
                      + (scale.origin_of_noise.empty() ? "" : " (" + scale.origin_of_noise + ")"));
  rows.emplace_back("Skeleton", counted(report.skeleton_size, "point", "points"));
  rows.emplace_back(
    "Corners",
    std::to_string(report.number_of_corners)
      + (report.number_of_free_ends == 0 ? "" : ", and " + std::to_string(report.number_of_free_ends) + " free ends"));
  rows.emplace_back("Curves", curves_text(wireframe));
  for (const std::string& regularity : report.regularities)
    rows.emplace_back("Regular", regularity); // curves are counted from 0, as in the files
  rows.emplace_back("Residuals",
                    "rms " + length_text(report.rms, r, unit) + ", largest " + length_text(report.max, r, unit));
  return rows;
}

inline void print_summary(std::ostream& out, const Summary& summary,
                          const std::vector<std::pair<std::string, double>>& seconds,
                          const std::vector<std::string>& written_files)
{
  for (const auto& row : summary)
    print_row(out, row.first, row.second);
  print_row(out, "Seconds", times_text(seconds));
  for (const std::string& name : written_files)
    print_row(out, "Written", name);
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_SUMMARY_H
