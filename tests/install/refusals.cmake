# Wrong calls end the configuration with a message that mends them. CMake folds its messages: a blank is any white
# space.
function(articam_add_refusal name call expected)
  set(test Outside.Refuses${name})
  articam_add_prefix_test(${test} ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_SOURCE_DIR}/refused
    -B ${CMAKE_CURRENT_BINARY_DIR}/refused/${name} -G ${CMAKE_GENERATOR} "-DCALL=${call}"
    -Darticam_DIR=${prefix}/${CMAKE_INSTALL_LIBDIR}/cmake/articam ${ARGN})
  string(REPLACE " " "[ \n]+" expected "${expected}")
  set_tests_properties(${test} PROPERTIES PASS_REGULAR_EXPRESSION "CMake Error.*${expected}")
endfunction()
set(urdf ${example}/cupboard.urdf)
articam_add_refusal(ANameThatIsNoType "articam_add_model(my_door URDF ${urdf})"
  "articam_add_model.my_door.: the name must be CamelCase")
articam_add_refusal(ACameraWithoutAFile "articam_add_camera(Front)" "articam_add_camera.Front.: YAML is missing")
articam_add_refusal(AFileThatIsNotThere "articam_add_camera(Front YAML no.yaml)" "there is no [^ ]*/no.yaml")
articam_add_refusal(AnUnknownWord "articam_add_model(Door URDF ${urdf} POIS x)" "unknown arguments: POIS;x")
articam_add_refusal(AWordWithoutItsValue "articam_add_model(Door URDF ${urdf} REPORT)" "REPORT has no value")
articam_add_refusal(AModelThatNobodyAdded "articam_add_probe(p MODEL Door)"
  "no model 'Door'; articam_add_model makes one")
articam_add_refusal(AComponentThatWasNotAskedFor "articam_add_board(b MODEL A CAMERA B)"
  "there is no articam::board. find_package.articam COMPONENTS board. gives it")

# The generator of a cross build is the host's: it must run there, and be of the same version.
set(other ${CMAKE_CURRENT_BINARY_DIR}/other_version/articam-modelgen)
file(CONFIGURE OUTPUT ${other} CONTENT "#!/bin/sh\necho articam-modelgen 0.0.9\n" @ONLY)
file(CHMOD ${other} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
articam_add_refusal(AGeneratorOfAnotherVersion "articam_add_model(Door URDF ${urdf})"
  "says 'articam-modelgen 0.0.9', the libraries are ${PROJECT_VERSION}. Install articam ${PROJECT_VERSION}"
  -DARTICAM_MODELGEN=${other})
articam_add_refusal(AGeneratorThatDoesNotRun "articam_add_model(Door URDF ${urdf})"
  "does not run on this machine" -DARTICAM_MODELGEN=${prefix}/${CMAKE_INSTALL_LIBDIR}/libarticam_core.a)
