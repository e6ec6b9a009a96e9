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
add_executable(test_wireframe_readme "${readme_source}")
target_link_libraries(test_wireframe_readme PRIVATE ${libraries})

# The README calls the cloud `cloud.ply`; here that is one of the bundled ones.
set(folder "${CMAKE_CURRENT_BINARY_DIR}/run/test_wireframe_readme")
file(MAKE_DIRECTORY "${folder}")
file(CREATE_LINK "${root}/examples/Wireframe_extraction/data/box_with_hole.ply" "${folder}/cloud.ply"
  SYMBOLIC COPY_ON_ERROR)
add_test(NAME test_wireframe_readme COMMAND test_wireframe_readme WORKING_DIRECTORY "${folder}")
set_tests_properties(test_wireframe_readme PROPERTIES TIMEOUT 300)
