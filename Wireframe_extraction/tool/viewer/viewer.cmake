# Gives the target extract_wireframe_viewer, the page of extract_wireframe --html. It is made of the files in this
# folder and of three.js; esbuild puts them together. Both are Debian packages; where these are not, npm fetches them
# when the build is configured. Without either there is no such target, a message that says why, and no error.

option(WIREFRAME_EXTRACTION_BUILD_VIEWER "Build the page of extract_wireframe --html" ON)
set(WIREFRAME_EXTRACTION_NODE_MODULES "" CACHE PATH
  "A folder node_modules with three and esbuild in it, for extract_wireframe --html; if it is empty, those of Debian or npm")

set(viewer_folder "${CMAKE_CURRENT_LIST_DIR}")
set(viewer_work_folder "${CMAKE_CURRENT_BINARY_DIR}/viewer")

# Makes a folder of modules of the three.js that Debian installs. Gives nothing if it is not there.
function(link_viewer_modules folder)
  find_path(WIREFRAME_EXTRACTION_THREE_FOLDER NAMES build/three.module.js PATHS /usr/share/javascript/three
    NO_DEFAULT_PATH)
  mark_as_advanced(WIREFRAME_EXTRACTION_THREE_FOLDER)
  set(${folder} "" PARENT_SCOPE)
  if(WIREFRAME_EXTRACTION_THREE_FOLDER)
    set(module "${viewer_work_folder}/debian/three")
    file(WRITE "${module}/package.json"
      "{\"exports\": {\".\": \"./build/three.module.js\", \"./examples/*\": \"./examples/*\"}}\n")
    foreach(name IN ITEMS build examples)
      file(CREATE_LINK "${WIREFRAME_EXTRACTION_THREE_FOLDER}/${name}" "${module}/${name}" SYMBOLIC)
    endforeach()
    set(${folder} "${viewer_work_folder}/debian" PARENT_SCOPE)
  endif()
endfunction()

# Gives why there are no modules, or nothing if they are in the folder.
function(fetch_viewer_modules reason)
  find_program(NPM_PROGRAM npm)
  mark_as_advanced(NPM_PROGRAM)
  if(NOT NPM_PROGRAM)
    set(${reason} "it needs three.js and esbuild (Debian: libjs-three esbuild), or npm, which fetches them" PARENT_SCOPE)
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
      set(${reason} "npm could not fetch three.js, see ${viewer_work_folder}/npm.log; Debian has it: libjs-three esbuild"
        PARENT_SCOPE)
      return()
    endif()
    file(WRITE "${stamp}" "")
  endif()
  set(${reason} "" PARENT_SCOPE)
endfunction()

# esbuild is a program of its own, which npm puts among the modules, in a folder for the system.
find_program(ESBUILD_PROGRAM esbuild)
mark_as_advanced(ESBUILD_PROGRAM)
set(viewer_reason "")
set(viewer_esbuild "${ESBUILD_PROGRAM}")
set(viewer_modules "${WIREFRAME_EXTRACTION_NODE_MODULES}")
if(NOT WIREFRAME_EXTRACTION_BUILD_VIEWER)
  set(viewer_reason "WIREFRAME_EXTRACTION_BUILD_VIEWER is off")
else()
  if(NOT viewer_modules AND ESBUILD_PROGRAM)
    link_viewer_modules(viewer_modules)
  endif()
  if(NOT viewer_modules)
    set(viewer_modules "${viewer_work_folder}/node_modules")
    fetch_viewer_modules(viewer_reason)
  endif()
  file(GLOB viewer_programs "${viewer_modules}/@esbuild/*/bin/esbuild" "${viewer_modules}/@esbuild/*/esbuild.exe")
  if(viewer_programs)
    list(GET viewer_programs 0 viewer_esbuild)
  endif()
endif()
if(NOT viewer_reason AND NOT EXISTS "${viewer_modules}/three/package.json")
  set(viewer_reason "there is no three in ${viewer_modules}")
elseif(NOT viewer_reason AND NOT viewer_esbuild)
  set(viewer_reason "it needs esbuild (Debian: esbuild)")
endif()

if(viewer_reason)
  message(STATUS "extract_wireframe will have no --html: ${viewer_reason}")
else()
  set(viewer_script "${viewer_work_folder}/viewer.js")
  set(viewer_source "${viewer_work_folder}/page_template.cpp")
  file(GLOB viewer_sources CONFIGURE_DEPENDS
    "${viewer_folder}/*.js" "${viewer_folder}/page.*" "${viewer_folder}/make_page.cmake"
    "${viewer_folder}/package*.json")
  # The modules are not beside the sources. An older three.js lacks some names, which scene.js looks for.
  add_custom_command(OUTPUT "${viewer_source}"
    COMMAND "${CMAKE_COMMAND}" -E env "NODE_PATH=${viewer_modules}"
      "${viewer_esbuild}" "${viewer_folder}/main.js" "--outfile=${viewer_script}" --bundle --minify --format=iife
      --legal-comments=eof --log-level=warning --log-override:import-is-undefined=silent
    COMMAND "${CMAKE_COMMAND}" "-Dscript=${viewer_script}" "-Dfolder=${viewer_folder}" "-Doutput=${viewer_source}"
      -P "${viewer_folder}/make_page.cmake"
    DEPENDS ${viewer_sources}
    COMMENT "Making the page of extract_wireframe --html"
    VERBATIM)
  add_library(extract_wireframe_viewer STATIC "${viewer_source}")
  set_target_properties(extract_wireframe_viewer PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_definitions(extract_wireframe_viewer INTERFACE EXTRACT_WIREFRAME_WITH_VIEWER)
  set(viewer_file "${viewer_modules}/three/build/three.core.js")
  if(NOT EXISTS "${viewer_file}")
    set(viewer_file "${viewer_modules}/three/build/three.module.js")
  endif()
  file(STRINGS "${viewer_file}" viewer_revision REGEX "(REVISION = '[0-9]+|REVISION=\"[0-9]+)" LIMIT_COUNT 1)
  string(REGEX MATCH "REVISION ?= ?['\"]([0-9]+)" viewer_revision "${viewer_revision}")
  target_compile_definitions(extract_wireframe_viewer INTERFACE "EXTRACT_WIREFRAME_THREE_REVISION=\"${CMAKE_MATCH_1}\"")
endif()
