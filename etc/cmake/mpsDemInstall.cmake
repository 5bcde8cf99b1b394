# Installation: bin/, lib/, include/mpsDem/<library>/, share/mpsDem/{etc,tutorials} and the package for find_package(mpsDem).

include(CMakePackageConfigHelpers)

install(DIRECTORY "${PROJECT_SOURCE_DIR}/etc/" DESTINATION share/mpsDem/etc USE_SOURCE_PERMISSIONS
  PATTERN "ci" EXCLUDE
  PATTERN "cmake" EXCLUDE)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/tutorials" DESTINATION share/mpsDem USE_SOURCE_PERMISSIONS OPTIONAL)
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION share/mpsDem)

configure_package_config_file("${PROJECT_SOURCE_DIR}/etc/cmake/mpsDemConfig.cmake.in" "${PROJECT_BINARY_DIR}/mpsDemConfig.cmake"
  INSTALL_DESTINATION lib/cmake/mpsDem)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/mpsDemConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/mpsDemConfig.cmake" "${PROJECT_BINARY_DIR}/mpsDemConfigVersion.cmake" DESTINATION lib/cmake/mpsDem)
install(EXPORT mpsDemTargets NAMESPACE mpsDem:: DESTINATION lib/cmake/mpsDem)
