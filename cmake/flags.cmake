# Flags that every target of ours shares, carried by one interface target.
add_library(rimline_flags INTERFACE)
target_compile_options(rimline_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wno-sign-compare
  # The same bytes on every machine: no fused multiply-add that only some processors have.
  -ffp-contract=off)
if(RIMLINE_WARNINGS_AS_ERRORS)
  target_compile_options(rimline_flags INTERFACE -Werror)
endif()
if(RIMLINE_SANITIZE)
  target_compile_options(rimline_flags INTERFACE -fsanitize=${RIMLINE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(rimline_flags INTERFACE -fsanitize=${RIMLINE_SANITIZE})
  # gcc takes what sanitizers add for uses of what is not set, in <regex> of its own library too.
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(rimline_flags INTERFACE -Wno-maybe-uninitialized)
  endif()
endif()
