# The library, its headers, the CMake package `taut` with the target taut::taut, and taut.pc for pkg-config.
include(CMakePackageConfigHelpers)

set(taut_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/taut)
set(taut_pc_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# Installs the library `name`. Further arguments, such as a component, go to each install().
function(taut_install name)
  set(made ${PROJECT_BINARY_DIR}/package/${name})
  get_target_property(type ${name} TYPE)
  set(taut_needs_tbb FALSE)  # by who links the library; a shared one brings it along
  set(taut_pc_requires Requires.private)
  if(type STREQUAL STATIC_LIBRARY)
    set(taut_needs_tbb TRUE)
    set(taut_pc_requires Requires)
  endif()
  # Relative to the file itself, so that the tree may be moved.
  file(RELATIVE_PATH taut_pc_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" taut_pc_prefix "${taut_pc_prefix}")

  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/tautConfig.cmake.in ${made}/tautConfig.cmake
                                INSTALL_DESTINATION ${taut_package_dir})
  write_basic_package_version_file(${made}/tautConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/taut.pc.in ${made}/taut.pc @ONLY)

  install(TARGETS ${name} EXPORT ${name}Targets ${ARGN})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/taut DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${ARGN})
  install(EXPORT ${name}Targets FILE tautTargets.cmake NAMESPACE taut:: DESTINATION ${taut_package_dir} ${ARGN})
  install(FILES ${made}/tautConfig.cmake ${made}/tautConfigVersion.cmake DESTINATION ${taut_package_dir} ${ARGN})
  install(FILES ${made}/taut.pc DESTINATION ${taut_pc_dir} ${ARGN})
endfunction()
