# The library, its headers, and the CMake package `taut` with the target taut::taut.
include(CMakePackageConfigHelpers)

set(taut_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/taut)
get_target_property(taut_links taut LINK_LIBRARIES)
set(taut_needs_tbb FALSE)
if("TBB::tbb" IN_LIST taut_links)
  set(taut_needs_tbb TRUE)
endif()

configure_package_config_file(cmake/tautConfig.cmake.in tautConfig.cmake INSTALL_DESTINATION ${taut_package_dir})
write_basic_package_version_file(tautConfigVersion.cmake COMPATIBILITY SameMinorVersion)

install(TARGETS taut EXPORT tautTargets)
install(DIRECTORY include/taut DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT tautTargets NAMESPACE taut:: DESTINATION ${taut_package_dir})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/tautConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/tautConfigVersion.cmake
        DESTINATION ${taut_package_dir})
