// A NumPy array as a range with a property map, for stages that take one.

#ifndef WIREFRAME_EXTRACTION_PYTHON_CLOUD_MAPS_H
#define WIREFRAME_EXTRACTION_PYTHON_CLOUD_MAPS_H

#include "Array_cloud.h"
#include "types.h"

#include <boost/property_map/property_map.hpp>
#include <boost/range/counting_range.hpp>

#include <cstddef>

namespace python {

struct Point_at
{
  typedef std::size_t key_type;
  typedef Point value_type;
  typedef Point reference;
  typedef boost::readable_property_map_tag category;

  Number_view points;

  friend Point get(const Point_at& map, std::size_t i)
  {
    return Point(map.points(i, 0), map.points(i, 1), map.points(i, 2));
  }
};

inline auto index_range(const Number_view& points) { return boost::counting_range(std::size_t(0), points.rows()); }

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_CLOUD_MAPS_H
