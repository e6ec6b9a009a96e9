// Between the values of the library and NumPy arrays.

#ifndef WIREFRAME_EXTRACTION_PYTHON_ARRAYS_H
#define WIREFRAME_EXTRACTION_PYTHON_ARRAYS_H

#include "types.h"

#include <pybind11/numpy.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace python {

// what the Python side hands over of its small arrays: in C order, converted if need be
typedef pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast> Double_array;

// an array that takes over a vector, without a copy
template <class Number>
pybind11::array to_array(std::vector<Number>&& values)
{
  auto* const kept = new std::vector<Number>(std::move(values));
  const pybind11::capsule owner(kept, [](void* p) { delete static_cast<std::vector<Number>*>(p); });
  return pybind11::array_t<Number>({static_cast<pybind11::ssize_t>(kept->size())}, kept->data(), owner);
}

// the same as rows of three numbers
inline pybind11::array to_rows(std::vector<double>&& coordinates)
{
  const pybind11::ssize_t rows = static_cast<pybind11::ssize_t>(coordinates.size() / 3);
  return to_array(std::move(coordinates)).reshape({rows, pybind11::ssize_t(3)});
}

// Copies: what a wireframe has is small, and not everybody takes arrays that cannot be written to.
inline pybind11::array copy_of(const std::vector<double>& values) { return to_array(std::vector<double>(values)); }

inline pybind11::array copy_of(const std::vector<Point>& points)
{
  std::vector<double> coordinates;
  for (const Point& p : points)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  return to_rows(std::move(coordinates));
}

// of a point or a vector
template <class Position>
void append(const Position& p, std::vector<double>& coordinates)
{
  coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
}

inline std::vector<Point> to_points(const Double_array& rows)
{
  std::vector<Point> points;
  points.reserve(static_cast<std::size_t>(rows.shape(0)));
  for (pybind11::ssize_t i = 0; i < rows.shape(0); ++i)
    points.emplace_back(rows.at(i, 0), rows.at(i, 1), rows.at(i, 2));
  return points;
}

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_ARRAYS_H
