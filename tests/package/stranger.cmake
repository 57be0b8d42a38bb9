# Builds and runs stranger/ in WORK, with rimline taken in by WAY. Stops at the first step that fails.
function(must)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "failed (${status}): ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
set(options -G Ninja -D CMAKE_BUILD_TYPE=${CONFIG} -D CMAKE_CXX_COMPILER=${COMPILER}
  -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -D WAY=${WAY})
if(SANITIZE)
  list(APPEND options -D CMAKE_EXE_LINKER_FLAGS=-fsanitize=${SANITIZE})
endif()
if(WAY STREQUAL "find_package")
  must(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
  list(APPEND options -D CMAKE_PREFIX_PATH=${WORK}/prefix)
else()
  # With the flags of the build that is tested, so that ccache has all objects of the library already.
  string(TOUPPER ${CONFIG} config)
  list(APPEND options -D RIMLINE_SOURCE=${SOURCE} -D RIMLINE_WARNINGS_AS_ERRORS=${WARNINGS_AS_ERRORS}
    -D RIMLINE_SANITIZE=${SANITIZE} -D "CMAKE_CXX_FLAGS_${config}=${FLAGS}")
endif()
must(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/stranger -B ${WORK} ${options})
must(${CMAKE_COMMAND} --build ${WORK} --target stranger)
must(${WORK}/stranger)
