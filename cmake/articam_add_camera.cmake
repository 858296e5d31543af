# articam_add_camera(Name YAML f.yaml)
#
# Compiles a camera's ROS calibration at build time. `target_link_libraries(app PRIVATE articam::cameras::Name)` gives,
# for a Name such as FrontLeft,
#     #include "cameras/front_left.hpp"      // articam::cameras::kFrontLeft
# The path is relative to the calling folder.
function(articam_add_camera name)
  cmake_parse_arguments(arg "" "YAML" "" ${ARGN})
  articam_check_call(articam_add_camera ${name} YAML)
  cmake_path(ABSOLUTE_PATH arg_YAML NORMALIZE)
  articam_add_table(camera ${name} SYMBOL articam::cameras::k${name}
    INPUTS ${arg_YAML} OPTIONS --camera ${arg_YAML})
endfunction()
