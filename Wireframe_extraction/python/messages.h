// Texts of the library as those of Python.

#ifndef WIREFRAME_EXTRACTION_PYTHON_MESSAGES_H
#define WIREFRAME_EXTRACTION_PYTHON_MESSAGES_H

#include <pybind11/pybind11.h>

#include <string>

namespace python {

// Names of files need not be UTF-8: bytes that are not stand there as \xff.
inline pybind11::str to_text(const std::string& text)
{
  return pybind11::reinterpret_steal<pybind11::str>(
    PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "backslashreplace"));
}

// Raises ValueError, also from where Python's lock is not held.
[[noreturn]] inline void throw_value_error(const std::string& message)
{
  const pybind11::gil_scoped_acquire lock;
  PyErr_SetObject(PyExc_ValueError, to_text(message).ptr());
  throw pybind11::error_already_set();
}

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_MESSAGES_H
