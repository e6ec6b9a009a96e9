// The types that the Python module hands around.

#ifndef WIREFRAME_EXTRACTION_PYTHON_TYPES_H
#define WIREFRAME_EXTRACTION_PYTHON_TYPES_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>

#include <memory>

namespace python {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_extraction_report Report;

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_TYPES_H
