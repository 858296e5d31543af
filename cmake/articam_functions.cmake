# Everything that a project calls, in a build of articam and from an installed one alike.
foreach(file articam_snake_case articam_table articam_add_model articam_add_camera articam_add_probe articam_add_board)
  include(${CMAKE_CURRENT_LIST_DIR}/${file}.cmake)
endforeach()
