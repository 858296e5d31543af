# articam_add_probe(name MODEL Model)
#
# A program like articam-probe, for one model: of articam_add_model, or of our static_models. It prints where the
# markers are, and their Jacobians, for joint values on its standard input; `name --help` has an example.
function(articam_add_probe name)
  cmake_parse_arguments(arg "" "MODEL" "" ${ARGN})
  articam_check_call(articam_add_probe ${name} MODEL)
  articam_need_component("articam_add_probe(${name}):" probe)
  articam_use_table("articam_add_probe(${name}):" model ${arg_MODEL})

  set(main ${CMAKE_CURRENT_BINARY_DIR}/${name}_main.cpp)
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/probe_main.cpp.in ${main} @ONLY)
  add_executable(${name} ${main})
  target_link_libraries(${name} PRIVATE articam::models::${model} articam::probe)
endfunction()
