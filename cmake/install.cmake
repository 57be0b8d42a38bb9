# Install and export: find_package(rimline) then link rimline::rimline.
include(CMakePackageConfigHelpers)
install(TARGETS rimline EXPORT rimline-targets)
if(RIMLINE_HAS_SCAN_FORMATS)
  install(FILES ${RIMLINE_SCAN_FORMATS_LIBRARY} DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
install(DIRECTORY include/rimline include/deprecated/rimline ${CMAKE_CURRENT_BINARY_DIR}/include/rimline
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
install(EXPORT rimline-targets NAMESPACE rimline:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rimline)
configure_package_config_file(cmake/rimline-config.cmake.in rimline-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rimline)
write_basic_package_version_file(rimline-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/rimline-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/rimline-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/rimline)
