# Gives the target CGAL::Wireframe_extraction_HDF5, the library with its reader of HDF5, if the HDF5 library is there
# (Debian: libhdf5-dev). Without it there is no such target, and no error.

# CMake's own module needs a C compiler, and looks for wrappers of it. Debian has the serial library in a folder of its
# own, beside those for MPI, which ask for MPI's headers.
if(NOT CMAKE_DISABLE_FIND_PACKAGE_HDF5)
  find_path(Wireframe_extraction_HDF5_INCLUDE_DIR hdf5.h
    HINTS "${HDF5_ROOT}" ENV HDF5_ROOT PATH_SUFFIXES include hdf5/serial include/hdf5/serial)
  find_library(Wireframe_extraction_HDF5_LIBRARY NAMES hdf5_serial hdf5
    HINTS "${HDF5_ROOT}" ENV HDF5_ROOT PATH_SUFFIXES lib hdf5/serial)
  mark_as_advanced(Wireframe_extraction_HDF5_INCLUDE_DIR Wireframe_extraction_HDF5_LIBRARY)
  if(Wireframe_extraction_HDF5_INCLUDE_DIR AND Wireframe_extraction_HDF5_LIBRARY
      AND NOT TARGET CGAL::Wireframe_extraction_HDF5)
    add_library(CGAL::Wireframe_extraction_HDF5 INTERFACE IMPORTED GLOBAL)
    target_compile_definitions(CGAL::Wireframe_extraction_HDF5 INTERFACE CGAL_WIREFRAME_EXTRACTION_USE_HDF5)
    target_include_directories(CGAL::Wireframe_extraction_HDF5 INTERFACE "${Wireframe_extraction_HDF5_INCLUDE_DIR}")
    target_link_libraries(CGAL::Wireframe_extraction_HDF5 INTERFACE
      CGAL::Wireframe_extraction "${Wireframe_extraction_HDF5_LIBRARY}")
  endif()
endif()
