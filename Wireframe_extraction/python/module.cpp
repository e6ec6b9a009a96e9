// The compiled part of the Python package. It takes what the Python side has checked: names, types and shapes.

#include "bindings.h"

#ifdef WIREFRAME_EXTRACTION_WITH_GLOG
#include <glog/logging.h>
#endif

PYBIND11_MODULE(_core, module)
{
#ifdef WIREFRAME_EXTRACTION_WITH_GLOG
  // Ceres logs what it cannot solve, which the library looks at by itself, to the standard error stream
  FLAGS_minloglevel = google::GLOG_FATAL;
#endif
  module.doc() = "The compiled part of wireframe_extraction.";
  module.attr("__version__") = WIREFRAME_EXTRACTION_VERSION_STRING;
  python::bind_parameters(module);
  python::bind_curve(module);
  python::bind_wireframe(module);
  python::bind_files(module);
  python::bind_extraction(module);
  python::bind_stages(module);
  python::bind_evaluation(module);
  python::bind_page(module);
}
