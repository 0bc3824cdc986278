# cmake --install: programs, manual pages and completions; and, as component "development", the libraries with a CMake
# package: find_package(gapcheck) gives gapcheck::api with its headers, gapcheck/*.hpp. The other rooms are installed only
# to be linked: they have no headers there. With GAPCHECK_PYTHON the Python package is component "python".
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS gapcheck check-c COMPONENT programs)
set(manual ${PROJECT_BINARY_DIR}/apps/manual)
install(FILES ${manual}/gapcheck.1 ${manual}/check-c.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT programs)
foreach(program gapcheck check-c)
  install(FILES ${manual}/${program}.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
          RENAME ${program} COMPONENT programs)
  install(FILES ${manual}/_${program} DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT programs)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT programs)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright COMPONENT programs)

set(rooms "")
foreach(room base records keyword model geometry contact results audit solver report api)
  list(APPEND rooms gapcheck_${room})
  set_target_properties(gapcheck_${room} PROPERTIES EXPORT_NAME ${room})
  # Libraries of headers alone are needed to build the rooms, not to link them.
  get_target_property(linked gapcheck_${room} INTERFACE_LINK_LIBRARIES)
  list(TRANSFORM linked REPLACE "^(.*(Eigen3|CGAL|nlohmann_json)::.*)$" "$<BUILD_INTERFACE:\\1>")
  set_target_properties(gapcheck_${room} PROPERTIES INTERFACE_LINK_LIBRARIES "${linked}")
endforeach()
# The numbers of CGAL.
set_property(TARGET gapcheck_geometry APPEND PROPERTY INTERFACE_LINK_LIBRARIES $<INSTALL_INTERFACE:mpfr>
             $<INSTALL_INTERFACE:gmp>)
install(TARGETS ${rooms} EXPORT gapcheck-targets ARCHIVE COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/lib/api/gapcheck DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT development FILES_MATCHING PATTERN "*.hpp")
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/gapcheck)
install(EXPORT gapcheck-targets NAMESPACE gapcheck:: DESTINATION ${package_folder} COMPONENT development)
configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/gapcheck-config.cmake.in
                              ${PROJECT_BINARY_DIR}/gapcheck-config.cmake INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/gapcheck-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/gapcheck-config.cmake ${PROJECT_BINARY_DIR}/gapcheck-config-version.cmake
        DESTINATION ${package_folder} COMPONENT development)

# cpack: gapcheck_VERSION_ARCH.deb with the programs, gapcheck-dev_VERSION_ARCH.deb with the libraries, and
# python3-gapcheck_VERSION_ARCH.deb with the Python package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the gapcheck developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "finds contact problems of LS-DYNA models")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL programs development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME gapcheck)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME gapcheck-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libfmt-dev, libgmp-dev, libmpfr-dev, libtbb-dev, zlib1g-dev")
if(GAPCHECK_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-gapcheck)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "${GAPCHECK_PYTHON_DEPENDS}")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-pandas")
endif()
set(CPACK_STRIP_FILES ON)
include(CPack)
