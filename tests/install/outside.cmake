# The example as its README has it: configured, built and run against the prefix.
set(outside ${CMAKE_CURRENT_BINARY_DIR}/outside)
set(equal ${CMAKE_CURRENT_BINARY_DIR}/equal_model)
function(articam_add_outside_project name source folder)
  articam_add_prefix_test(${name}IsConfigured ${CMAKE_COMMAND} -S ${source} -B ${folder} ${common} ${ARGN})
  add_test(NAME ${name}IsBuilt COMMAND ${CMAKE_COMMAND} --build ${folder})
  set_tests_properties(${name}IsConfigured PROPERTIES FIXTURES_SETUP ${name}_configured)
  set_tests_properties(${name}IsBuilt PROPERTIES
    FIXTURES_REQUIRED "articam_prefix;${name}_configured" FIXTURES_SETUP ${name})
endfunction()
articam_add_outside_project(Outside.Project ${example} ${outside})
articam_add_outside_project(Outside.EqualModel ${CMAKE_CURRENT_SOURCE_DIR}/equal_model ${equal}
  -DARTICAM_STATIC_MODELS_FOLDER=${PROJECT_SOURCE_DIR}/static_models
  -Darticam_DIR=${prefix}.linked/${CMAKE_INSTALL_LIBDIR}/cmake/articam)
set(ours ${CMAKE_CURRENT_BINARY_DIR}/our_model)
articam_add_outside_project(Outside.OurModel ${CMAKE_CURRENT_SOURCE_DIR}/our_model ${ours})
add_test(NAME Outside.ArticamAsASubdirectoryHasTheSameNames COMMAND ${CMAKE_COMMAND}
  -S ${CMAKE_CURRENT_SOURCE_DIR}/subdirectory -B ${CMAKE_CURRENT_BINARY_DIR}/subdirectory -G ${CMAKE_GENERATOR}
  -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DFETCHCONTENT_SOURCE_DIR_ARTICAM=${PROJECT_SOURCE_DIR})

function(articam_add_outside_test name project expected)
  add_test(NAME Outside.${name} COMMAND ${ARGN})
  set_tests_properties(Outside.${name} PROPERTIES
    FIXTURES_REQUIRED Outside.${project} PASS_REGULAR_EXPRESSION "${expected}")
endfunction()
add_test(NAME Outside.TheTrackerFollowsTheDoor COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/draw_frames.sh ${outside})
set_tests_properties(Outside.TheTrackerFollowsTheDoor PROPERTIES
  FIXTURES_REQUIRED Outside.Project FIXTURES_SETUP Outside.Frames)
add_test(NAME Outside.TheBoardsProgramTracksTheSameFrames
  COMMAND ${outside}/cupboard_board --camera replay:${outside}/frames --rate 60 --frames 60 --priority 0 --link stdout)
set_tests_properties(Outside.TheBoardsProgramTracksTheSameFrames PROPERTIES
  FIXTURES_REQUIRED Outside.Frames PASS_REGULAR_EXPRESSION "\n[0-9]+,[^\n]*,tracking,none,")
articam_add_outside_test(TheReportIsWrittenWithTheModel Project "cupboard: what its marks will tell"
  ${CMAKE_COMMAND} -E cat ${outside}/cupboard_report.txt)
articam_add_outside_test(TheProbeTellsArticamsVersion Project "^cupboard_probe .articam ${PROJECT_VERSION}.\n$"
  ${outside}/cupboard_probe --version)
articam_add_outside_test(TheReportIsJsonWhereItsNameSaysSo EqualModel "\"model\": \"printer_drawer\""
  ${CMAKE_COMMAND} -E cat ${equal}/reports/printer.json)
articam_add_outside_test(ABoardsProgramForOurModelTakesItsTrackerFromTheFirmware
  OurModel "'PrinterDrawer' from the camera" ${ours}/printer_board --help)
add_test(NAME Outside.TheProbeOfAnEqualModelSaysTheSame
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/same_answers.sh
    "${prefix}/bin/articam-probe printer_drawer" ${equal}/printer_probe)
set_tests_properties(Outside.TheProbeOfAnEqualModelSaysTheSame PROPERTIES FIXTURES_REQUIRED Outside.EqualModel)
