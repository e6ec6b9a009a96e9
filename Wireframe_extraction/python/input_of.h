// What is to be read, and how, as Python gives it.

#ifndef WIREFRAME_EXTRACTION_PYTHON_INPUT_OF_H
#define WIREFRAME_EXTRACTION_PYTHON_INPUT_OF_H

#include <open_input.h>

#include <pybind11/pybind11.h>

namespace python {

// The Python side has checked names, types and choices.
tool::Input input_of(const pybind11::dict& values);

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_INPUT_OF_H
