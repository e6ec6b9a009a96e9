#include "write_cad.h"
#include "Kernel.h"

#include <CGAL/Wireframe_extraction/IO/write_wireframe_brep.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_iges.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_step.h>
#include <CGAL/Wireframe_extraction/parameters.h>

namespace tool {

bool write_cad(const std::string& extension, std::ostream& stream, const CGAL::Wireframe<Kernel>& wireframe,
               CGAL::Wireframe_extraction::Length_unit unit, CGAL::Wireframe_extraction::Step_schema schema,
               const CGAL::Wireframe_provenance& provenance, std::string& error)
{
  namespace parameters = CGAL::Wireframe_extraction::parameters;
  const auto np = parameters::error_message(&error).unit(unit).step_schema(schema);
  if (extension == ".brep")
    return CGAL::IO::write_wireframe_brep(stream, wireframe, np);
  if (extension == ".iges" || extension == ".igs")
    return CGAL::IO::write_wireframe_iges(stream, wireframe, np);
  return CGAL::IO::write_wireframe_step(stream, wireframe, np.provenance(provenance));
}

} // namespace tool
