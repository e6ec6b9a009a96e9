// How far points are from a wireframe.

#ifndef WIREFRAME_EXTRACTION_PYTHON_NEAREST_DISTANCES_H
#define WIREFRAME_EXTRACTION_PYTHON_NEAREST_DISTANCES_H

#include "types.h"

#include <vector>

namespace python {

// Returns the distance of each point to the nearest curve, infinity if there is none.
std::vector<double> nearest_distances(const Wireframe& wireframe, const std::vector<Point>& points);

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_NEAREST_DISTANCES_H
