// The parts of the module. Each function adds one.

#ifndef WIREFRAME_EXTRACTION_PYTHON_BINDINGS_H
#define WIREFRAME_EXTRACTION_PYTHON_BINDINGS_H

#include <pybind11/pybind11.h>

namespace python {

void bind_parameters(pybind11::module_& module);
void bind_curve(pybind11::module_& module);
void bind_wireframe(pybind11::module_& module);
void bind_files(pybind11::module_& module);
void bind_extraction(pybind11::module_& module);
void bind_stages(pybind11::module_& module);
void bind_evaluation(pybind11::module_& module);
void bind_page(pybind11::module_& module);

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_BINDINGS_H
