# Run by CPack when the files of all components are in their places. Adds to each Debian package what Debian's policy asks
# for, and says so if the tool is missing.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()

find_program(gzip gzip REQUIRED)
function(compress file)
  execute_process(COMMAND "${gzip}" -9nf "${file}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(GLOB components LIST_DIRECTORIES TRUE "${CPACK_TEMPORARY_DIRECTORY}/*")
foreach(component IN LISTS components)
  if(NOT IS_DIRECTORY "${component}/usr")
    continue()
  endif()
  get_filename_component(name "${component}" NAME)
  string(TOUPPER "${name}" upper_name)
  set(package "${CPACK_DEBIAN_${upper_name}_PACKAGE_NAME}")
  if(NOT package)
    message(FATAL_ERROR "The component ${name} has no Debian package")
  endif()
  if(name STREQUAL "Runtime" AND NOT EXISTS "${component}/usr/bin/extract_wireframe")
    message(FATAL_ERROR "The tool is not built: build the target extract_wireframe first")
  endif()
  file(GLOB core "${component}/usr/lib*/*Wireframe_extraction_Core*" "${component}/usr/lib*/*/*Wireframe_extraction_Core*")
  if(name STREQUAL "Core" AND NOT core)
    message(FATAL_ERROR "The core is not built: build the target Wireframe_extraction_Core first")
  endif()

  set(folder "${component}/usr/share/doc/${package}")
  file(REMOVE_RECURSE "${component}/usr/share/doc/Wireframe_extraction") # the licence, which every Debian system has
  file(MAKE_DIRECTORY "${folder}")
  file(COPY "${CPACK_WIREFRAME_EXTRACTION_COPYRIGHT}" DESTINATION "${folder}" FILE_PERMISSIONS
    OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
  string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC) # or SOURCE_DATE_EPOCH
  file(WRITE "${folder}/changelog" "${CPACK_PACKAGE_NAME} (${CPACK_PACKAGE_VERSION}) unstable; urgency=medium\n\n"
    "  * Version ${CPACK_PACKAGE_VERSION}; what is new is said in NEWS.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${now}\n")
  configure_file("${CPACK_WIREFRAME_EXTRACTION_CHANGES}" "${folder}/NEWS" COPYONLY)
  compress("${folder}/changelog")
  compress("${folder}/NEWS")
  file(GLOB pages "${component}/usr/share/man/man*/*.[1-9]")
  foreach(page IN LISTS pages)
    compress("${page}")
  endforeach()
endforeach()
