# articam_add_camera(Name YAML f.yaml)
#
# Compiles a camera's ROS calibration at build time. `target_link_libraries(app PRIVATE articam::cameras::Name)` gives,
# for a Name such as FrontLeft,
#     #include "cameras/front_left.hpp"      // articam::cameras::kFrontLeft
# The path is relative to the calling folder.
function(articam_add_camera name)
  cmake_parse_arguments(arg "" "YAML" "" ${ARGN})
  set(usage "articam_add_camera(${name}):")
  if(NOT name MATCHES "^[A-Z][A-Za-z0-9]*$")
    message(FATAL_ERROR "${usage} the name must be CamelCase letters and digits")
  endif()
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${usage} unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_YAML)
    message(FATAL_ERROR "${usage} YAML is missing")
  endif()
  cmake_path(ABSOLUTE_PATH arg_YAML NORMALIZE)

  articam_snake_case(${name} snake)
  set(root ${CMAKE_CURRENT_BINARY_DIR}/articam_cameras/${name})
  set(header ${root}/cameras/${snake}.hpp)
  file(MAKE_DIRECTORY ${root}/cameras)
  add_custom_command(
    OUTPUT ${header}
    COMMAND articam-modelgen --camera ${arg_YAML} --name ${name} -o ${header}
    DEPENDS ${arg_YAML} articam-modelgen
    COMMENT "Compiling the camera ${name}"
    VERBATIM)
  add_custom_target(articam_camera_${name} DEPENDS ${header})

  add_library(articam_cameras_${name} INTERFACE)
  add_library(articam::cameras::${name} ALIAS articam_cameras_${name})
  add_dependencies(articam_cameras_${name} articam_camera_${name})
  set_target_properties(articam_cameras_${name} PROPERTIES
    ARTICAM_HEADER cameras/${snake}.hpp ARTICAM_NAME articam::cameras::k${name})
  target_include_directories(articam_cameras_${name} INTERFACE ${root})
  target_link_libraries(articam_cameras_${name} INTERFACE articam::core)
endfunction()
