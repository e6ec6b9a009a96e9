# The example of the README, as it stands there, compiles and runs.

set(readme "${root}/README.md")
if(NOT EXISTS "${readme}")
  return()
endif()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${readme}")

set(opening_fence "```cpp\n")
file(READ "${readme}" readme_text)
string(FIND "${readme_text}" "${opening_fence}" position)
if(position EQUAL -1)
  message(FATAL_ERROR "README.md has no example between ```cpp and ```")
endif()
string(LENGTH "${opening_fence}" fence_length)
math(EXPR position "${position} + ${fence_length}")
string(SUBSTRING "${readme_text}" ${position} -1 readme_code)
string(FIND "${readme_code}" "```" position)
string(SUBSTRING "${readme_code}" 0 ${position} readme_code)

set(readme_source "${CMAKE_CURRENT_BINARY_DIR}/readme/test_wireframe_readme.cpp")
# The same source with the compiled core and header-only, which is long to compile. So what is compared besides, wireframes of
# a scan and of a mesh, is in the same program.
file(CONFIGURE OUTPUT "${readme_source}" @ONLY CONTENT [=[
#define main main_of_readme
@readme_code@
#undef main

#include "write_other_wireframes.h"

int main()
{
  return main_of_readme() == 0 && write_wireframe_of_scan() && write_wireframe_of_mesh() ? 0 : 1;
}
]=])
# The README calls the cloud `cloud.ply`; here that is a bundled one whose field errs, so that every stage has something to do.
set(ways header_only)
if(TARGET CGAL::Wireframe_extraction_Core)
  list(APPEND ways compiled)
endif()
foreach(way IN LISTS ways)
  set(name test_wireframe_readme_${way})
  add_executable(${name} "${readme_source}")
  target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_LIST_DIR}/include")
  if(way STREQUAL "compiled")
    target_link_libraries(${name} PRIVATE CGAL::Wireframe_extraction_Core)
  else()
    target_link_libraries(${name} PRIVATE CGAL::Wireframe_extraction)
    if(TARGET CGAL::TBB_support)
      target_link_libraries(${name} PRIVATE CGAL::TBB_support)
    endif()
  endif()
  if(NOT MSVC) # more would make one extraction no faster than it makes the compilation slower
    target_compile_options(${name} PRIVATE "$<$<CONFIG:Release>:-O1>")
  endif()
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/run/${name}")
  file(MAKE_DIRECTORY "${folder}")
  foreach(file IN ITEMS slotted_plate.ply:cloud.ply l_bracket_scan.ply:scan.ply rounded_plate.stl:part.stl)
    string(REPLACE ":" ";" names "${file}")
    list(GET names 0 bundled)
    list(GET names 1 called)
    file(CREATE_LINK "${root}/examples/Wireframe_extraction/data/${bundled}" "${folder}/${called}" SYMBOLIC COPY_ON_ERROR)
  endforeach()
  add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY "${folder}")
  set_tests_properties(${name} PROPERTIES TIMEOUT 300 FIXTURES_SETUP readme_${way})
endforeach()

# They write the same bits.
if("compiled" IN_LIST ways)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/run")
  foreach(file IN ITEMS wireframe scan part)
    add_test(NAME same_bits_compiled_and_header_only_${file}
      COMMAND "${CMAKE_COMMAND}" -E compare_files "${folder}/test_wireframe_readme_compiled/${file}.json"
        "${folder}/test_wireframe_readme_header_only/${file}.json")
    set_tests_properties(same_bits_compiled_and_header_only_${file} PROPERTIES FIXTURES_REQUIRED
      "readme_compiled;readme_header_only")
  endforeach()
endif()

# Header-only, every function is one that several source files may define.
if(CMAKE_NM)
  add_test(NAME header_only_functions_are_inline
    COMMAND "${CMAKE_COMMAND}" "-Dnm=${CMAKE_NM}" "-Dobject=$<TARGET_OBJECTS:test_wireframe_readme_header_only>"
      -P "${CMAKE_CURRENT_LIST_DIR}/check_inline_functions.cmake")
endif()
