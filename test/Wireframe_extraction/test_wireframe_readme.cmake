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
file(CONFIGURE OUTPUT "${readme_source}" CONTENT "@readme_code@" @ONLY)
# The same source with the compiled core and header-only. The README calls the cloud `cloud.ply`; here that is a bundled one
# whose field errs, so that every stage has something to do.
set(ways header_only)
if(TARGET CGAL::Wireframe_extraction_Core)
  list(APPEND ways compiled)
endif()
foreach(way IN LISTS ways)
  set(name test_wireframe_readme_${way})
  add_executable(${name} "${readme_source}")
  if(way STREQUAL "compiled")
    target_link_libraries(${name} PRIVATE CGAL::Wireframe_extraction_Core)
  else()
    target_link_libraries(${name} PRIVATE CGAL::Wireframe_extraction)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # a false one, about edges of Boost that CGAL collects
      target_compile_options(${name} PRIVATE -Wno-maybe-uninitialized)
    endif()
    if(TARGET CGAL::TBB_support)
      target_link_libraries(${name} PRIVATE CGAL::TBB_support)
    endif()
  endif()
  if(NOT MSVC) # more would make one extraction no faster than it makes the compilation slower
    target_compile_options(${name} PRIVATE "$<$<CONFIG:Release>:-O1>")
  endif()
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/run/${name}")
  file(MAKE_DIRECTORY "${folder}")
  file(CREATE_LINK "${root}/examples/Wireframe_extraction/data/slotted_plate.ply" "${folder}/cloud.ply"
    SYMBOLIC COPY_ON_ERROR)
  add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY "${folder}")
  set_tests_properties(${name} PROPERTIES TIMEOUT 300 FIXTURES_SETUP readme_${way})
endforeach()

# They write the same bits.
if("compiled" IN_LIST ways)
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/run")
  add_test(NAME same_bits_compiled_and_header_only
    COMMAND "${CMAKE_COMMAND}" -E compare_files "${folder}/test_wireframe_readme_compiled/wireframe.json"
      "${folder}/test_wireframe_readme_header_only/wireframe.json")
  set_tests_properties(same_bits_compiled_and_header_only PROPERTIES FIXTURES_REQUIRED
    "readme_compiled;readme_header_only")
endif()

# Header-only, every function is one that several source files may define.
if(CMAKE_NM)
  add_test(NAME header_only_functions_are_inline
    COMMAND "${CMAKE_COMMAND}" "-Dnm=${CMAKE_NM}" "-Dobject=$<TARGET_OBJECTS:test_wireframe_readme_header_only>"
      -P "${CMAKE_CURRENT_LIST_DIR}/check_inline_functions.cmake")
endif()
