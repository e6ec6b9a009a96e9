# Installs the build in `binary_folder` below `work_folder`, then configures, builds and runs the consumer
# against it. The prefix has a space in its name, as users' folders do. With `cpack` and `dpkg_deb`, what is
# installed comes out of the Debian package; with `has_tool`, the tool's package is looked at, too. With `is_packed` that is
# tested, too, and what was compiled there is not compiled again.
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

set(program_of_core core_consumer)
set(program_of_occt cad_consumer)

function(run_or_fail)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${work_folder}" RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "failed (${result}): ${command}")
  endif()
endfunction()

# The package of the headers has no core.
set(has_core "${expects_core}")
if(cpack)
  set(has_core OFF)
endif()

set(configuration_arguments)
if(configuration)
  set(configuration_arguments --config "${configuration}")
endif()

function(expect_field package field expected)
  execute_process(COMMAND "${dpkg_deb}" --field "${package}" ${field} OUTPUT_VARIABLE value COMMAND_ERROR_IS_FATAL ANY)
  if(NOT value MATCHES "${expected}")
    message(FATAL_ERROR "${package}: ${field} is not as expected: ${value}")
  endif()
endfunction()

if(cpack)
  set(cpack_configuration)
  if(configuration)
    set(cpack_configuration -C "${configuration}")
  endif()
  run_or_fail("${cpack}" -G DEB ${cpack_configuration} --config "${binary_folder}/CPackConfig.cmake"
    -B "${work_folder}/packages")
  set(package "${work_folder}/packages/libwireframe-extraction-dev_${version}_all.deb")
  expect_field("${package}" Version "^${version}\n$")
  expect_field("${package}" Depends "libcgal-dev.*libeigen3-dev.*libceres-dev")
  run_or_fail("${dpkg_deb}" -x "${package}" "${work_folder}/dev")
  file(RENAME "${work_folder}/dev/usr" "${prefix}")
  if(NOT EXISTS "${prefix}/share/doc/libwireframe-extraction-dev/copyright")
    message(FATAL_ERROR "${package} has no file copyright")
  endif()
  if(has_tool)
    file(GLOB package "${work_folder}/packages/extract-wireframe_${version}_*.deb")
    run_or_fail("${dpkg_deb}" -x "${package}" "${work_folder}/tool")
    foreach(file IN ITEMS share/man/man1/extract_wireframe.1.gz share/doc/extract-wireframe/changelog.gz)
      if(NOT EXISTS "${work_folder}/tool/usr/${file}")
        message(FATAL_ERROR "${package} has no file ${file}")
      endif()
    endforeach()
    execute_process(COMMAND "${work_folder}/tool/usr/bin/extract_wireframe" --version
      OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
    string(FIND "${said}" "${version}" position)
    if(position EQUAL -1)
      message(FATAL_ERROR "the packed tool has another version than ${version}: ${said}")
    endif()
  endif()
else()
  run_or_fail("${CMAKE_COMMAND}" --install "${binary_folder}" ${configuration_arguments}
    --component Development --prefix "${prefix}")
  if(expects_core)
    run_or_fail("${CMAKE_COMMAND}" --install "${binary_folder}" ${configuration_arguments}
      --component Core --prefix "${prefix}")
  endif()
endif()
run_or_fail("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${consumer_folder}" -G "${generator}"
  "-DCMAKE_CXX_COMPILER=${compiler}"
  "-DCMAKE_BUILD_TYPE=${configuration}"
  -DCMAKE_CXX_FLAGS_RELEASE=-DNDEBUG # that it compiles and runs is the question, not how fast it runs
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
  "-Dexpects_core=${has_core}"
  "-Dexpected_version=${version}")
set(targets)
if(cpack) # the other programs would tell nothing new
  set(targets --target consumer)
elseif(is_packed) # and here it is this one
  set(targets --target input_consumer)
  foreach(library IN ITEMS core occt)
    if(expects_${library})
      list(APPEND targets ${program_of_${library}})
    endif()
  endforeach()
endif()
run_or_fail("${CMAKE_COMMAND}" --build "${consumer_folder}" ${configuration_arguments} ${targets})

# Found was what was just installed, not another copy somewhere else.
file(STRINGS "${consumer_folder}/CMakeCache.txt" found REGEX "^Wireframe_extraction_DIR:")
string(FIND "${found}" "=${prefix}/" position)
if(position EQUAL -1)
  message(FATAL_ERROR "the consumer did not find the installed package: ${found}")
endif()

if(cpack OR NOT is_packed)
  file(GLOB_RECURSE programs "${work_folder}/bin/consumer*")
  list(FILTER programs INCLUDE REGEX "consumer(\\.exe)?$")
  list(LENGTH programs number_of_programs)
  if(NOT number_of_programs EQUAL 1)
    message(FATAL_ERROR "expected one program, found: ${programs}")
  endif()
  run_or_fail(${programs})
endif()
if(cpack)
  return()
endif()
if(has_core)
  file(GLOB_RECURSE programs "${work_folder}/bin/core_consumer*")
  list(FILTER programs INCLUDE REGEX "core_consumer(\\.exe)?$")
  run_or_fail(${programs})
endif()
file(GLOB_RECURSE programs "${work_folder}/bin/input_consumer*")
list(FILTER programs INCLUDE REGEX "input_consumer(\\.exe)?$")
run_or_fail(${programs})
if(expects_occt)
  file(GLOB_RECURSE programs "${work_folder}/bin/cad_consumer*")
  list(FILTER programs INCLUDE REGEX "cad_consumer(\\.exe)?$")
  run_or_fail(${programs})
endif()
