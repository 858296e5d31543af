# `cpack` in a build folder makes two packages: articam-tools, the programs, and articam-dev, what find_package finds.
if(CMAKE_CROSSCOMPILING)  # dpkg-shlibdeps knows the packages of this machine alone
  return()
endif()
find_program(ARTICAM_GZIP gzip)
if(NOT ARTICAM_GZIP)
  message(STATUS "Without gzip: no Debian packages")
  return()
endif()

# What Debian asks of every package: licence, change log in its own form (ours beside it), a manual page for each
# program. -n: without a date.
set(folder ${PROJECT_BINARY_DIR}/debian)
configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.in ${folder}/changelog @ONLY)
configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${folder}/NEWS.md COPYONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/articam.1 ${folder}/articam.1 COPYONLY)
foreach(file changelog NEWS.md articam.1)
  execute_process(COMMAND ${ARTICAM_GZIP} -9nc INPUT_FILE ${folder}/${file}
    OUTPUT_FILE ${folder}/${file}.gz COMMAND_ERROR_IS_FATAL ANY)
endforeach()
foreach(component tools dev)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/copyright ${folder}/changelog.gz ${folder}/NEWS.md.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/articam-${component} COMPONENT ${component})
endforeach()
install(FILES ${folder}/articam.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
foreach(program board detect listen markers modelgen probe replay sim)
  file(CREATE_LINK articam.1.gz ${folder}/articam-${program}.1.gz SYMBOLIC)
  install(FILES ${folder}/articam-${program}.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/source_date.cmake)
set(CPACK_PACKAGE_NAME articam)
set(CPACK_PACKAGE_VENDOR articam)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGE_CONTACT "The articam developers <developers@articam.example>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL tools dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_TOOLS_PACKAGE_NAME articam-tools)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TOOLS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TOOLS_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_TOOLS_DESCRIPTION "The model compiler, a probe of compiled models, marker sheets to print, the
detector and the tracker over recorded frames, the simulator, the receiver of
a board's estimates, and a board's program for a model of articam itself.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME articam-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "articam-tools (= ${PROJECT_VERSION}), libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS
  "cmake (>= 3.25), libcamera-dev, libcli11-dev, libfmt-dev, libnanopb-dev, libsodium-dev, pkg-config")
set(CPACK_DEBIAN_DEV_DESCRIPTION "Headers, static libraries and CMake functions that compile a URDF and a camera
calibration into the tables, the tracker and the board's program of a project
of one's own: find_package(articam). Its receiver is what a controller links.")
include(CPack)
