# articam_add_model(Name URDF f.urdf [MARKERS f.yaml] [ROOT link] [FREEZE joint=value ...]
#                   [POI name=link:x,y,z ...] [REPORT f.txt|f.json])
#
# Compiles a URDF at build time. `target_link_libraries(app PRIVATE articam::models::Name)` gives, for a
# Name such as KitchenDoor,
#     #include "models/kitchen_door.hpp"      // struct articam::models::KitchenDoor
# Paths are relative to the calling folder, REPORT to its build folder: what the marks will and will not observe, and
# how well; JSON where the name ends in .json.
function(articam_add_model name)
  cmake_parse_arguments(arg "" "URDF;MARKERS;ROOT;REPORT" "FREEZE;POI" ${ARGN})
  articam_check_call(articam_add_model ${name} URDF)

  cmake_path(ABSOLUTE_PATH arg_URDF NORMALIZE)
  set(inputs ${arg_URDF})
  set(options --urdf ${arg_URDF})
  if(arg_MARKERS)
    cmake_path(ABSOLUTE_PATH arg_MARKERS NORMALIZE)
    list(APPEND inputs ${arg_MARKERS})
    list(APPEND options --markers ${arg_MARKERS})
  endif()
  if(arg_ROOT)
    list(APPEND options --root ${arg_ROOT})
  endif()
  foreach(freeze IN LISTS arg_FREEZE)
    list(APPEND options --freeze ${freeze})
  endforeach()
  foreach(point IN LISTS arg_POI)
    list(APPEND options --poi ${point})
  endforeach()
  if(arg_REPORT)
    cmake_path(ABSOLUTE_PATH arg_REPORT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE)
    cmake_path(GET arg_REPORT PARENT_PATH folder)
    file(MAKE_DIRECTORY ${folder})
    list(APPEND options --report ${arg_REPORT})
  endif()
  articam_add_table(model ${name} SYMBOL articam::models::${name}
    INPUTS ${inputs} OPTIONS ${options} BYPRODUCTS ${arg_REPORT})
endfunction()
