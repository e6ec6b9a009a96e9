// The kernel of the tool: it constructs points and vectors, and asks no predicates.

#ifndef EXTRACT_WIREFRAME_KERNEL_H
#define EXTRACT_WIREFRAME_KERNEL_H

#include <CGAL/Simple_cartesian.h>

namespace tool {

typedef CGAL::Simple_cartesian<double> Kernel;

} // namespace tool

#endif // EXTRACT_WIREFRAME_KERNEL_H
