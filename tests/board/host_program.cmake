# articam_add_host_program(NAME SOURCES f.cpp ... [FLAGS ...] [SUFFIX .so]): in a cross build, a program for this very
# machine, by its own compiler. Sets the variable NAME to its path. Programs with core in them compute the board's bits.
find_program(ARTICAM_HOST_CXX NAMES g++ c++ clang++ REQUIRED
  DOC "Compiler for this machine, for the programs that watch the board")
get_target_property(eigen_include Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)

function(articam_add_host_program name)
  cmake_parse_arguments(arg "" "SUFFIX" "SOURCES;FLAGS" ${ARGN})
  set(program ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${name}${arg_SUFFIX})
  file(MAKE_DIRECTORY ${CMAKE_RUNTIME_OUTPUT_DIRECTORY})
  list(TRANSFORM arg_SOURCES PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  add_custom_command(OUTPUT ${program} DEPENDS ${arg_SOURCES} DEPFILE ${CMAKE_CURRENT_BINARY_DIR}/${name}.d
    COMMAND ${ARTICAM_HOST_CXX} -std=c++20 -O2 -Wall -Wextra -Werror -ffp-contract=off -DEIGEN_DONT_VECTORIZE
      -I${PROJECT_SOURCE_DIR} -isystem ${eigen_include} ${arg_FLAGS} -MD -MF ${CMAKE_CURRENT_BINARY_DIR}/${name}.d
      ${arg_SOURCES} -o ${program}
    COMMENT "Building ${name} for this machine" VERBATIM)
  add_custom_target(${name} ALL DEPENDS ${program})
  set(${name} ${program} PARENT_SCOPE)
endfunction()
