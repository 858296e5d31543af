# The packages of cpack, where Debian's tools are.
foreach(program dpkg-deb dpkg-shlibdeps file gzip)
  find_program(ARTICAM_PROGRAM_${program} ${program})
  if(NOT ARTICAM_PROGRAM_${program})
    message(STATUS "The Debian packages are not tested: no ${program} (packages dpkg-dev, file)")
    return()
  endif()
endforeach()
add_test(NAME Debian.TwoPackagesHoldWhatTheyShouldAndAreTheSameTwice
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/debian_packages.sh ${CMAKE_CPACK_COMMAND} ${PROJECT_BINARY_DIR}
    ${CMAKE_CURRENT_BINARY_DIR}/packages ${PROJECT_VERSION} ${PROJECT_SOURCE_DIR})
