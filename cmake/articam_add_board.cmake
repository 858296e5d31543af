# articam_add_board(name MODEL Model CAMERA Camera)
#
# The board's program for one model and one camera, of articam_add_model and articam_add_camera, or of our
# static_models. Cross-compiled like any program; `name --help` teaches its options.
function(articam_add_board name)
  cmake_parse_arguments(arg "" "MODEL;CAMERA" "" ${ARGN})
  articam_check_call(articam_add_board ${name} MODEL CAMERA)
  articam_need_component("articam_add_board(${name}):" board)
  articam_use_table("articam_add_board(${name}):" model ${arg_MODEL})
  articam_use_table("articam_add_board(${name}):" camera ${arg_CAMERA})

  # Of our own models the trackers are compiled already.
  get_target_property(trackers articam::models::${model} ARTICAM_TRACKERS)
  set(trackers_header core/tracker/tracker.hpp)
  set(libraries articam::models::${model} articam::cameras::${camera} articam::board)
  if(trackers)
    set(trackers_header hal/firmware.hpp)
    list(APPEND libraries ${trackers})
  endif()

  set(main ${CMAKE_CURRENT_BINARY_DIR}/${name}_main.cpp)
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/board_main.cpp.in ${main} @ONLY)
  add_executable(${name} ${main})
  target_link_libraries(${name} PRIVATE ${libraries})
endfunction()
