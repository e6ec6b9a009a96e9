# Gives the target CGAL::Wireframe_extraction_ZLIB, the library with its reader of compressed NumPy archives, if zlib is
# there (Debian: zlib1g-dev). Without it there is no such target, and no error.

find_package(ZLIB QUIET)
if(ZLIB_FOUND AND NOT TARGET CGAL::Wireframe_extraction_ZLIB)
  add_library(CGAL::Wireframe_extraction_ZLIB INTERFACE IMPORTED GLOBAL)
  target_compile_definitions(CGAL::Wireframe_extraction_ZLIB INTERFACE CGAL_WIREFRAME_EXTRACTION_USE_ZLIB)
  # not its target, which only the folder that asked for it may see
  target_include_directories(CGAL::Wireframe_extraction_ZLIB INTERFACE ${ZLIB_INCLUDE_DIRS})
  target_link_libraries(CGAL::Wireframe_extraction_ZLIB INTERFACE CGAL::Wireframe_extraction ${ZLIB_LIBRARIES})
endif()
