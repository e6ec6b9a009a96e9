# Gives the target CGAL::Wireframe_extraction_Qt, the library with CGAL::draw(wireframe), if CGAL's viewer and Qt are
# there (Debian: libcgal-qt5-dev). Without them there is no such target, and no error.

# CGAL 5 draws with Qt 5, and CGAL 6 with Qt 6.
if(CGAL_VERSION VERSION_LESS 6.0)
  set(Wireframe_extraction_qt Qt5)
else()
  set(Wireframe_extraction_qt Qt6)
endif()
find_package(CGAL QUIET OPTIONAL_COMPONENTS ${Wireframe_extraction_qt})
if(CGAL_${Wireframe_extraction_qt}_FOUND AND TARGET CGAL::CGAL_${Wireframe_extraction_qt}
    AND TARGET CGAL::CGAL_Basic_viewer AND NOT TARGET CGAL::Wireframe_extraction_Qt)
  add_library(CGAL::Wireframe_extraction_Qt INTERFACE IMPORTED GLOBAL)
  target_link_libraries(CGAL::Wireframe_extraction_Qt INTERFACE CGAL::Wireframe_extraction CGAL::CGAL_Basic_viewer)
endif()
unset(Wireframe_extraction_qt)
