#include "built_in.h"

#include <CGAL/version.h>

#include <Eigen/Core>
#include <ceres/version.h>

#ifdef CGAL_WIREFRAME_EXTRACTION_USE_OCCT
#include <Standard_Version.hxx>
#endif
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5
#include <hdf5.h>
#endif
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
#include <zlib.h>
#endif
#ifdef EXTRACT_WIREFRAME_WITH_PNG
#include <png.h>
#endif
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/version.h>
#endif

namespace tool {
namespace {

struct Library
{
  Part part;
  std::string purpose, version; // no version if it is missing
  std::string name, package;    // where to get it then
};

template <class... Numbers>
std::string dotted(int first, Numbers... numbers)
{
  std::string text = std::to_string(first);
  ((text += "." + std::to_string(numbers)), ...);
  return text;
}

std::vector<Library> libraries()
{
  std::string cad, hdf5, zlib, png, page, threads;
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_OCCT
  cad = OCC_VERSION_COMPLETE;
#endif
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5
  hdf5 = dotted(H5_VERS_MAJOR, H5_VERS_MINOR, H5_VERS_RELEASE) + ", with lzf";
#endif
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
  zlib = ZLIB_VERSION;
#endif
#ifdef EXTRACT_WIREFRAME_WITH_PNG
  png = PNG_LIBPNG_VER_STRING;
#endif
#ifdef EXTRACT_WIREFRAME_THREE_REVISION
  page = "r" EXTRACT_WIREFRAME_THREE_REVISION;
#endif
#ifdef CGAL_LINKED_WITH_TBB
  threads = dotted(TBB_VERSION_MAJOR, TBB_VERSION_MINOR);
#endif
  return {{Part::CAD, "STEP, IGES and BREP", cad, "OpenCASCADE", "libocct-data-exchange-dev"},
          {Part::HDF5, "HDF5", hdf5, "HDF5", "libhdf5-dev"},
          {Part::ZLIB, "compressed .npz", zlib, "zlib", "zlib1g-dev"},
          {Part::PNG, "--png", png, "libpng", "libpng-dev"},
          {Part::PAGE, "--html", page, "three.js", "libjs-three esbuild"},
          {Part::THREADS, "several threads", threads, "TBB", "libtbb-dev"}};
}

} // namespace

bool is_built_in(Part part)
{
  for (const Library& library : libraries())
    if (library.part == part)
      return !library.version.empty();
  return false;
}

std::string note_if_missing(Part part, const std::string& what)
{
  return is_built_in(part) ? std::string() : ". Not built in: " + what;
}

std::string version_text()
{
  std::string text = "extract_wireframe " WIREFRAME_EXTRACTION_VERSION_STRING "\n";
  const auto add = [&text](const std::string& purpose, const std::string& value) {
    text += "  " + purpose + std::string(22 - purpose.size(), ' ') + value + "\n";
  };
  for (const Library& library : libraries())
    add(library.purpose,
        library.version.empty() ? "not built in: needs " + library.name + " (Debian: " + library.package + ")"
                                : library.name + " " + library.version);
  add("geometry and fits",
      "CGAL " CGAL_VERSION_STR ", Eigen " + dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)
        + ", Ceres " CERES_VERSION_STRING);
  text.pop_back();
  return text;
}

} // namespace tool
