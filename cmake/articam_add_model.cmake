# articam_add_model(Name URDF f.urdf [MARKERS f.yaml] [ROOT link] [FREEZE joint=value ...]
#                   [POI name=link:x,y,z ...])
#
# Compiles a URDF at build time. `target_link_libraries(app PRIVATE articam::models::Name)` gives, for a
# Name such as KitchenDoor,
#     #include "models/kitchen_door.hpp"      // struct articam::models::KitchenDoor
# Paths are relative to the calling folder. REPORT f is reserved and refused for now.
function(articam_add_model name)
  cmake_parse_arguments(arg "" "URDF;MARKERS;ROOT;REPORT" "FREEZE;POI" ${ARGN})
  set(usage "articam_add_model(${name}):")
  if(NOT name MATCHES "^[A-Z][A-Za-z0-9]*$")
    message(FATAL_ERROR "${usage} the name must be CamelCase letters and digits")
  endif()
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "${usage} unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(arg_REPORT)
    message(FATAL_ERROR "${usage} REPORT is not supported yet")
  endif()
  if(NOT arg_URDF)
    message(FATAL_ERROR "${usage} URDF is missing")
  endif()

  cmake_path(ABSOLUTE_PATH arg_URDF NORMALIZE)
  set(inputs ${arg_URDF})
  set(options --urdf ${arg_URDF} --name ${name})
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

  articam_snake_case(${name} snake)
  set(root ${CMAKE_CURRENT_BINARY_DIR}/articam_models/${name})  # of its own: a target sees only its models
  set(header ${root}/models/${snake}.hpp)
  file(MAKE_DIRECTORY ${root}/models)
  add_custom_command(
    OUTPUT ${header}
    COMMAND articam-modelgen ${options} -o ${header}
    DEPENDS ${inputs} articam-modelgen
    COMMENT "Compiling the model ${name}"
    VERBATIM)
  add_custom_target(articam_model_${name} DEPENDS ${header})

  add_library(articam_models_${name} INTERFACE)
  add_library(articam::models::${name} ALIAS articam_models_${name})
  add_dependencies(articam_models_${name} articam_model_${name})
  set_target_properties(articam_models_${name} PROPERTIES
    ARTICAM_HEADER models/${snake}.hpp ARTICAM_NAME articam::models::${name})
  target_include_directories(articam_models_${name} INTERFACE ${root})
  target_link_libraries(articam_models_${name} INTERFACE articam::core)
endfunction()
