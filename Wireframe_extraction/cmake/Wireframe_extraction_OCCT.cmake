# Gives the target CGAL::Wireframe_extraction_OCCT, the library with its writers of STEP, IGES and BREP, if OpenCASCADE
# 7.6 or later is there (Debian: libocct-data-exchange-dev). Without it there is no such target, and no error.

# OpenCASCADE's package adds macros to everything in the folder that asks for it.
get_property(Wireframe_extraction_old_definitions DIRECTORY PROPERTY COMPILE_DEFINITIONS)
find_package(OpenCASCADE CONFIG QUIET)
set_property(DIRECTORY PROPERTY COMPILE_DEFINITIONS "${Wireframe_extraction_old_definitions}")
unset(Wireframe_extraction_old_definitions)

if(TARGET TKDESTEP)
  set(Wireframe_extraction_occt_libraries TKDESTEP TKDEIGES) # since 7.8
else()
  set(Wireframe_extraction_occt_libraries TKSTEP TKSTEPAttr TKSTEPBase TKIGES)
endif()
list(APPEND Wireframe_extraction_occt_libraries TKXSBase TKBRep TKG3d TKMath TKernel)

set(Wireframe_extraction_has_occt "${OpenCASCADE_FOUND}")
if("${OpenCASCADE_MAJOR_VERSION}.${OpenCASCADE_MINOR_VERSION}" VERSION_LESS 7.6)
  set(Wireframe_extraction_has_occt OFF)
endif()
foreach(Wireframe_extraction_library IN LISTS Wireframe_extraction_occt_libraries)
  if(NOT TARGET ${Wireframe_extraction_library})
    set(Wireframe_extraction_has_occt OFF) # its parts can be installed without each other
  endif()
endforeach()

if(Wireframe_extraction_has_occt AND NOT TARGET CGAL::Wireframe_extraction_OCCT)
  add_library(CGAL::Wireframe_extraction_OCCT INTERFACE IMPORTED GLOBAL)
  target_compile_definitions(CGAL::Wireframe_extraction_OCCT INTERFACE CGAL_WIREFRAME_EXTRACTION_USE_OCCT)
  target_include_directories(CGAL::Wireframe_extraction_OCCT INTERFACE "${OpenCASCADE_INCLUDE_DIR}")
  target_link_libraries(CGAL::Wireframe_extraction_OCCT INTERFACE
    CGAL::Wireframe_extraction ${Wireframe_extraction_occt_libraries})
endif()
unset(Wireframe_extraction_library)
unset(Wireframe_extraction_occt_libraries)
unset(Wireframe_extraction_has_occt)
