// The names of units of length.

#ifndef WIREFRAME_EXTRACTION_PYTHON_UNITS_H
#define WIREFRAME_EXTRACTION_PYTHON_UNITS_H

#include <CGAL/Wireframe_extraction/policies.h>

#include <pybind11/pybind11.h>

#include <string>
#include <utility>

namespace python {

inline CGAL::Wireframe_extraction::Length_unit unit_of(const std::string& name)
{
  using CGAL::Wireframe_extraction::Length_unit;
  static const std::pair<const char*, Length_unit> units[] = {
    {"um", Length_unit::MICROMETER}, {"mm", Length_unit::MILLIMETER}, {"cm", Length_unit::CENTIMETER},
    {"m", Length_unit::METER},       {"in", Length_unit::INCH},       {"ft", Length_unit::FOOT}};
  for (const auto& unit : units)
    if (name == unit.first)
      return unit.second;
  throw pybind11::value_error("unit is \"" + name + "\"; it has to be one of um, mm, cm, m, in, ft");
}

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_UNITS_H
