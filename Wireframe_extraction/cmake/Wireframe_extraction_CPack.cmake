# What `cpack` packs: of the components, Development and, where they are built, Core and Runtime. `cpack -G DEB` makes a Debian
# package of each of them, `cpack -G TGZ` archives of the same.

set(CPACK_PACKAGE_NAME wireframe-extraction)
set(CPACK_PACKAGE_VENDOR "The Wireframe_extraction authors")
# CPack wants an address; who publishes packages gives his own: -DCPACK_PACKAGE_CONTACT="Name <address>"
if(NOT CPACK_PACKAGE_CONTACT)
  set(CPACK_PACKAGE_CONTACT "The Wireframe_extraction authors <wireframe-extraction@authors.invalid>")
endif()
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_RESOURCE_FILE_README "${PROJECT_SOURCE_DIR}/README.md")
set(CPACK_STRIP_FILES ON)
set(CPACK_ARCHIVE_COMPONENT_INSTALL ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_SOURCE_GENERATOR TGZ)
string(REGEX REPLACE "([^a-zA-Z0-9_/ -])" "\\\\\\1" source_pattern "${PROJECT_SOURCE_DIR}")
set(CPACK_SOURCE_IGNORE_FILES
  "^${source_pattern}/\\.git(/|$)" "^${source_pattern}/build[^/]*/" "^${source_pattern}/.*/__pycache__/" "~$")

set(CPACK_COMPONENTS_ALL Development)
if(TARGET Wireframe_extraction_Core)
  list(APPEND CPACK_COMPONENTS_ALL Core)
endif()
if(TARGET extract_wireframe)
  list(APPEND CPACK_COMPONENTS_ALL Runtime)
endif()

# Debian ---------------------------------------------------------------------------------------------

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libwireframe-extraction-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_ARCHITECTURE all) # headers only
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libeigen3-dev, libceres-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "nlohmann-json3-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS "libocct-data-exchange-dev (>= 7.6), libhdf5-dev, zlib1g-dev, libtbb-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "\
These are the headers and the CMake package of a header-only library in the
conventions of CGAL. From a point cloud of a man-made shape, in which every
point carries an estimate of its distance to the nearest sharp curve, it
extracts a graph of corners and parametric curves.")

set(CPACK_DEBIAN_CORE_PACKAGE_NAME libwireframe-extraction-core-dev)
set(CPACK_DEBIAN_CORE_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_CORE_PACKAGE_DEPENDS "libwireframe-extraction-dev (= ${PROJECT_VERSION})")
if(TARGET CGAL::TBB_support)
  string(APPEND CPACK_DEBIAN_CORE_PACKAGE_DEPENDS ", libtbb-dev")
endif()
set(CPACK_COMPONENT_CORE_DESCRIPTION "\
This is the part of the library that needs to be compiled once only, as a
static library. Programs that link it compile in seconds instead of minutes.")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME extract-wireframe)
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "\
The tool extract_wireframe reads a point cloud of a man-made shape, in which
every point carries an estimate of its distance to the nearest sharp curve,
as PLY, text, PCD, NumPy or OFF, and writes its corners and parametric curves
in formats of CAD programs and viewers.")
find_program(DPKG_SHLIBDEPS_PROGRAM dpkg-shlibdeps)
mark_as_advanced(DPKG_SHLIBDEPS_PROGRAM)
if(DPKG_SHLIBDEPS_PROGRAM)
  set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
else()
  message(STATUS "A Debian package of the tool will not know the libraries it needs: there is no dpkg-shlibdeps "
    "(Debian: dpkg-dev)")
endif()

# What Debian's policy asks for beside our files: copyright, changes, and compressed manual pages.
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/debian/complete_packages.cmake")
set(CPACK_WIREFRAME_EXTRACTION_COPYRIGHT "${CMAKE_CURRENT_LIST_DIR}/debian/copyright")
set(CPACK_WIREFRAME_EXTRACTION_CHANGES "${PROJECT_SOURCE_DIR}/CHANGES.md")

include(CPack)
