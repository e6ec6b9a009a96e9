// NumPy arrays as a cloud. They are read where they are, whatever their strides, in single or double precision.

#ifndef WIREFRAME_EXTRACTION_PYTHON_ARRAY_CLOUD_H
#define WIREFRAME_EXTRACTION_PYTHON_ARRAY_CLOUD_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>

#include <pybind11/numpy.h>

#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

namespace python {

// An array of numbers with one or two dimensions. It refers to memory that whoever made it keeps.
class Number_view
{
public:
  Number_view() = default;

  // throws if the array is not what the Python side promises
  explicit Number_view(const pybind11::array& array)
    : m_data(static_cast<const char*>(array.data())), m_rows(array.shape(0)), m_row_stride(array.strides(0)),
      m_column_stride(array.ndim() > 1 ? array.strides(1) : 0), m_is_double(array.dtype().num() == double_number())
  {
    if (!m_is_double && array.dtype().num() != pybind11::dtype::of<float>().num())
      throw pybind11::type_error("an array has to be of float32 or float64");
  }

  std::size_t rows() const { return static_cast<std::size_t>(m_rows); }

  double operator()(std::size_t row, std::size_t column = 0) const
  {
    const char* const place = m_data + static_cast<pybind11::ssize_t>(row) * m_row_stride
      + static_cast<pybind11::ssize_t>(column) * m_column_stride;
    if (m_is_double)
      return value_at<double>(place);
    return static_cast<double>(value_at<float>(place));
  }

private:
  static int double_number() { return pybind11::dtype::of<double>().num(); }

  // fields of records need not be aligned
  template <class Number>
  static Number value_at(const char* place)
  {
    Number number;
    std::memcpy(&number, place, sizeof(number));
    return number;
  }

  const char* m_data = nullptr;
  pybind11::ssize_t m_rows = 0, m_row_stride = 0, m_column_stride = 0;
  bool m_is_double = true;
};

// Points, and their distances if there are any.
class Array_cloud : public CGAL::Wireframe_extraction::Distance_cloud_source
{
public:
  Array_cloud(const Number_view& points, const Number_view& distances, bool has_distances)
    : m_points(points), m_distances(distances), m_has_distances(has_distances)
  {}

  bool has_distances() const override { return m_has_distances; }
  std::size_t size_hint() const override { return m_points.rows(); }

  bool read(const Sink& sink) override
  {
    static constexpr std::size_t samples_per_chunk = 4096;
    std::vector<Sample> chunk;
    chunk.reserve(samples_per_chunk);
    for (std::size_t i = 0; i < m_points.rows(); ++i)
    {
      chunk.push_back({m_points(i, 0), m_points(i, 1), m_points(i, 2), m_has_distances ? m_distances(i) : 0.});
      if (chunk.size() < samples_per_chunk && i + 1 < m_points.rows())
        continue;
      if (!sink(chunk.data(), chunk.data() + chunk.size()))
        break;
      chunk.clear();
    }
    return true;
  }

private:
  const Number_view m_points, m_distances;
  const bool m_has_distances;
};

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_ARRAY_CLOUD_H
