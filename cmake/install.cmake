# What `cmake --install` writes: component `tools` are the programs of this machine, component `dev` is what
# find_package(articam) finds. Headers keep their names from the root, so they lie in a folder of their own.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/articam)

foreach(program board detect listen markers modelgen probe replay sim)
  if(TARGET articam-${program})
    install(TARGETS articam-${program} RUNTIME COMPONENT tools)
  endif()
endforeach()

# articam_export(component target...): what find_package(articam COMPONENTS component) gives; core always.
function(articam_export component)
  foreach(target IN LISTS ARGN)
    if(NOT TARGET ${target})
      continue()
    endif()
    string(REGEX REPLACE "^articam_" "" name ${target})
    string(REGEX REPLACE "^(models|cameras)_" "\\1::" name ${name})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name}
      EXPORT_PROPERTIES "ARTICAM_VERSION;ARTICAM_HEADER;ARTICAM_NAME;ARTICAM_TRACKERS")
    install(TARGETS ${target} EXPORT articam_${component}
      ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
      FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/articam COMPONENT dev)
    set_property(GLOBAL APPEND PROPERTY ARTICAM_INSTALLED_TARGETS ${target})
  endforeach()
  install(EXPORT articam_${component} NAMESPACE articam:: DESTINATION ${package} COMPONENT dev)
endfunction()

set(names ${ARTICAM_STATIC_MODELS} ${ARTICAM_STATIC_CAMERAS})
list(TRANSFORM names REPLACE ":.*" "")
set(static_names ${names})
list(TRANSFORM static_names PREPEND articam_models_)
list(TRANSFORM names PREPEND articam_cameras_)
articam_export(core articam_strict articam_core articam_ports articam_wire)
articam_export(static_models articam_static_models articam_firmware ${static_names} ${names})
if(TARGET articam_probe)
  articam_export(probe articam_probe)
endif()
if(TARGET articam_receiver)
  articam_export(receiver articam_lines articam_receiver)
endif()
if(TARGET articam_board)
  articam_export(board articam_authentication articam_board articam_libcamera articam_libcamera_seam articam_link
    articam_packet_link articam_pgm articam_posix articam_record articam_supervision articam_systemd articam_v4l2
    articam_wire_nanopb)
endif()

set(ARTICAM_LIBCAMERA_MODULE "")
if(TARGET articam_libcamera)
  set(ARTICAM_LIBCAMERA_MODULE libcamera)
endif()
file(RELATIVE_PATH ARTICAM_TO_BIN ${CMAKE_INSTALL_FULL_LIBDIR}/cmake/articam ${CMAKE_INSTALL_FULL_BINDIR})
configure_package_config_file(cmake/articamConfig.cmake.in ${PROJECT_BINARY_DIR}/articamConfig.cmake
  INSTALL_DESTINATION ${package})
# Before 1.0 a minor version may change what a caller writes.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/articamConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/articamConfig.cmake
  ${PROJECT_BINARY_DIR}/articamConfigVersion.cmake
  cmake/articam_add_board.cmake
  cmake/articam_add_camera.cmake
  cmake/articam_add_model.cmake
  cmake/articam_add_probe.cmake
  cmake/articam_functions.cmake
  cmake/articam_snake_case.cmake
  cmake/articam_table.cmake
  cmake/board_main.cpp.in
  cmake/probe_main.cpp.in
  DESTINATION ${package} COMPONENT dev)
install(FILES hal/wire/articam.proto hal/wire/articam.options hal/app/board/articam-board.service
  DESTINATION ${CMAKE_INSTALL_DATADIR}/articam COMPONENT dev)
install(FILES README.md LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/articam-dev COMPONENT dev)
install(DIRECTORY examples/outside_project DESTINATION ${CMAKE_INSTALL_DATADIR}/articam/examples COMPONENT dev)
