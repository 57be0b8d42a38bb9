# LAS, LAZ, COPC and E57 by Rust crates: an optional component. Where it can not be had the build goes on without
# it, and says so. Sets RIMLINE_HAS_SCAN_FORMATS and makes the target rimline_scan_formats.
set(RIMLINE_HAS_SCAN_FORMATS OFF)
find_program(RIMLINE_CARGO cargo DOC "Builds the reader of LAS, LAZ, COPC and E57")
# Not in the cache unless given: a cargo that comes later is seen.
if(NOT DEFINED RIMLINE_SCAN_FORMATS)
  set(RIMLINE_SCAN_FORMATS OFF)
  if(PROJECT_IS_TOP_LEVEL AND RIMLINE_CARGO)
    set(RIMLINE_SCAN_FORMATS ON)
  endif()
  if(PROJECT_IS_TOP_LEVEL AND NOT RIMLINE_CARGO)
    message(STATUS "LAS, LAZ, COPC and E57 will not be read: there is no cargo (scripts/setup installs it)")
  endif()
endif()

set(scan_formats_folder ${CMAKE_CURRENT_LIST_DIR}/../src/io/scan_formats)
set(RIMLINE_SCAN_FORMATS_LIBRARY ${PROJECT_BINARY_DIR}/scan_formats/release/librimline_scan_formats.a)
set(scan_formats_build ${RIMLINE_CARGO} build --release --locked --quiet --target-dir ${PROJECT_BINARY_DIR}/scan_formats)
if(RIMLINE_BUILD_FUZZ AND RIMLINE_CARGO)
  # libFuzzer is told what the crates do, as it is of our own code. With --target, tools of the build are left as they are.
  execute_process(COMMAND ${RIMLINE_CARGO} -vV OUTPUT_VARIABLE told ERROR_QUIET)
  string(REGEX MATCH "host: ([a-z0-9_-]+)" host "${told}")
  set(host ${CMAKE_MATCH_1})
  set(RIMLINE_SCAN_FORMATS_LIBRARY ${PROJECT_BINARY_DIR}/scan_formats/${host}/release/librimline_scan_formats.a)
  string(JOIN " -Cllvm-args=-sanitizer-coverage-" coverage "-Cpasses=sancov-module" level=4 inline-8bit-counters
    pc-table trace-compares)
  set(scan_formats_build ${CMAKE_COMMAND} -E env "RUSTFLAGS=${coverage}" CARGO_PROFILE_RELEASE_LTO=off
    ${scan_formats_build} --target ${host})
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
  # Built here once, so that what can not be had is known before anything needs it. Fetched is what Cargo.lock
  # names, checksums and all, and only what is not there yet.
  if(NOT EXISTS ${RIMLINE_SCAN_FORMATS_LIBRARY})
    message(STATUS "Building the reader of LAS, LAZ, COPC and E57 (once, about a minute)")
    execute_process(COMMAND ${scan_formats_build} --offline WORKING_DIRECTORY ${scan_formats_folder} RESULT_VARIABLE status
      OUTPUT_QUIET ERROR_QUIET)
    if(NOT status EQUAL 0)
      execute_process(COMMAND ${scan_formats_build} WORKING_DIRECTORY ${scan_formats_folder} RESULT_VARIABLE status
        OUTPUT_QUIET ERROR_VARIABLE told TIMEOUT 600)
    endif()
    if(NOT status EQUAL 0)
      rimline_without_scan_formats("cargo could not fetch or build the crates:\n${told}")
      return()
    endif()
  endif()
  set(RIMLINE_HAS_SCAN_FORMATS ON PARENT_SCOPE)
endfunction()

if(RIMLINE_SCAN_FORMATS)
  rimline_find_scan_formats()
endif()
if(RIMLINE_HAS_SCAN_FORMATS)
  file(GLOB sources CONFIGURE_DEPENDS ${scan_formats_folder}/src/*.rs)
  add_custom_command(OUTPUT ${RIMLINE_SCAN_FORMATS_LIBRARY}
    COMMAND ${scan_formats_build} --offline
    COMMAND ${CMAKE_COMMAND} -E touch_nocreate ${RIMLINE_SCAN_FORMATS_LIBRARY}
    WORKING_DIRECTORY ${scan_formats_folder}
    DEPENDS ${sources} ${scan_formats_folder}/Cargo.toml ${scan_formats_folder}/Cargo.lock
    COMMENT "Building the reader of LAS, LAZ, COPC and E57")
  add_custom_target(rimline_scan_formats DEPENDS ${RIMLINE_SCAN_FORMATS_LIBRARY})
endif()
