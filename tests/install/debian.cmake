# The packages of cpack, where dpkg is.
find_program(ARTICAM_DPKG_DEB dpkg-deb)
if(NOT ARTICAM_DPKG_DEB OR NOT CPACK_GENERATOR)
  message(STATUS "The Debian packages are not tested: no dpkg-deb")
  return()
endif()
add_test(NAME Debian.TwoPackagesHoldWhatTheyShouldAndAreTheSameTwice
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/debian_packages.sh ${CMAKE_CPACK_COMMAND} ${PROJECT_BINARY_DIR}
    ${CMAKE_CURRENT_BINARY_DIR}/packages ${PROJECT_VERSION} ${PROJECT_SOURCE_DIR})
