// The formats of CAD programs that the tool extract_wireframe writes, if it is built with OpenCASCADE. They are
// compiled apart from the rest.

#ifndef EXTRACT_WIREFRAME_WRITE_CAD_H
#define EXTRACT_WIREFRAME_WRITE_CAD_H

#include "Kernel.h"

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <iosfwd>
#include <string>

namespace tool {

// Writes STEP, IGES or BREP after the extension, which is in lower case and has its dot.
bool write_cad(const std::string& extension, std::ostream& stream, const CGAL::Wireframe<Kernel>& wireframe,
               CGAL::Wireframe_extraction::Length_unit unit, CGAL::Wireframe_extraction::Step_schema schema,
               const CGAL::Wireframe_provenance& provenance, std::string& error);

} // namespace tool

#endif // EXTRACT_WIREFRAME_WRITE_CAD_H
