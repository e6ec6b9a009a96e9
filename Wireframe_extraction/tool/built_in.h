// What the tool extract_wireframe was built with.

#ifndef EXTRACT_WIREFRAME_BUILT_IN_H
#define EXTRACT_WIREFRAME_BUILT_IN_H

#include <string>
#include <vector>

namespace tool {

// what depends on a library that may be missing
enum class Part
{
  CAD,
  HDF5,
  ZLIB,
  PNG,
  PAGE,
  THREADS
};

bool is_built_in(Part part);

// A sentence for the help, to be put behind others: that `what` is not built in, or nothing if it is.
std::string note_if_missing(Part part, const std::string& what);

// What --version prints: the version, and for each part the library with its version, or what is missing.
std::string version_text();

} // namespace tool

#endif // EXTRACT_WIREFRAME_BUILT_IN_H
