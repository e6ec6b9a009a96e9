# Gives the target extract_wireframe_viewer, the page of extract_wireframe --html. It is made of the files in this
# folder and of three.js, which npm fetches when the build is configured; esbuild puts them together. Without npm, or
# where it fetches nothing, there is no such target, a message that says why, and no error.

option(WIREFRAME_EXTRACTION_BUILD_VIEWER "Build the page of extract_wireframe --html, which needs npm" ON)
set(WIREFRAME_EXTRACTION_NODE_MODULES "" CACHE PATH
  "A folder node_modules with three and esbuild in it, for extract_wireframe --html; npm fetches one if this is empty")

set(viewer_folder "${CMAKE_CURRENT_LIST_DIR}")
set(viewer_work_folder "${CMAKE_CURRENT_BINARY_DIR}/viewer")

# Gives why there are no modules, or nothing if they are in the folder.
function(fetch_viewer_modules reason)
  find_program(NPM_PROGRAM npm)
  mark_as_advanced(NPM_PROGRAM)
  if(NOT NPM_PROGRAM)
    set(${reason} "it needs npm (Debian: npm)" PARENT_SCOPE)
    return()
  endif()
  # what was fetched stays until other versions are wanted
  file(SHA256 "${viewer_folder}/package-lock.json" hash)
  set(stamp "${viewer_work_folder}/fetched_${hash}")
  if(NOT EXISTS "${stamp}")
    file(COPY "${viewer_folder}/package.json" "${viewer_folder}/package-lock.json" DESTINATION "${viewer_work_folder}")
    execute_process(
      COMMAND "${NPM_PROGRAM}" ci --ignore-scripts --no-audit --no-fund --prefer-offline --fetch-retries=1
        --fetch-timeout=20000
      WORKING_DIRECTORY "${viewer_work_folder}" RESULT_VARIABLE result TIMEOUT 120
      OUTPUT_FILE "${viewer_work_folder}/npm.log" ERROR_FILE "${viewer_work_folder}/npm.log")
    if(NOT result EQUAL 0)
      set(${reason} "npm could not fetch three.js, see ${viewer_work_folder}/npm.log" PARENT_SCOPE)
      return()
    endif()
    file(WRITE "${stamp}" "")
  endif()
  set(${reason} "" PARENT_SCOPE)
endfunction()

if(NOT WIREFRAME_EXTRACTION_BUILD_VIEWER)
  set(viewer_reason "WIREFRAME_EXTRACTION_BUILD_VIEWER is off")
elseif(WIREFRAME_EXTRACTION_NODE_MODULES)
  set(viewer_modules "${WIREFRAME_EXTRACTION_NODE_MODULES}")
  set(viewer_reason "")
else()
  set(viewer_modules "${viewer_work_folder}/node_modules")
  fetch_viewer_modules(viewer_reason)
endif()
find_program(NODE_PROGRAM NAMES node nodejs)
mark_as_advanced(NODE_PROGRAM)
if(NOT viewer_reason AND NOT NODE_PROGRAM)
  set(viewer_reason "it needs node (Debian: nodejs)")
endif()
foreach(viewer_module IN ITEMS three esbuild)
  if(NOT viewer_reason AND NOT EXISTS "${viewer_modules}/${viewer_module}/package.json")
    set(viewer_reason "there is no ${viewer_module} in ${viewer_modules}")
  endif()
endforeach()

if(viewer_reason)
  message(STATUS "extract_wireframe will have no --html: ${viewer_reason}")
else()
  set(viewer_script "${viewer_work_folder}/viewer.js")
  set(viewer_source "${viewer_work_folder}/page_template.cpp")
  file(GLOB viewer_sources CONFIGURE_DEPENDS
    "${viewer_folder}/*.js" "${viewer_folder}/*.mjs" "${viewer_folder}/page.*" "${viewer_folder}/make_page.cmake"
    "${viewer_folder}/package*.json")
  add_custom_command(OUTPUT "${viewer_source}"
    COMMAND "${NODE_PROGRAM}" "${viewer_folder}/bundle.mjs" "${viewer_modules}" "${viewer_script}"
    COMMAND "${CMAKE_COMMAND}" "-Dscript=${viewer_script}" "-Dfolder=${viewer_folder}" "-Doutput=${viewer_source}"
      -P "${viewer_folder}/make_page.cmake"
    DEPENDS ${viewer_sources}
    COMMENT "Making the page of extract_wireframe --html"
    VERBATIM)
  add_library(extract_wireframe_viewer STATIC "${viewer_source}")
  target_compile_definitions(extract_wireframe_viewer INTERFACE EXTRACT_WIREFRAME_WITH_VIEWER)
endif()
