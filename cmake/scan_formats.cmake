# LAS, LAZ, COPC and E57 by Rust crates: an optional component. Where it can not be had the build goes on without
# it, and says so. Sets RIMLINE_HAS_SCAN_FORMATS and makes the target rimline_scan_formats.
set(RIMLINE_HAS_SCAN_FORMATS OFF)
find_program(RIMLINE_CARGO cargo DOC "Builds the reader of LAS, LAZ, COPC and E57")
if(RIMLINE_CARGO AND PROJECT_IS_TOP_LEVEL)
  option(RIMLINE_SCAN_FORMATS "Read LAS, LAZ, COPC and E57 (needs cargo 1.89 or newer)" ON)
else()
  option(RIMLINE_SCAN_FORMATS "Read LAS, LAZ, COPC and E57 (needs cargo 1.89 or newer)" OFF)
endif()

function(rimline_without_scan_formats reason)
  message(WARNING "LAS, LAZ, COPC and E57 will not be read: ${reason}")
endfunction()

function(rimline_find_scan_formats)
  if(NOT RIMLINE_CARGO)
    rimline_without_scan_formats("there is no cargo; scripts/setup installs it")
    return()
  endif()
  execute_process(COMMAND ${RIMLINE_CARGO} --version OUTPUT_VARIABLE told RESULT_VARIABLE status ERROR_QUIET)
  string(REGEX MATCH "[0-9]+\\.[0-9]+\\.[0-9]+" version "${told}")
  if(NOT status EQUAL 0 OR version VERSION_LESS 1.89)
    rimline_without_scan_formats("${RIMLINE_CARGO} is of version '${version}', and 1.89 is the oldest that can build them")
    return()
  endif()
  # What is fetched is what Cargo.lock names, checksums and all; the build itself asks nobody.
  execute_process(
    COMMAND ${RIMLINE_CARGO} fetch --locked --quiet
    WORKING_DIRECTORY ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../src/io/scan_formats
    RESULT_VARIABLE status ERROR_VARIABLE told OUTPUT_QUIET TIMEOUT 120)
  if(NOT status EQUAL 0)
    rimline_without_scan_formats("cargo could not fetch the crates:\n${told}")
    return()
  endif()
  set(RIMLINE_HAS_SCAN_FORMATS ON PARENT_SCOPE)
endfunction()

if(RIMLINE_SCAN_FORMATS)
  rimline_find_scan_formats()
endif()
if(RIMLINE_HAS_SCAN_FORMATS)
  set(folder ${CMAKE_CURRENT_LIST_DIR}/../src/io/scan_formats)
  set(built ${PROJECT_BINARY_DIR}/scan_formats)
  set(RIMLINE_SCAN_FORMATS_LIBRARY ${built}/release/librimline_scan_formats.a)
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/src/*.rs)
  add_custom_command(OUTPUT ${RIMLINE_SCAN_FORMATS_LIBRARY}
    COMMAND ${RIMLINE_CARGO} build --release --locked --offline --quiet --target-dir ${built}
    WORKING_DIRECTORY ${folder}
    DEPENDS ${sources} ${folder}/Cargo.toml ${folder}/Cargo.lock
    COMMENT "Building the reader of LAS, LAZ, COPC and E57")
  add_custom_target(rimline_scan_formats DEPENDS ${RIMLINE_SCAN_FORMATS_LIBRARY})
endif()
