# Installs the build in `binary_folder` below `work_folder`, then configures, builds and runs the consumer
# against it. The prefix has a space in its name, as users' folders do.
set(prefix "${work_folder}/prefix")
set(consumer_folder "${work_folder}/build")
file(REMOVE_RECURSE "${work_folder}")
file(MAKE_DIRECTORY "${work_folder}")

foreach(library IN ITEMS occt hdf5 zlib)
  if(expects_${library})
    set(has_no_${library} OFF)
  else()
    set(has_no_${library} ON)
  endif()
endforeach()

function(run_or_fail)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${work_folder}" RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
endfunction()

set(configuration_arguments)
if(configuration)
  set(configuration_arguments --config "${configuration}")
endif()

run_or_fail("${CMAKE_COMMAND}" --install "${binary_folder}" ${configuration_arguments}
  --component Development --prefix "${prefix}")
run_or_fail("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${consumer_folder}" -G "${generator}"
  "-DCMAKE_CXX_COMPILER=${compiler}"
  "-DCMAKE_BUILD_TYPE=${configuration}"
  "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF"
  "-DCGAL_DIR=${CGAL_DIR}"
  "-DEigen3_DIR=${Eigen3_DIR}"
  "-DCeres_DIR=${Ceres_DIR}"
  "-DCMAKE_RUNTIME_OUTPUT_DIRECTORY=${work_folder}/bin"
  "-DCMAKE_DISABLE_FIND_PACKAGE_OpenCASCADE=${has_no_occt}"
  "-Dexpects_occt=${expects_occt}"
  "-DCMAKE_DISABLE_FIND_PACKAGE_HDF5=${has_no_hdf5}"
  "-Dexpects_hdf5=${expects_hdf5}"
  "-DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=${has_no_zlib}"
  "-Dexpects_zlib=${expects_zlib}"
  "-Dexpects_qt=${expects_qt}"
  "-Dexpected_version=${version}")
run_or_fail("${CMAKE_COMMAND}" --build "${consumer_folder}" ${configuration_arguments})

# Found was what was just installed, not another copy somewhere else.
file(STRINGS "${consumer_folder}/CMakeCache.txt" found REGEX "^Wireframe_extraction_DIR:")
string(FIND "${found}" "=${prefix}/" position)
if(position EQUAL -1)
  message(FATAL_ERROR "the consumer did not find the installed package: ${found}")
endif()

file(GLOB_RECURSE programs "${work_folder}/bin/consumer*")
list(FILTER programs INCLUDE REGEX "consumer(\\.exe)?$")
list(LENGTH programs number_of_programs)
if(NOT number_of_programs EQUAL 1)
  message(FATAL_ERROR "expected one program, found: ${programs}")
endif()
run_or_fail(${programs})
file(GLOB_RECURSE programs "${work_folder}/bin/input_consumer*")
list(FILTER programs INCLUDE REGEX "input_consumer(\\.exe)?$")
run_or_fail(${programs})
if(expects_occt)
  file(GLOB_RECURSE programs "${work_folder}/bin/cad_consumer*")
  list(FILTER programs INCLUDE REGEX "cad_consumer(\\.exe)?$")
  run_or_fail(${programs})
endif()
