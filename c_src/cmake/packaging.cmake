# What `make install` puts in place for users of the C libraries: the library and its headers, a CMake package and a
# pkg-config file. Nothing in them names an absolute path, so the installed tree can be moved.
include(CMakePackageConfigHelpers)

# fc_install_library(TARGET "one line on what it is" [other libraries of ours that it needs])
function(fc_install_library target description)
  set_target_properties(${target} PROPERTIES
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
  set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/${target}")
  set(generated "${CMAKE_CURRENT_BINARY_DIR}/package/${target}")

  install(TARGETS ${target} EXPORT ${target}-targets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(DIRECTORY ${target}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT ${target}-targets NAMESPACE ${target}:: DESTINATION ${package_dir})

  set(FC_PACKAGE ${target})
  set(FC_DESCRIPTION "${description}")
  list(JOIN ARGN " " FC_REQUIRES)
  configure_file(cmake/package-config.cmake.in ${generated}/${target}-config.cmake @ONLY)
  configure_file(cmake/package.pc.in ${generated}/${target}.pc @ONLY)
  write_basic_package_version_file(${generated}/${target}-config-version.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${generated}/${target}-config.cmake ${generated}/${target}-config-version.cmake
    DESTINATION ${package_dir})
  install(FILES ${generated}/${target}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()
